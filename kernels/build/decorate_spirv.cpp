// decorate_spirv IN.spv OUT.spv: decorates every float operation of a SPIR-V module NoContraction, and refuses a module
// that breaks the exactness law (a float division, a square root, any other inexact instruction).
//
// GLSL's `precise` does not reach called functions, so the decoration is done here. SPIR-V 1.x layout: a header of five
// words, then instructions whose first word is (length << 16 | opcode); decorations lie in one section before the
// first type declaration.
#include <glslang/SPIRV/GLSL.std.450.h>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <glslang/SPIRV/spirv.hpp>
#include <iterator>
#include <string>
#include <vector>

namespace {

using Words = std::vector<std::uint32_t>;

bool is_float_arithmetic(spv::Op op) {
    return op == spv::OpFNegate || op == spv::OpFAdd || op == spv::OpFSub || op == spv::OpFMul;
}

/// The name of a float instruction that has no single correctly rounded result on every device, or null.
const char* inexact_instruction(spv::Op op) {
    switch (op) {
        case spv::OpFDiv:
            return "OpFDiv";
        case spv::OpFRem:
            return "OpFRem";
        case spv::OpFMod:
            return "OpFMod";
        case spv::OpDot:
            return "OpDot";
        case spv::OpVectorTimesScalar:
            return "OpVectorTimesScalar";
        case spv::OpMatrixTimesVector:
            return "OpMatrixTimesVector";
        case spv::OpMatrixTimesMatrix:
            return "OpMatrixTimesMatrix";
        case spv::OpConvertFToU:
            return "OpConvertFToU";
        case spv::OpConvertFToS:
            return "OpConvertFToS";
        default:
            return nullptr;
    }
}

/// Integer-only instructions of the GLSL extended set; every other one is refused.
bool is_exact_extended(std::uint32_t instruction) {
    switch (instruction) {
        case GLSLstd450UMin:
        case GLSLstd450UMax:
        case GLSLstd450UClamp:
        case GLSLstd450SMin:
        case GLSLstd450SMax:
        case GLSLstd450FindUMsb:
        case GLSLstd450FindILsb:
            return true;
        default:
            return false;
    }
}

Words read_words(const char* path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    Words words(bytes.size() / 4);
    std::copy(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(words.size() * 4),
              reinterpret_cast<char*>(words.data()));
    return words;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: decorate_spirv IN.spv OUT.spv\n");
        return 2;
    }
    const Words module = read_words(argv[1]);
    if (module.size() < 5 || module[0] != spv::MagicNumber) {
        std::fprintf(stderr, "decorate_spirv: %s is not a SPIR-V module\n", argv[1]);
        return 2;
    }
    std::vector<std::uint32_t> results;
    std::size_t first_type = 0;
    for (std::size_t at = 5; at < module.size();) {
        const std::uint32_t length = module[at] >> 16;
        const auto op = static_cast<spv::Op>(module[at] & 0xffffu);
        if (length == 0 || at + length > module.size()) {
            std::fprintf(stderr, "decorate_spirv: %s is cut at word %zu\n", argv[1], at);
            return 2;
        }
        if (const char* name = inexact_instruction(op)) {
            std::fprintf(stderr, "decorate_spirv: %s uses %s, which devices round differently; see kernels/exact.h\n",
                         argv[1], name);
            return 1;
        }
        if (op == spv::OpExtInst && !is_exact_extended(module[at + 4])) {
            std::fprintf(stderr, "decorate_spirv: %s uses the inexact GLSL.std.450 instruction %u\n", argv[1],
                         module[at + 4]);
            return 1;
        }
        if (is_float_arithmetic(op)) {
            results.push_back(module[at + 2]);
        }
        if (first_type == 0 && op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer) {
            first_type = at;
        }
        at += length;
    }
    Words output(module.begin(), module.begin() + static_cast<std::ptrdiff_t>(first_type));
    for (const std::uint32_t id : results) {
        output.insert(output.end(), {3u << 16 | spv::OpDecorate, id, spv::DecorationNoContraction});
    }
    output.insert(output.end(), module.begin() + static_cast<std::ptrdiff_t>(first_type), module.end());

    std::ofstream file(argv[2], std::ios::binary);
    file.write(reinterpret_cast<const char*>(output.data()), static_cast<std::streamsize>(output.size() * 4));
    return file.good() ? 0 : 4;
}
