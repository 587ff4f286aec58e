#include "target/self_test/board_checks.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "platform/files/file_text.hpp"
#include "platform/programs/program_folder.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/scene/scene_reader.hpp"
#include "render_core/terrain/verify_page.hpp"
#include "target/board_display.hpp"

namespace tedavis::target {
namespace {

constexpr std::uint64_t kMaxTableBytes = 128u << 20;  // page table and undulation of the largest database
constexpr std::uint64_t kSlackBytes = 1u << 20;       // for what a reader keeps beside the bytes
constexpr double kMegabyte = 1e6;
constexpr const char* kAllRead = "every checksum right";
constexpr const char* kHeaderRead = "the header is right (--self-test reads all of it)";

class BoardChecks {
public:
    BoardChecks(const BoardSettings& settings, SelfTestReport& report, const BoardCheckSettings& how)
        : settings_(settings), report_(report), how_(how) {}

    void run() {
        if (!settings_.terrain.empty()) check_terrain();
        if (!settings_.programs.empty()) check_programs();
        const bool is_started = check_start();
        if (!settings_.costs.empty()) check_costs(is_started);
        if (!settings_.scene.empty()) check_scene(is_started);
    }

private:
    void add(std::string_view name, const base::Error& error, std::string_view found) {
        report_.add(name, error.message.empty(), error.message.empty() ? found : error.message.view());
    }
    void fail(std::string_view name, std::initializer_list<std::string_view> parts) {
        report_.add(name, false, base::make_error(parts).message.view());
    }

    void check_terrain() {
        auto file = platform::open_file(settings_.terrain.c_str());
        if (!file.ok()) return fail("board_terrain", {file.error().message.view()});
        const std::uint64_t most = std::min(file.value().size() + kSlackBytes, kMaxTableBytes);
        const auto memory = platform::reserve_memory(most, platform::Residency::lazy);
        if (!memory.ok()) return fail("board_terrain", {memory.error().message.view()});
        base::Arena arena = memory.value().arena();
        const auto database = terrain::TerrainDatabase::open(file.value(), arena);
        std::uint64_t chunks = 0;
        const terrain::TdbFailure failure = !database.ok() ? database.error()
                                            : reads_all()  ? read_all(database.value(), chunks)
                                                           : terrain::TdbFailure();
        if (failure.error != terrain::TdbError::none)
            return fail("board_terrain", {settings_.terrain.view(), ": ", terrain::describe(failure).view()});
        char found[64];
        if (!reads_all()) chunks = database.value().header().chunk_count;
        std::snprintf(found, sizeof found, "%" PRIu64 " chunks, %s", chunks, reads_all() ? kAllRead : kHeaderRead);
        report_.add("board_terrain", true, found);
    }
    static terrain::TdbFailure read_all(const terrain::TerrainDatabase& database, std::uint64_t& chunks) {
        const auto room = std::make_unique<terrain::VerifyRoom>();
        for (std::uint32_t page = 0; page < database.lattice().page_count(); ++page)
            if (const auto failure = terrain::verify_page(database, page, *room, chunks);
                failure.error != terrain::TdbError::none)
                return failure;
        if (chunks != database.header().chunk_count) return {terrain::TdbError::directory_damaged, 0};
        return {};
    }

    /// Each program of a device without a compiler is read by the start.
    void check_programs() {
        const auto folder = platform::open_program_folder(settings_.programs.view());
        if (!folder.ok()) return fail("board_programs", {folder.error().message.view()});
        report_.add(
            "board_programs", true,
            gl::has_compiler(settings_.device.capability) ? "are not read: the device has a compiler" : "the folder is there");
    }

    /// False where there is no display.
    [[nodiscard]] bool check_start() {
        using platform::HostPart;
        const platform::HostFault fault = start_board_host(
            settings_, how_.is_off_screen ? off_screen_host_settings(settings_) : board_host_settings(settings_), host_);
        const bool has_surface = fault.part != HostPart::surface && fault.part != HostPart::context;
        add("board_surface", has_surface ? base::Error() : fault.error,
            how_.is_off_screen && is_on_screen(settings_) ? "off-screen, for the screen is not to be had"
                                                          : settings_.surface.view());
        if (!has_surface) return false;
        base::Error error = fault.error;
        const bool is_started = !fault;
        // A fault of terrain whose bytes are right: it does not fit the device.
        const SelfCheck* const terrain = report_.find("board_terrain");
        if (is_started && terrain != nullptr && terrain->holds) error = host_.terrain_fault();
        add("board_display", error, is_started ? budgets().view() : std::string_view());
        return is_started;
    }
    [[nodiscard]] base::FixedString<511> budgets() {
        const base::BudgetTable& table = host_.display().planner().budget();
        const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) / kMegabyte; };
        char text[128];
        std::snprintf(text, sizeof text, "%u x %u, %.1f MB of the processor's and %.1f MB of the GPU's memory",
                      host_.surface().width(), host_.surface().height(), megabytes(table.total(base::MemoryKind::cpu)),
                      megabytes(table.total(base::MemoryKind::gpu)));
        base::FixedString<511> with_driver(text);
        with_driver.append("; ");
        with_driver.append(host_.display().gl().driver_text().view());
        return with_driver;
    }

    /// Whose they are only a display can say.
    void check_costs(bool is_started) {
        if (is_started) return add("board_costs", hold_board_deadline(settings_, host_), "measured on this board");
        const auto text = platform::read_file_text(settings_.costs.c_str());
        if (!text.ok()) return add("board_costs", text.error(), {});
        const auto read = effects::read_calibration(text.value().view(), settings_.costs.view());
        report_.add("board_costs", read.ok(),
                    read.ok() ? "well-formed; whose they are is not known without a display" : read.error().message.view());
    }

    /// Into the room that the display has for it, as in flight; without a display into as much as the file may need.
    void check_scene(bool is_started) {
        auto file = platform::open_file(settings_.scene.c_str());
        if (!file.ok()) return fail("board_scene", {file.error().message.view()});
        if (!reads_all()) return check_scene_header(file.value());
        const auto memory = platform::reserve_memory(2 * file.value().size() + kSlackBytes, platform::Residency::lazy);
        if (!memory.ok()) return fail("board_scene", {memory.error().message.view()});
        base::Arena own = memory.value().arena();
        const auto scene = scene::Scene::load(file.value(), is_started ? host_.display().planner().data().spare() : own);
        if (!scene.ok()) return fail("board_scene", {settings_.scene.view(), ": ", scene::describe(scene.error()).view()});
        if (is_started && !host_.display().take_scene(scene.value()))
            return fail("board_scene",
                        {settings_.scene.view(), ": is not taken over; build it again with 'tedavis scene build'"});
        char found[96];
        std::snprintf(found, sizeof found, "%zu layers, revision %" PRIu64 ", %s", scene.value().layers().size(),
                      scene.value().header().revision, kAllRead);
        report_.add("board_scene", true, found);
    }
    void check_scene_header(platform::FileByteSource& file) {
        base::Arena none;
        scene::SceneHeader header{};
        if (const auto failure = scene::SceneReader(file, none).read_header(header); failure.error != scene::SdbError::none)
            return fail("board_scene", {settings_.scene.view(), ": ", scene::describe(failure).view()});
        char found[96];
        std::snprintf(found, sizeof found, "%u layers, revision %" PRIu64 ", %s", static_cast<unsigned>(header.layer_count),
                      header.revision, kHeaderRead);
        report_.add("board_scene", true, found);
    }
    [[nodiscard]] bool reads_all() const { return how_.reading == BoardReading::every_byte; }

    const BoardSettings& settings_;
    SelfTestReport& report_;
    BoardCheckSettings how_;
    platform::DisplayHost host_;
};

}  // namespace

void check_board(const BoardSettings& settings, SelfTestReport& report, const BoardCheckSettings& how) {
    BoardChecks(settings, report, how).run();
}

}  // namespace tedavis::target
