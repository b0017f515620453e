#include "backends/reference/cpu_name.hpp"

#include <sys/utsname.h>

#include <fstream>

namespace tessera::backends::reference {

std::string cpu_name() {
    std::ifstream cpus("/proc/cpuinfo");
    for (std::string line; std::getline(cpus, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    utsname system{};
    return uname(&system) == 0 ? system.machine : "CPU";
}

}  // namespace tessera::backends::reference
