/// Our triangles over the common raster, as the display selects them for an error of 1 px or what the option says
/// (`plain-1`, `shaded-1`), device `desktop`, no haze. `plain` is the time of selecting and uploading and that of drawing the
/// triangles in one colour, which are on the device already; `shaded` that of the display's terrain pass in the shipped design.
#include <cstring>

#include "render_core/draw/drawn_design.hpp"
#include "tests/bench/bare_triangles.hpp"
#include "tests/bench/peers/earth_ground.hpp"
#include "tests/bench/peers/peer_loop.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/terrain/terrain_on_surface.hpp"

namespace {

using namespace tedavis;

constexpr const char* kDevice = "desktop";

const std::string& depth_shader() {
    static const std::string text =
        std::string("void main() {\n") + peers::kDepthColorCode + "FRAGMENT_COLOR = vec4(depth_color, 1.0);\n}\n";
    return text;
}

design::DesignSettings design_of(double tau_px) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.tau_px = tau_px;
    return design;
}

class Triangles {
public:
    explicit Triangles(const peers::PeerArguments& given)
        : given_(given),
          is_shaded_(given.option.rfind("shaded-", 0) == 0),
          design_(design_of(std::stod(given.option.substr(given.option.find('-') + 1)))),
          opened_(given.folder + "/ground.tdb"),
          alone_(kDevice, given.size.width, given.size.height, opened_.source(), design_),
          plain_(kDevice, given.size.width, given.size.height),
          depth_(kDevice, given.size.width, given.size.height, depth_shader().c_str()) {}

    std::string answer(const peers::Pose& pose) {
        set_view(pose);
        alone_.look(camera_, input_);
        load();
        draw();
        const double ms = peers::spent_ms([&] {
            alone_.look(camera_, input_);
            draw();
        });
        write_depths();
        const terrain::LodResult lod = alone_.scene().plan(camera_, design_).lod;
        return "\"ms\": [" + std::to_string(ms) + "], \"bound_px\": " + std::to_string(lod.tau_reached_px) +
               ", \"triangles\": " + std::to_string(plain_.triangles());
    }

private:
    void set_view(const peers::Pose& pose) {
        const peers::EarthPose on_earth(opened_.database(), pose);
        const peers::Axes axes = peers::axes_of(pose);
        terrain::View view{};
        view.eye = on_earth.eye;
        view.forward = on_earth.east_north_up * axes.forward;
        view.right = on_earth.east_north_up * axes.right;
        view.down = on_earth.east_north_up * axes.down;
        view.focal_px = given_.size.focal_px();
        view.width = given_.size.width;
        view.height = given_.size.height;
        view.near_m = peers::kNear_m;
        view.far_m = peers::kFar_m;
        camera_.view = view;
        camera_.haze_per_m = 0;
        input_ = {};
        input_.view = view;
        for (glm::dvec3& light : input_.light_direction) light = glm::normalize(view.eye);
    }
    /// Uploads the selected triangles for both plain programs.
    void load() {
        for (test_support::BareTriangles* triangles : {&plain_, &depth_}) {
            triangles->make_current();
            triangles->clear();
            for (const terrain::SelectedChunk& chunk : alone_.scene().selected()) {
                const terrain::ChunkEntry& entry = *chunk.entry;
                const glm::dvec3 offset = glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - camera_.view.eye;
                std::vector<glm::vec3> places;
                for (const terrain::ChunkVertex& v : alone_.scene().vertices(chunk))
                    places.emplace_back(offset + glm::dvec3(v.x, v.y, v.z));
                triangles->add(places, alone_.scene().drawn_indices(chunk));
            }
            triangles->release_current();
        }
    }
    void draw() {
        if (is_shaded_) {
            alone_.make_current();
            alone_.draw();
            return alone_.release_current();
        }
        plain_.make_current();
        plain_.draw(camera_.view, {peers::kNear_m, peers::kFar_m});
        plain_.release_current();
    }
    void write_depths() {
        depth_.make_current();
        depth_.draw(camera_.view, {peers::kNear_m, peers::kFar_m});
        const std::vector<std::uint8_t> colors = depth_.pixels();
        depth_.release_current();
        const std::size_t width = given_.size.width, height = given_.size.height;
        std::vector<float> depth(given_.size.pixels());
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x) {
                const std::uint8_t* color = &colors[4 * ((height - 1 - y) * width + x)];
                depth[y * width + x] = peers::depth_of_color(color[0], color[1], color[2]);
            }
        peers::write_picture(given_.folder + "/triangles-" + given_.option + ".depth", depth);
    }

    peers::PeerArguments given_;
    bool is_shaded_;
    design::DesignSettings design_;
    peers::OpenedDatabase opened_;
    test_support::TerrainOnSurface alone_;
    test_support::BareTriangles plain_, depth_;
    display::Camera camera_;
    draw::TerrainDrawInput input_;
};

}  // namespace

int main(int count, char** given) {
    return peers::run_peer("peer_triangles", [&] {
        Triangles triangles(peers::PeerArguments::of(count, given));
        peers::answer_poses("\"version\": \"this tree\"", [&](const peers::Pose& pose) { return triangles.answer(pose); });
    });
}
