// What the processor calls itself.
#pragma once

#include <string>

namespace tessera::backends::reference {

/// The model name of the processor, or its architecture where the system does not tell.
std::string cpu_name();

}  // namespace tessera::backends::reference
