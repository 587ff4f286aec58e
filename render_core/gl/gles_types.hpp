/// The GLES types and constants, without prototypes: a direct gl* call does not compile.
#pragma once

#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>
// after gl3.h, which it builds upon
#include <GLES2/gl2ext.h>
