#include "tests/support/raytrace/synthetic_rays.hpp"

namespace tedavis::test_support {

void SyntheticRays::trace(const Ray* rays, std::uint32_t count, Shot* shots) const {
    for (std::uint32_t first = 0; first < count; first += kLanes) {
        float distance[kLanes], x[kLanes];
        const std::uint32_t lanes = count - first < kLanes ? count - first : kLanes;
        for (std::uint32_t n = 0; n < kLanes; ++n) {
            const Ray& ray = rays[first + (n < lanes ? n : 0)];
            x[n] = static_cast<float>(ray.pixel % 977) * 0.001f + static_cast<float>(ray.bounce);
            distance[n] = 0;
        }
        for (int step = 0; step < steps_; ++step)
            for (std::uint32_t n = 0; n < kLanes; ++n) {
                x[n] = x[n] * 0.75f + 0.1f;
                distance[n] += x[n] > 0.5f ? x[n] : 0.25f;
            }
        for (std::uint32_t n = 0; n < lanes; ++n) {
            const Ray& ray = rays[first + n];
            shots[first + n] = {ray.pixel, ray.bounce, ray.light, distance[n]};
        }
    }
}
void SyntheticRays::shade(const Shot* shots, std::uint32_t count, Dot* dots) const {
    for (std::uint32_t n = 0; n < count; ++n) dots[n] = {shots[n].pixel, shots[n].light + 1 / (1 + shots[n].distance)};
}
void SyntheticRays::set_pixels(const Dot* dots, std::uint32_t count) {
    for (std::uint32_t n = 0; n < count; ++n) picture[dots[n].pixel] = dots[n].light;
}
void SyntheticRays::rays_of_tile(std::uint32_t tile, Ray* rays) {
    for (std::uint32_t n = 0; n < kTilePixels; ++n) rays[n] = {tile * kTilePixels + n, 0, 0};
}
bool SyntheticRays::is_mirror(const Shot& shot) const {
    return mirrors != 0 && shot.bounce < 3 && (shot.pixel * 2654435761u >> 8) % mirrors == 0;
}

std::uint32_t SyntheticRays::reflect(const Shot* shots, std::uint32_t count, Ray* rays, Shot* stay) const {
    std::uint32_t reflected = 0, stayed = 0;
    for (std::uint32_t n = 0; n < count; ++n) {
        const Shot shot = shots[n];
        if (is_mirror(shot))
            rays[reflected++] = {shot.pixel, shot.bounce + 1, shot.light + 0.5f / (1 + shot.distance)};
        else
            stay[stayed++] = shot;
    }
    return reflected;
}

}  // namespace tedavis::test_support
