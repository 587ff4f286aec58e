#include "host_sim/tracing/traced_ground.hpp"

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kMaxPostsAlong = 65537;
constexpr std::uint64_t kMaxPosts = 1'600'000'000;

raytrace::GroundSpace space_of(const std::string& path, const terrain::TerrainDatabase& database) {
    const terrain::Lattice& lattice = database.lattice();
    const terrain::PostRange all{0, 0, lattice.columns() - 1, lattice.rows() - 1};
    if (!raytrace::GroundSpace::fits(lattice, all))
        throw UserError(path +
                        ": goes round the Earth or to a pole, where the tracer has no grid; cut a part of it with "
                        "'terrain build --bounds W,S,E,N'");
    if (lattice.columns() > kMaxPostsAlong || lattice.rows() > kMaxPostsAlong ||
        std::uint64_t{lattice.columns()} * lattice.rows() > kMaxPosts)
        throw UserError(path + ": has " + std::to_string(lattice.columns()) + " x " + std::to_string(lattice.rows()) +
                        " posts, and the tracer takes 65537 along a side and 1600 million in all; cut a part of it with "
                        "'terrain build --bounds W,S,E,N'");
    return {database, all, 1};
}

}  // namespace

TracedGround::TracedGround(const std::string& path, base::Workers& workers)
    : open_(path), space_(space_of(path, open_.database())) {
    raytrace::GroundReading reading = read(whole_, workers);
    if (!reading.rounding.are_whole()) {
        whole_ = {};
        reading = read(metres_, workers);
    }
    if (reading.damaged_parts > 0) refuse_database(path, reading.first_damage);
    void_posts_ = reading.void_posts;
}

template <class Height>
raytrace::GroundReading TracedGround::read(std::vector<Height>& posts, base::Workers& workers) const {
    posts.resize(std::size_t{columns()} * rows());
    std::vector<std::uint64_t> memory(raytrace::GroundReader::bytes_needed(workers.concurrency()) / 8 + 1);
    base::Arena arena(memory.data(), memory.size() * 8);
    raytrace::GroundReader reader;
    if (!reader.start(database(), workers.concurrency(), arena))
        throw UserError("no memory to read the terrain's heights; name a smaller database");
    raytrace::GroundWindow<Height> to;
    to.posts = posts;
    to.window = window();
    to.step_m = space_.step_m();
    return reader.read(to, workers);
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
