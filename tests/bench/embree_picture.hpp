/// A picture of primary rays by Embree: t of every pixel, generation of the rays included, in packets of neighbours.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "render_core/base/ports/workers.hpp"
#include "tests/support/raytrace/embree_grid.hpp"
#include "tests/support/raytrace/trace_cameras.hpp"

#if defined(__x86_64__)
#define TEDAVIS_BENCH_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define TEDAVIS_BENCH_CLONES
#endif

namespace tedavis::bench {

/// What Embree's manual asks for: no denormals.
inline void flush_denormals() {
#if defined(__x86_64__)
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

/// Of rays in lanes, as Embree lays them out: arrays of `width` numbers each.
template <int width>
struct EmbreePacket;
template <>
struct EmbreePacket<4> {
    static constexpr std::uint32_t kAcross = 2, kDown = 2;
    using Rays = RTCRayHit4;
    static void trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays) {
        rtcIntersect4(valid, scene, context, rays);
    }
};
template <>
struct EmbreePacket<8> {
    static constexpr std::uint32_t kAcross = 4, kDown = 2;
    using Rays = RTCRayHit8;
    static void trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays) {
        rtcIntersect8(valid, scene, context, rays);
    }
};
template <>
struct EmbreePacket<16> {
    static constexpr std::uint32_t kAcross = 4, kDown = 4;
    using Rays = RTCRayHit16;
    static void trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays) {
        rtcIntersect16(valid, scene, context, rays);
    }
};

/// The camera in the numbers that rays are made of.
struct PacketCamera {
    float eye[3], corner[3], right[3], down[3];
    explicit PacketCamera(const test_support::TraceCamera& camera) {
        for (int n = 0; n < 3; ++n) {
            eye[n] = static_cast<float>(camera.eye[n]);
            corner[n] = static_cast<float>(camera.corner[n]);
            right[n] = static_cast<float>(camera.right[n]);
            down[n] = static_cast<float>(camera.down[n]);
        }
    }
};

/// One coordinate of the directions, as GridCamera::ray() makes them, of `count` pixels with their middles at x and y.
TEDAVIS_BENCH_CLONES inline void make_directions(float corner, float right, float down, const float* __restrict x,
                                                 const float* __restrict y, int count, float* __restrict direction) {
    for (int n = 0; n < count; ++n) direction[n] = (corner + right * x[n]) + down * y[n];
}

class EmbreePicture {
public:
    EmbreePicture(const test_support::EmbreeGrid& grid, const test_support::TraceCamera& camera, std::vector<float>& t)
        : scene_(grid.scene()), camera_(camera), packet_camera_(camera), t_(t) {}

    /// 1, 4, 8 or 16 rays at a time, all marked as coherent.
    void draw(int lanes, base::Workers& workers) {
        lanes_ = lanes;
        workers.parallel_for(
            camera_.height / kBand,
            [](void* self, std::uint32_t band) { static_cast<EmbreePicture*>(self)->draw_band(band * kBand); }, this);
    }

private:
    static constexpr std::uint32_t kBand = 8;  // rows; pictures are a multiple of it high and of 4 wide

    void draw_band(std::uint32_t first) {
        flush_denormals();
        if (lanes_ == 1) return draw_single(first);
        if (lanes_ == 4) return draw_packets<4>(first);
        lanes_ == 8 ? draw_packets<8>(first) : draw_packets<16>(first);
    }
    static RTCIntersectContext coherent() {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        return context;
    }
    void draw_single(std::uint32_t first) {
        RTCIntersectContext context = coherent();
        RTCRayHit ray{};
        for (std::uint32_t y = first; y < first + kBand; ++y) {
            for (std::uint32_t x = 0; x < camera_.width; ++x) {
                const glm::vec3 direction = camera_.ray(x, y).direction;
                ray.ray.org_x = packet_camera_.eye[0];
                ray.ray.org_y = packet_camera_.eye[1];
                ray.ray.org_z = packet_camera_.eye[2];
                ray.ray.tnear = 0;
                ray.ray.dir_x = direction.x;
                ray.ray.dir_y = direction.y;
                ray.ray.dir_z = direction.z;
                ray.ray.tfar = std::numeric_limits<float>::infinity();
                ray.ray.mask = ~0u;
                ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(scene_, &context, &ray);
                t_[std::size_t{y} * camera_.width + x] = ray.ray.tfar;
            }
        }
    }
    template <int width>
    void draw_packets(std::uint32_t first) {
        using Packet = EmbreePacket<width>;
        RTCIntersectContext context = coherent();
        alignas(64) typename Packet::Rays rays{};
        alignas(64) int valid[width];
        alignas(64) float px[width], py[width];
        for (int n = 0; n < width; ++n) {
            valid[n] = -1;
            rays.ray.mask[n] = ~0u;
            rays.ray.org_x[n] = packet_camera_.eye[0];
            rays.ray.org_y[n] = packet_camera_.eye[1];
            rays.ray.org_z[n] = packet_camera_.eye[2];
        }
        float* const directions[3] = {rays.ray.dir_x, rays.ray.dir_y, rays.ray.dir_z};
        for (std::uint32_t y = first; y < first + kBand; y += Packet::kDown) {
            for (std::uint32_t x = 0; x < camera_.width; x += Packet::kAcross) {
                for (unsigned n = 0; n < width; ++n) {
                    px[n] = static_cast<float>(x + n % Packet::kAcross) + 0.5F;
                    py[n] = static_cast<float>(y + n / Packet::kAcross) + 0.5F;
                    rays.hit.geomID[n] = RTC_INVALID_GEOMETRY_ID;
                    rays.ray.tfar[n] = std::numeric_limits<float>::infinity();
                }
                for (int axis = 0; axis < 3; ++axis)
                    make_directions(packet_camera_.corner[axis], packet_camera_.right[axis], packet_camera_.down[axis], px, py,
                                    width, directions[axis]);
                Packet::trace(valid, scene_, &context, &rays);
                for (unsigned n = 0; n < width; ++n)
                    t_[std::size_t{y + n / Packet::kAcross} * camera_.width + x + n % Packet::kAcross] = rays.ray.tfar[n];
            }
        }
    }

    RTCScene scene_;
    const test_support::TraceCamera& camera_;
    PacketCamera packet_camera_;
    std::vector<float>& t_;
    int lanes_ = 16;
};

}  // namespace tedavis::bench
