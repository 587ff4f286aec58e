// The paged tracer beside the one whose terrain is in memory: pictures of 1920 x 1080, medians, two threads, the same heights and
// the same hits. Rows: everything kept, everything loaded anew, few slots and one; ground of 65,537 x 65,537 posts that is
// nowhere stored; and terrain databases, where they are named. `--json` prints the lines as a list, `--quick` takes fewer
// pictures.
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "platform/clock/monotonic_clock.hpp"
#include "platform/files/file_byte_source.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/paged/database_chunks.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/raytrace/held_chunks.hpp"
#include "tests/support/raytrace/trace_cameras.hpp"
#include "tests/support/raytrace/traced_ground.hpp"
#include "tests/support/terrain/generated_chunks.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::raytrace;
using bench::BenchResult;
using test_support::TraceCamera;

constexpr std::uint32_t kWidth = 1920, kHeight = 1080, kThreads = 2;

struct Options {
    bool json = false, quick = false;
    std::vector<std::string> files;
    [[nodiscard]] int runs() const { return quick ? 3 : 7; }
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

template <class Work>
double spent_ms(const Work& work) {
    const base::Time start = platform::monotonic_now();
    work();
    return (platform::monotonic_now() - start).to_seconds() * 1000;
}

/// Ground in memory and what the other tracer finds of it.
template <class Height>
struct WholeGround {
    WholeGround(test_support::HeightField<Height> posts, const TraceCamera& from, int runs, base::Workers& workers)
        : ground(std::move(posts)), camera(from.view()) {
        std::vector<double> times;
        for (int n = 0; n < runs; ++n)
            times.push_back(spent_ms([&] {
                test_support::trace_view(ground.traced(CellSurface::two_triangles), camera, view_kernels<Height>()[0], workers,
                                         kWidth, kHeight, picture.picture());
            }));
        ms = median(times);
    }
    /// Without minima: pixels are looked at from above alone, as the paged tracer is asked to.
    test_support::TracedGround<Height> ground;
    GridCamera camera;
    test_support::TracedPicture picture{kWidth, kHeight};
    double ms = 0;
};

struct PagedTime {
    double ms = 0;
    PagedWork work;
    std::size_t different = 0;
    std::uint64_t bytes = 0, terrain_bytes = 0;
};

/// `keeps`: one picture before it loads what it needs. Otherwise each picture begins with empty slots.
template <class Height>
PagedTime time_paged(ChunkHeights<Height>& chunks, const GridCamera& camera, std::uint32_t slots, bool keeps, int runs,
                     base::Workers& workers, const test_support::TracedPicture* expected) {
    const PagedSettings settings{slots, kWidth * kHeight, kThreads};
    std::vector<double> times;
    PagedTime paged;
    paged.bytes = PagedTracer<Height>::bytes_needed(chunks.columns(), chunks.rows(), settings);
    paged.terrain_bytes = PagedTracer<Height>::bytes_needed(chunks.columns(), chunks.rows(), {slots, 1, kThreads});
    std::vector<std::uint64_t> memory(paged.bytes / 8 + 1);
    PagedTracer<Height> tracer;
    std::vector<Hit> hits(std::size_t{kWidth} * kHeight);
    const auto trace = [&] {
        paged.work = tracer.trace(PagedRays::of(camera, kWidth, kHeight), CellSurface::two_triangles, false,
                                  packet_kernels<Height>()[0], workers, hits);
    };
    for (int n = 0; n < runs; ++n) {
        if (n == 0 || !keeps) {
            base::Arena arena(memory.data(), memory.size() * 8);
            TEDAVIS_CHECK(tracer.start(chunks, settings, arena) == PagedTracer<Height>::Started::yes);
            if (keeps) trace();
        }
        times.push_back(spent_ms(trace));
    }
    paged.ms = median(times);
    const auto are_same_bits = [](float a, float b) { return a == b && std::signbit(a) == std::signbit(b); };  // none is NaN
    for (std::size_t n = 0; expected != nullptr && n < hits.size(); ++n)
        paged.different += !are_same_bits(hits[n].t, expected->t[n]) || hits[n].side != expected->side[n];
    return paged;
}

void add_lines(const std::string& name, const PagedTime& paged, double whole_ms, std::uint64_t whole_bytes,
               std::vector<BenchResult>& lines) {
    const bool is_right = paged.different == 0;
    const auto line = [&](const char* what, double value, const char* unit, double baseline) {
        lines.push_back({name + ": " + what, value, unit, 0, is_right, baseline});
    };
    line("picture", paged.ms, "ms", whole_ms);
    line("memory of terrain", static_cast<double>(paged.terrain_bytes) / 1e6, "MB", static_cast<double>(whole_bytes) / 1e6);
    line("memory of rays", static_cast<double>(paged.bytes - paged.terrain_bytes) / 1e6, "MB", 0);
    line("chunks loaded", paged.work.loads, "chunks", 0);
    line("posts loaded", static_cast<double>(paged.work.loaded_bytes) / 1e6, "MB", 0);
    line("passes", paged.work.passes, "passes", 0);
}

template <class Height>
void compare(const std::string& name, ChunkHeights<Height>& chunks, const WholeGround<Height>& whole, const Options& options,
             base::Workers& workers, std::vector<BenchResult>& lines) {
    const std::uint32_t all = chunks.chunk_columns() * chunks.chunk_rows();
    const std::uint64_t posts = std::uint64_t{chunks.columns()} * chunks.rows() * sizeof(Height);
    const std::uint64_t bytes = posts + HeightMipmap<Height>::bytes_needed(chunks.columns(), chunks.rows());
    struct Row {
        const char* name;
        std::uint32_t slots;
        bool keeps;
    };
    for (const Row& row :
         {Row{", all kept", all, true}, Row{", all loaded", all, false}, Row{", 64 slots", 64, false}, Row{", 1 slot", 1, false}})
        add_lines(name + row.name,
                  time_paged(chunks, whole.camera, row.slots, row.keeps, options.runs(), workers, &whole.picture), whole.ms,
                  bytes, lines);
}

void compare_generated_square(const Options& options, base::Workers& workers, std::vector<BenchResult>& lines) {
    constexpr std::uint32_t kSide = 4096;
    const auto cameras = test_support::trace_cameras(kSide, kWidth, kHeight);
    const WholeGround<std::int16_t> whole(test_support::fractal_heights(kSide),
                                          cameras[3].in_steps(test_support::steps_a_cell(kSide)), options.runs(), workers);
    test_support::HeldChunks<std::int16_t> chunks(whole.ground.field.grid());
    compare<std::int16_t>("4096 x 4096", chunks, whole, options, workers, lines);
}

void time_largest(const Options& options, base::Workers& workers, std::vector<BenchResult>& lines) {
    constexpr std::uint32_t kSide = HeightGrid<std::int16_t>::kMaxPosts;
    test_support::GeneratedChunks chunks(kSide, kSide);
    GridCamera camera = test_support::trace_cameras(kSide, kWidth, kHeight)[3].in_steps(100).view();
    camera.origin.z = 5000;  // of steps; hills are up to 8000 high, most to 1500
    const PagedTime paged = time_paged(chunks, camera, 4096, false, options.runs(), workers, nullptr);
    add_lines("65537 x 65537, 4096 slots", paged, 0, std::uint64_t{kSide} * kSide * sizeof(std::int16_t) * 7 / 3, lines);
}

void compare_database(const std::string& path, const Options& options, base::Workers& workers, std::vector<BenchResult>& lines) {
    auto file = platform::open_file(path.c_str());
    if (!file.ok()) {
        std::fprintf(stderr, "%s\n", std::string(file.error().message.view()).c_str());
        std::exit(2);
    }
    platform::FileByteSource source = std::move(file.value());
    std::vector<std::uint64_t> table(1 << 20);
    base::Arena tables(table.data(), table.size() * 8);
    const auto database = terrain::TerrainDatabase::open(source, tables);
    if (!database.ok()) {
        std::fprintf(stderr, "%s %s\n", path.c_str(), std::string(terrain::describe(database.error()).view()).c_str());
        std::exit(2);
    }
    const terrain::Lattice& lattice = database.value().lattice();
    const terrain::PostRange window{0, 0, lattice.columns() - 1, lattice.rows() - 1};
    std::vector<std::uint64_t> memory(DatabaseChunks::bytes_needed(kThreads) / 8 + 1);
    base::Arena arena(memory.data(), memory.size() * 8);
    DatabaseChunks chunks;
    GroundReader reader;
    std::vector<std::uint64_t> desks(GroundReader::bytes_needed(kThreads) / 8 + 1);
    base::Arena desk_arena(desks.data(), desks.size() * 8);
    TEDAVIS_CHECK(chunks.start(database.value(), window, kThreads, arena) &&
                  reader.start(database.value(), kThreads, desk_arena));
    test_support::HeightField<float> field(chunks.columns(), chunks.rows());
    GroundReading reading;
    const double read_ms = spent_ms([&] { reading = reader.read<float>({window, field.posts, 1}, workers); });
    lines.push_back({path + ": read whole", read_ms, "ms", 0, reading.damaged_parts == 0, 0});
    TraceCamera camera = test_support::trace_cameras(std::min(chunks.columns(), chunks.rows()), kWidth, kHeight)[3].in_steps(30);
    camera.eye.z = double{database.value().header().max_height_m} + 200;
    const WholeGround<float> whole(std::move(field), camera, options.runs(), workers);
    compare<float>(path, chunks, whole, options, workers, lines);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    for (int n = 1; n < argc; ++n) {
        if (std::strcmp(argv[n], "--json") == 0)
            options.json = true;
        else if (std::strcmp(argv[n], "--quick") == 0)
            options.quick = true;
        else
            options.files.emplace_back(argv[n]);
    }
    const auto workers = platform::make_thread_workers({kThreads, nullptr});
    std::vector<BenchResult> lines;
    compare_generated_square(options, *workers.value(), lines);
    time_largest(options, *workers.value(), lines);
    for (const std::string& file : options.files) compare_database(file, options, *workers.value(), lines);
    return bench::report(lines, options.json);
}
