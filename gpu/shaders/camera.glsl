// Rational Brown-Conrady projection; twin of calib::distort.
vec2 distortRay(vec2 ray, vec4 radial, vec4 rational) {
    float r2 = dot(ray, ray);
    float factor = (1.0 + r2 * (radial.x + r2 * (radial.y + r2 * radial.z))) /
                   (1.0 + r2 * (rational.x + r2 * (rational.y + r2 * rational.z)));
    float p1 = radial.w, p2 = rational.w, xy = ray.x * ray.y;
    return ray * factor + vec2(2.0 * p1 * xy + p2 * (r2 + 2.0 * ray.x * ray.x),
                               p1 * (r2 + 2.0 * ray.y * ray.y) + 2.0 * p2 * xy);
}

// Pixel (centres at integers) -> texture coordinate; row 0 of the image is t = 0.
vec2 textureFromPixel(vec2 pixel, vec2 size) { return (pixel + 0.5) / size; }
