// A Markdown document whose conclusions are checked against the figures.
#pragma once

#include <string>
#include <vector>

namespace tessera::findings {

using Rows = std::vector<std::vector<std::string>>;

class Document {
public:
    void title(const std::string& text) { markdown_ += "# " + text + "\n"; }
    void heading(const std::string& text) { block("## " + text); }
    void subheading(const std::string& text) { block("### " + text); }
    void paragraph(const std::string& text);
    /// The first row is the head.
    void table(const Rows& rows);
    /// Shell commands.
    void commands(const std::string& lines) { block("```sh\n" + lines + "\n```"); }
    /// A conclusion, as an item of a list. It is written whether it holds or not; see broken_claims().
    void claim(bool holds, const std::string& sentence);

    const std::string& markdown() const { return markdown_; }
    /// Conclusions that the figures do not bear out: their sentences have to be rewritten.
    const std::vector<std::string>& broken_claims() const { return broken_; }

private:
    void block(const std::string& text);

    std::string markdown_;
    std::vector<std::string> broken_;
    bool in_list_ = false;
};

}  // namespace tessera::findings
