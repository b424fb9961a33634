// What is needed to draw a picture on a quad with OpenGL.
#pragma once

#include <qopengl.h>

namespace suffuse {

/// The headers of OpenGL ES, which Qt may have been built for, do not define this.
inline constexpr GLenum rgba8 = 0x8058;

inline constexpr const char *vertexShader = R"(
attribute highp vec4 corner; // x, y in clip space; u, v in the texture
varying highp vec2 texel;
void main()
{
    texel = corner.zw;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
}
)";

} // namespace suffuse
