#include "host_sim/replay/interval_store.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/replay/byte_stream.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint64_t kLargestIntervalFile = 256u << 20;

bool keeps_intervals(const ReplayOptions& options) { return options.keeps_index && !options.picture.deadline_ms; }

/// Which instants are drawn, and what becomes of them, decides nothing.
std::string deciding_options(ReplayOptions options) {
    const ReplayOptions usual;
    options.from_s = usual.from_s;
    options.to_s = usual.to_s;
    options.step_s = usual.step_s;
    options.over_terrain = usual.over_terrain;
    options.spread = usual.spread;
    options.frames = usual.frames;
    options.accuracy = usual.accuracy;
    options.layers = options.ledger = options.strict = false;
    options.video.clear();
    return replay_config_text(options);
}

std::string key_of_intervals(const ReplayOptions& options, const DisplayFiles& files, const DisplaySession& session,
                             const FlightPlayer& player) {
    ByteWriter writer;
    writer.put(player.key());
    writer.put(session.width());
    writer.put(session.height());
    writer.put_text(deciding_options(options));
    writer.put_text(files.content);
    return writer.take();
}

}  // namespace

std::optional<DisplayFiles> IntervalStore::files_before_start(const ReplayOptions& options) {
    return keeps_intervals(options) ? display_files(options.picture) : std::nullopt;
}

IntervalStore::IntervalStore(const ReplayOptions& options, const std::optional<DisplayFiles>& files, DisplaySession& session,
                             FlightPlayer& player, FramePreroll& preroll, Console& console)
    : session_(session), preroll_(preroll), console_(console) {
    if (!keeps_intervals(options) || !player.has_kept_index() || !equal(files, display_files(options.picture))) return;
    path_ = options.log + ".tdi";
    made_from_ = key_of_intervals(options, *files, session, player);
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path_, error);
    if (error || bytes > kLargestIntervalFile) return;
    std::optional<IntervalTrack> kept = unpack_intervals(read_file(path_), made_from_);
    if (!kept) return;
    held_ = kept->packed().size();
    preroll.take_intervals(std::move(*kept));
}

IntervalStore::~IntervalStore() {
    try {
        write();
    } catch (const std::exception& error) {
        console_.note(std::string(error.what()) + "; the labels of the flight are not kept");
    }
}

void IntervalStore::write() {
    if (path_.empty() || preroll_.has_forgotten() || !session_.terrain_fault().empty()) return;
    if (preroll_.intervals().packed().size() <= held_) return;
    write_file_atomically(path_, pack_intervals(preroll_.intervals(), made_from_));
}

}  // namespace tedavis::host_sim
