// An environment variable with another value for a while.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace tessera::test {

class ScopedVariable {
public:
    /// Nothing as `value` takes the variable away.
    ScopedVariable(const char* name, const std::optional<std::string>& value) : name_(name) {
        if (const char* set = std::getenv(name)) before_ = set;
        assign(value);
    }
    ~ScopedVariable() { assign(before_); }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

private:
    void assign(const std::optional<std::string>& value) {
        if (value) {
            ::setenv(name_, value->c_str(), 1);
        } else {
            ::unsetenv(name_);
        }
    }

    const char* name_;
    std::optional<std::string> before_;
};

}  // namespace tessera::test
