// How the readers of one file speak: an error names file and element, a message tells what was skipped or repaired.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tessera::scene {

/// Text from a file made fit for a terminal: control and non-ASCII bytes as \xNN, cut after `longest` bytes, in double
/// quotes.
std::string in_quotes(std::string_view text, std::size_t longest = 80);

class Diagnostics {
public:
    /// Messages beyond this many are only counted.
    static constexpr std::size_t message_limit = 64;

    explicit Diagnostics(std::string file) : file_(std::move(file)) {}

    const std::string& file() const { return file_; }

    /// Throws Error(usage) with "<file>: <element> <reason>.".
    [[noreturn]] void refuse(const std::string& element, const std::string& reason) const;

    /// Keeps a sentence for the user; a sentence that is there already is not repeated.
    void note(std::string sentence);

    /// The messages so far, with a last one that tells how many were left out.
    std::vector<std::string> take_messages();

private:
    std::string file_;
    std::vector<std::string> messages_;
    std::size_t left_out_ = 0;
};

}  // namespace tessera::scene
