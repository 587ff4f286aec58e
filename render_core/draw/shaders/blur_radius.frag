// By how many pixels a place at a distance is blurred, as codes of distances and of radii in alpha: draw/drawers/scene_blur.hpp.
uniform vec3 focus;            // what is sharp begins and ends, m; radius of the blur infinitely far, pixels

// Pixels, negative nearer than the focus. A lens blurs by the difference of reciprocal distances; nearer no more than far beyond.
float blur_of(float code) {
    if (code < 0.5 / 255.0) return 0.0;  // a warning, which is kept out of all this
    if (code > 254.5 / 255.0) return focus.z;
    float distance_m = max(50.0 * (exp2(13.0 * code) - 1.0), 1.0);
    return focus.z * (max(1.0 - focus.y / distance_m, 0.0) - clamp(focus.x / distance_m - 1.0, 0.0, 1.0));
}

float blur_code(float blur_px) { return (128.0 + 127.0 * blur_px / focus.z) / 255.0; }

float coded_blur(float code) { return (code * 255.0 - 128.0) / 127.0 * focus.z; }
