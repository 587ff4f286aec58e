#include "tests/support/raytrace/embree_grid.hpp"

#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>

namespace tedavis::test_support {
namespace {

using raytrace::HeightGrid;

bool count_bytes(void* counter, ssize_t bytes, bool /*after*/) {
    __atomic_add_fetch(static_cast<long long*>(counter), bytes, __ATOMIC_RELAXED);
    return true;
}

void set_vertices(RTCGeometry geometry, const HeightGrid<std::int16_t>& posts, float cell_per_step) {
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), std::size_t{posts.columns} * posts.rows));
    for (std::uint32_t row = 0; row < posts.rows; ++row) {
        for (std::uint32_t column = 0; column < posts.columns; ++column, vertex += 3) {
            vertex[0] = static_cast<float>(column);
            vertex[1] = static_cast<float>(row);
            vertex[2] = static_cast<float>(posts.at(column, row)) * cell_per_step;
        }
    }
}

void set_grid(RTCGeometry geometry, const HeightGrid<std::int16_t>& posts) {
    auto* grid =
        static_cast<RTCGrid*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
    *grid = {0, posts.columns, static_cast<unsigned short>(posts.columns), static_cast<unsigned short>(posts.rows)};
}

void set_triangles(RTCGeometry geometry, const HeightGrid<std::int16_t>& posts) {
    const std::size_t cells = std::size_t{posts.columns - 1} * (posts.rows - 1);
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 2 * cells));
    for (std::uint32_t row = 0; row + 1 < posts.rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < posts.columns; ++column, index += 6) {
            const unsigned first = row * posts.columns + column, below = first + posts.columns;
            const unsigned corners[6] = {first, first + 1, below, below + 1, below, first + 1};
            for (int n = 0; n < 6; ++n) index[n] = corners[n];
        }
    }
}

}  // namespace

EmbreeGrid::EmbreeGrid(const HeightGrid<std::int16_t>& posts, float cell_per_step, EmbreeMesh mesh, unsigned threads,
                       const char* instruction_set) {
    std::string settings = "threads=" + std::to_string(threads);
    if (instruction_set != nullptr) settings += std::string(",isa=") + instruction_set;
    device_ = rtcNewDevice(settings.c_str());
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    scene_ = rtcNewScene(device_);
    RTCGeometry geometry =
        rtcNewGeometry(device_, mesh == EmbreeMesh::grid ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
    set_vertices(geometry, posts, cell_per_step);
    mesh == EmbreeMesh::grid ? set_grid(geometry, posts) : set_triangles(geometry, posts);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    build_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot build the scene");
}

EmbreeGrid::~EmbreeGrid() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

float EmbreeGrid::trace(const float (&origin)[3], const float (&direction)[3]) const {
    RTCRayHit ray{};
    ray.ray.org_x = origin[0];
    ray.ray.org_y = origin[1];
    ray.ray.org_z = origin[2];
    ray.ray.dir_x = direction[0];
    ray.ray.dir_y = direction[1];
    ray.ray.dir_z = direction[2];
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : ray.ray.tfar;
}

}  // namespace tedavis::test_support
