#include "measure/float_operations.hpp"

#include "base/error.hpp"

#include <fmt/format.h>
#include <glslang/SPIRV/spirv.hpp>
#include <map>
#include <string>
#include <vector>

namespace tessera::measure {
namespace {

struct Function {
    std::string name;
    std::uint64_t additions = 0;
    std::uint64_t multiplications = 0;
    std::vector<std::uint32_t> calls;  // ids, one for each call
};

struct Module {
    std::map<std::uint32_t, Function> functions;  // by id

    const Function& find(std::string_view name) const {
        for (const auto& [id, function] : functions) {
            if (function.name == name) return function;
        }
        throw Error(ErrorKind::usage, fmt::format("The SPIR-V module has no function named \"{}\".", name));
    }

    // SPIR-V has no recursion.
    FloatOperations inclusive(const Function& function) const {
        FloatOperations sum{function.additions, function.multiplications};
        for (const std::uint32_t id : function.calls) {
            const auto called = functions.find(id);
            if (called == functions.end()) continue;
            FloatOperations inner = inclusive(called->second);
            if (called->second.name == "exact_rsqrt_of_normal" || called->second.name == "exact_reciprocal") {
                (called->second.name == "exact_reciprocal" ? inner.divisions : inner.roots) = 1;
                inner.in_those = inner.total();
            }
            sum = sum + inner;
        }
        return sum;
    }
};

/// A literal string: four characters a word, ended by a zero.
std::string read_string(std::span<const std::uint32_t> words) {
    std::string text;
    for (const std::uint32_t word : words) {
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            const char c = static_cast<char>(word >> shift & 0xffu);
            if (c == '\0') return text;
            text += c;
        }
    }
    return text;
}

// A header of five words, then instructions whose first word is (length << 16 | opcode).
Module parse(std::span<const std::uint32_t> spirv) {
    if (spirv.size() < 5 || spirv[0] != spv::MagicNumber) {
        throw Error(ErrorKind::usage, fmt::format("{} words are no SPIR-V module.", spirv.size()));
    }
    Module module;
    std::map<std::uint32_t, std::string> names;
    Function* inside = nullptr;
    for (std::size_t at = 5; at < spirv.size();) {
        const std::size_t length = spirv[at] >> 16;
        if (length == 0 || length > spirv.size() - at) {
            throw Error(ErrorKind::usage, fmt::format("The SPIR-V module is cut at word {}.", at));
        }
        const std::span<const std::uint32_t> words = spirv.subspan(at, length);
        switch (static_cast<spv::Op>(words[0] & 0xffffu)) {
            case spv::OpName:
                if (length > 2) names[words[1]] = read_string(words.subspan(2));
                break;
            case spv::OpFunction:
                if (length > 2) {
                    inside = &module.functions[words[2]];
                    const std::string& mangled = names[words[2]];
                    inside->name = mangled.substr(0, mangled.find('('));
                }
                break;
            case spv::OpFunctionEnd:
                inside = nullptr;
                break;
            case spv::OpFunctionCall:
                if (inside != nullptr && length > 3) inside->calls.push_back(words[3]);
                break;
            case spv::OpFAdd:
            case spv::OpFSub:
                if (inside != nullptr) ++inside->additions;
                break;
            case spv::OpFMul:
                if (inside != nullptr) ++inside->multiplications;
                break;
            default:
                break;
        }
        at += length;
    }
    if (inside != nullptr) {
        throw Error(ErrorKind::usage, fmt::format("The SPIR-V module ends inside the function {}.", inside->name));
    }
    return module;
}

}  // namespace

FloatOperations operator+(const FloatOperations& a, const FloatOperations& b) {
    return {a.additions + b.additions, a.multiplications + b.multiplications, a.roots + b.roots,
            a.divisions + b.divisions, a.in_those + b.in_those};
}

FloatOperations operator-(const FloatOperations& a, const FloatOperations& b) {
    return {a.additions - b.additions, a.multiplications - b.multiplications, a.roots - b.roots,
            a.divisions - b.divisions, a.in_those - b.in_those};
}

FloatOperations count_float_operations(std::span<const std::uint32_t> spirv, std::string_view function) {
    const Module module = parse(spirv);
    return module.inclusive(module.find(function));
}

}  // namespace tessera::measure
