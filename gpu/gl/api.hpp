#pragma once

// OpenGL 4.5 core straight from libOpenGL (GLVND): no loader.
#define GL_GLEXT_PROTOTYPES 1
#include <GL/glcorearb.h>
