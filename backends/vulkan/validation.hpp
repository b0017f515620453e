// The Khronos validation layer, on request: TESSERA_VALIDATION=1 in the environment turns it on, with
// synchronisation validation, for every Vulkan instance made afterwards. Every warning and error is collected here.
#pragma once

#include <string>
#include <vector>

namespace tessera::backends::vulkan {

/// True where TESSERA_VALIDATION is set to something other than "0".
bool validation_wanted();

/// True while an instance with the validation layer lives in this process.
bool validation_active();

/// All messages since the last call, oldest first. Safe from any thread.
std::vector<std::string> take_validation_messages();

}  // namespace tessera::backends::vulkan
