// The one place where stb is compiled. Its warnings are not ours to mend.

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include "image/stb.hpp"
