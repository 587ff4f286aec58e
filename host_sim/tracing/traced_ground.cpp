#include "host_sim/tracing/traced_ground.hpp"

#include <cmath>
#include <utility>

#include "host_sim/user_error.hpp"
#include "render_core/raytrace/picture/traced_scene.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kMaxPostsAlong = raytrace::HeightGrid<float>::kMaxPosts;

raytrace::GroundSpace space_of(const std::string& path, const terrain::TerrainDatabase& database) {
    const terrain::Lattice& lattice = database.lattice();
    const terrain::PostRange all{0, 0, lattice.columns() - 1, lattice.rows() - 1};
    if (!raytrace::GroundSpace::fits(lattice, all))
        throw UserError(path +
                        ": goes round the Earth or to a pole, where the tracer has no grid; cut a part of it with "
                        "'terrain build --bounds W,S,E,N'");
    if (lattice.columns() > kMaxPostsAlong || lattice.rows() > kMaxPostsAlong)
        throw UserError(
            path + ": has " + std::to_string(lattice.columns()) + " x " + std::to_string(lattice.rows()) +
            " posts, and the tracer takes 65537 along a side; cut a part of it with 'terrain build --bounds W,S,E,N'");
    return {database, all, 1};
}

}  // namespace

TracedGround::TracedGround(const std::string& path, base::Workers& workers, GroundMemory memory)
    : path_(path), memory_(std::move(memory)), open_(path), space_(space_of(path, open_.database())) {
    is_paged_ = !fits<std::int16_t>();
    if (is_paged_) return;
    raytrace::GroundReading reading = read(window(), whole_, workers);
    if (!reading.rounding.are_whole()) {
        whole_ = {};
        is_paged_ = !fits<float>();
        if (is_paged_) return;
        reading = read(window(), metres_, workers);
    }
    if (reading.damaged_parts > 0) refuse_database(path, reading.first_damage);
    void_posts_ = reading.void_posts;
}

template <class Height>
bool TracedGround::fits() {
    const raytrace::HeightGrid<Height> grid{nullptr, columns(), rows(), columns()};
    bytes_in_memory_ =
        std::uint64_t{columns()} * rows() * sizeof(Height) + raytrace::TracedScene<Height>::bytes_needed(grid, memory_.settings);
    if (!can_be_in_memory() && memory_.bytes == GroundMemory().bytes)
        throw UserError(path_ + ": has " + std::to_string(columns()) + " x " + std::to_string(rows()) +
                        " posts, and the tracer holds 1600 million in memory; cut a part of it with 'terrain build --bounds "
                        "W,S,E,N', or page it with 'trace --memory MB'");
    return can_be_in_memory() && bytes_in_memory_ <= memory_.bytes;
}

template <class Height>
raytrace::GroundReading TracedGround::read(const terrain::PostRange& window, std::vector<Height>& posts,
                                           base::Workers& workers) const {
    std::vector<std::uint64_t> memory(raytrace::GroundReader::bytes_needed(workers.concurrency()) / 8 + 1);
    base::Arena arena(memory.data(), memory.size() * 8);
    raytrace::GroundReader reader;
    if (!reader.start(database(), workers.concurrency(), arena))
        throw UserError("no memory to read the terrain's heights; name a smaller database");
    raytrace::GroundWindow<Height> to;
    to.window = window;
    to.step_m = space_.step_m();
    posts.resize(std::size_t{to.columns()} * to.rows());
    to.posts = posts;
    return reader.read(to, workers);
}

std::optional<double> TracedGround::height_near(const glm::dvec3& place) const {
    const double column = std::round(place.x), row = std::round(place.y);
    if (!(column >= 0 && row >= 0 && column < columns() && row < rows())) return std::nullopt;
    const auto i = static_cast<std::uint32_t>(column), j = static_cast<std::uint32_t>(row);
    std::vector<float> post;
    base::SerialWorkers alone;
    (void)read({i, j, i, j}, post, alone);
    if (post[0] == raytrace::HeightGrid<float>::kVoid) return std::nullopt;
    return post[0];
}

template <>
raytrace::HeightGrid<std::int16_t> TracedGround::grid() const {
    return {whole_.data(), columns(), rows(), columns()};
}

template <>
raytrace::HeightGrid<float> TracedGround::grid() const {
    return {metres_.data(), columns(), rows(), columns()};
}

std::uint64_t TracedGround::bytes() const { return whole_.size() * sizeof(std::int16_t) + metres_.size() * sizeof(float); }

}  // namespace tedavis::host_sim
