// From the depth camera's rays to the colour camera's picture; needs mesh_block.glsl, camera.glsl.
vec3 inColorCamera(vec2 ray, float z) {
    return (colorFromDepth * vec4(vec3(ray, 1.0) * z, 1.0)).xyz;
}

// In front of the colour camera and inside its model's valid radius.
bool isSeen(vec3 point) {
    return point.z > 0.0 && dot(point.xy, point.xy) <= colorSize.z * point.z * point.z;
}

// Texture coordinate of a point in the colour image.
vec2 sourceOf(vec3 point) {
    vec2 bent = distortRay(point.xy / point.z, colorRadial, colorRational);
    return textureFromPixel(bent * colorPinhole.xy + colorPinhole.zw, colorSize.xy);
}
