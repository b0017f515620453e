// The one exception type of the project, and what an exit code means.
#pragma once

#include <stdexcept>
#include <string>

namespace tessera {

/// What kind of failure an Error is; the value is the exit code of the command line.
enum class ErrorKind {
    usage = 2,               ///< wrong call or unusable input
    device_unavailable = 3,  ///< a device is missing, refused or lost
    output = 4,              ///< a result could not be written
};

/// Carries one full sentence: what failed, where, the offending value, and what to do.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}
    ErrorKind kind() const { return kind_; }

private:
    ErrorKind kind_;
};

}  // namespace tessera
