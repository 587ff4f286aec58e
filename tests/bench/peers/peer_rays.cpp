/// Primary rays over the common raster, by Embree (option `embree-grid`, `embree-triangles`) or by our tracer (`own`), on two
/// threads: Embree's packets of 16 neighbours, ours by the widest kernel of the machine. No shading: the depth of each pixel.
/// Option `control` is `own` from an eye that is 10 m too low: every point must be measured 10 m above the surface.
#include <embree3/rtcore_config.h>

#include <memory>

#include "platform/threads/thread_workers.hpp"
#include "tests/bench/embree_picture.hpp"
#include "tests/bench/own_picture.hpp"
#include "tests/bench/peers/peer_loop.hpp"

namespace {

using namespace tedavis;
using test_support::TraceCamera;

constexpr std::uint32_t kThreads = 2;
constexpr double kControl_m = 10;

/// In cells, rows from the north; t is the depth in metres.
TraceCamera camera_of(const peers::Pose& pose, const peers::PictureSize& size) {
    const auto [forward, right, down] = peers::axes_of(pose);
    const double pixel = 1 / size.focal_px();
    const glm::dvec3 corner = forward - right * (0.5 * size.width * pixel) - down * (0.5 * size.height * pixel);
    const glm::dvec3 cell(1 / peers::kSpacing_m, -1 / peers::kSpacing_m, 1 / peers::kSpacing_m);
    const glm::dvec3 eye(pose.x_m, pose.y_m - peers::kExtent_m, pose.z_m);
    return {"pose", eye * cell, corner * cell, right * pixel * cell, down * pixel * cell, size.width, size.height};
}

class Rays {
public:
    explicit Rays(const peers::PeerArguments& given)
        : given_(given),
          ground_(peers::read_ground(given.folder)),
          grid_{ground_.data(), peers::kSide, peers::kSide, peers::kSide},
          bounds_(grid_),
          own_(given.size.width, given.size.height) {
        auto made = platform::make_thread_workers({kThreads, bench::flush_denormals});
        if (!made.ok()) throw std::runtime_error(made.error().message.c_str());
        workers_ = std::move(made.value());
        if (given.option == "own" || given.option == "control") {
            build_ms_ = peers::spent_ms([&] { bounds_.build(*workers_); });
            return;
        }
        const bool is_grid = given.option == "embree-grid";
        embree_ = std::make_unique<test_support::EmbreeGrid>(
            grid_, static_cast<float>(1 / peers::kSpacing_m),
            is_grid ? test_support::EmbreeMesh::grid : test_support::EmbreeMesh::triangles, kThreads);
        build_ms_ = embree_->build_ms();
    }
    [[nodiscard]] std::string ready() const {
        const std::string version = embree_ ? "Embree " RTC_VERSION_STRING : raytrace::view_kernels<std::int16_t>()[0].name;
        return "\"version\": \"" + version + "\", \"build_ms\": " + std::to_string(build_ms_);
    }
    std::string answer(peers::Pose pose) {
        if (given_.option == "control") pose.z_m -= kControl_m;
        const TraceCamera camera = camera_of(pose, given_.size);
        draw(camera);
        const double ms = peers::spent_ms([&] { draw(camera); });
        peers::write_picture(given_.folder + "/rays-" + given_.option + ".depth", own_.t);
        return "\"ms\": [" + std::to_string(ms) + "]";
    }

private:
    void draw(const TraceCamera& camera) {
        if (embree_) return bench::EmbreePicture(*embree_, camera, own_.t).draw(16, *workers_);
        own_.draw(bounds_.field(raytrace::CellSurface::two_triangles), camera.in_steps(peers::kSpacing_m),
                  raytrace::view_kernels<std::int16_t>()[0], *workers_);
    }

    peers::PeerArguments given_;
    std::vector<std::int16_t> ground_;
    raytrace::HeightGrid<std::int16_t> grid_;
    bench::OwnBounds bounds_;
    bench::OwnPicture own_;
    std::unique_ptr<base::Workers> workers_;
    std::unique_ptr<test_support::EmbreeGrid> embree_;
    double build_ms_ = 0;
};

}  // namespace

int main(int count, char** given) {
    return peers::run_peer("peer_rays", [&] {
        Rays rays(peers::PeerArguments::of(count, given));
        peers::answer_poses(rays.ready(), [&](const peers::Pose& pose) { return rays.answer(pose); });
    });
}
