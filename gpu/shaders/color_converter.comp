#version 450 core
// A camera's bytes -> R, G, B. One of YUYV, UYVY, NV12, GREY, RGB, BGR. Chroma lies beside the left
// one of its pixels and, in NV12, between its two rows, as in MPEG-2; in between it is interpolated.
// MARKS: where it is not the colour that was there, its block of 8 x 8 is marked.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D bytes; // one texel a byte
#ifdef MARKS
layout(rgba8, binding = 0) uniform image2D color;
layout(r8ui, binding = 1) uniform writeonly uimage2D marks;
#else
layout(rgba8, binding = 0) uniform writeonly image2D color;
#endif

layout(std140, binding = 6) uniform ColorBlock {
    vec4 levels;  // black of Y, its gain, that of Cb and Cr
    vec4 weights; // Cr in red, Cb in blue, Cb and Cr in green
};

float byteAt(int x, int y) { return texelFetch(bytes, ivec2(x, y), 0).x; }

vec3 rgbOf(float luma, vec2 chroma) {
    float y = (luma - levels.x) * levels.y;
    vec2 c = (chroma - 128.0 / 255.0) * levels.z;
    return vec3(y + weights.x * c.y, y - weights.z * c.x - weights.w * c.y, y + weights.y * c.x);
}

// Cb and Cr of pair `i` in a row; `last` is that of the last pair.
vec2 chromaAt(int i, int row) {
#if defined(YUYV)
    return vec2(byteAt(4 * i + 1, row), byteAt(4 * i + 3, row));
#elif defined(UYVY)
    return vec2(byteAt(4 * i, row), byteAt(4 * i + 2, row));
#else
    return vec2(byteAt(2 * i, row), byteAt(2 * i + 1, row));
#endif
}

vec2 chromaBeside(ivec2 pixel, int row, int last) {
    vec2 own = chromaAt(pixel.x / 2, row);
    return pixel.x % 2 == 0 ? own : 0.5 * (own + chromaAt(min(pixel.x / 2 + 1, last), row));
}

vec3 convert(ivec2 pixel, ivec2 size) {
#if defined(GREY)
    return vec3(byteAt(pixel.x, pixel.y));
#elif defined(RGB)
    return vec3(byteAt(3 * pixel.x, pixel.y), byteAt(3 * pixel.x + 1, pixel.y),
                byteAt(3 * pixel.x + 2, pixel.y));
#elif defined(BGR)
    return vec3(byteAt(3 * pixel.x + 2, pixel.y), byteAt(3 * pixel.x + 1, pixel.y),
                byteAt(3 * pixel.x, pixel.y));
#elif defined(NV12)
    int last = size.x / 2 - 1, rows = size.y / 2, own = pixel.y / 2;
    int other = clamp(own + (pixel.y % 2) * 2 - 1, 0, rows - 1);
    vec2 chroma = 0.75 * chromaBeside(pixel, size.y + own, last) +
                  0.25 * chromaBeside(pixel, size.y + other, last);
    return rgbOf(byteAt(pixel.x, pixel.y), chroma);
#else
#ifdef UYVY
    float luma = byteAt(2 * pixel.x + 1, pixel.y);
#else
    float luma = byteAt(2 * pixel.x, pixel.y);
#endif
    return rgbOf(luma, chromaBeside(pixel, pixel.y, size.x / 2 - 1));
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(color);
    if (any(greaterThanEqual(pixel, size))) return;
#ifdef MARKS
    vec4 before = imageLoad(color, pixel);
#endif
    imageStore(color, pixel, vec4(clamp(convert(pixel, size), 0.0, 1.0), 1.0));
#ifdef MARKS
    if (imageLoad(color, pixel) != before) imageStore(marks, pixel / 8, uvec4(1u));
#endif
}
