// Vulkan-Hpp with its RAII handles, set up once: no prototypes, because the loader is opened at run time.
#pragma once

#ifndef VK_NO_PROTOTYPES
#define VK_NO_PROTOTYPES
#endif
#define VULKAN_HPP_DISPATCH_LOADER_DYNAMIC 1
// instance.cpp opens the loader itself, so that it can say why that failed.
#define VULKAN_HPP_ENABLE_DYNAMIC_LOADER_TOOL 0

#include <vulkan/vulkan_raii.hpp>
