// embed_kernels OUT.cpp FOLDER PROLOGUE NAME...: writes FOLDER/NAME.spv and FOLDER/NAME.cl of every kernel as C++
// arrays, with one lookup function per form. The OpenCL sources begin with the prologue.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

std::vector<char> read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::fprintf(stderr, "embed_kernels: cannot read %s\n", path.c_str());
        std::exit(2);
    }
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write_spirv(std::FILE* out, const std::string& name, const std::vector<char>& bytes) {
    std::fprintf(out, "const std::uint32_t %s_spirv[] = {", name.c_str());
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
        std::uint32_t word;
        std::memcpy(&word, bytes.data() + at, 4);
        std::fprintf(out, "%s0x%08x,", at % 48 == 0 ? "\n    " : " ", word);
    }
    std::fprintf(out, "\n};\n");
}

// One string literal per line keeps every literal far under the compiler's limit.
void write_source(std::FILE* out, const std::string& name, const std::vector<char>& bytes) {
    std::fprintf(out, "const char %s_opencl[] =\n    \"", name.c_str());
    for (const char c : bytes) {
        if (c == '\n') {
            std::fprintf(out, "\\n\"\n    \"");
        } else if (c == '"' || c == '\\') {
            std::fprintf(out, "\\%c", c);
        } else {
            std::fputc(c, out);
        }
    }
    std::fprintf(out, "\";\n");
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "usage: embed_kernels OUT.cpp FOLDER PROLOGUE NAME...\n");
        return 2;
    }
    std::FILE* out = std::fopen(argv[1], "w");
    if (out == nullptr) {
        std::fprintf(stderr, "embed_kernels: cannot write %s\n", argv[1]);
        return 4;
    }
    std::fprintf(out, "#include \"embedded.hpp\"\n\nnamespace tessera::kernels {\nnamespace {\n\n");
    for (int i = 4; i < argc; ++i) {
        const std::string name = argv[i];
        const std::string stem = std::string(argv[2]) + "/" + name;
        write_spirv(out, name, read_file(stem + ".spv"));
        std::vector<char> source = read_file(argv[3]);
        const std::vector<char> kernel = read_file(stem + ".cl");
        source.insert(source.end(), kernel.begin(), kernel.end());
        write_source(out, name, source);
    }
    std::fprintf(out, "\n}  // namespace\n\nstd::span<const std::uint32_t> embedded_spirv(std::string_view name) {\n");
    for (int i = 4; i < argc; ++i) {
        std::fprintf(out, "    if (name == \"%s\") return %s_spirv;\n", argv[i], argv[i]);
    }
    std::fprintf(out, "    return {};\n}\n\nstd::string_view embedded_opencl(std::string_view name) {\n");
    for (int i = 4; i < argc; ++i) {
        std::fprintf(out, "    if (name == \"%s\") return %s_opencl;\n", argv[i], argv[i]);
    }
    std::fprintf(out, "    return {};\n}\n\n");
    std::fprintf(out, "}  // namespace tessera::kernels\n");
    return std::fclose(out) == 0 ? 0 : 4;
}
