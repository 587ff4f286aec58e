#include "host_sim/commands/pack.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/pack/write_pack.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

void require_days(const PackOptions& options) {
    for (const auto& [name, day] : {std::pair{"--valid-from ", options.valid_from}, {"--valid-until ", options.valid_until}})
        if (!day.empty() && !platform::is_day(day)) throw UserError(name + day + ": is no day; write it as 2026-12-28");
    if (!options.valid_from.empty() && !options.valid_until.empty() && options.valid_until < options.valid_from)
        throw UserError("--valid-until " + options.valid_until + ": lies before --valid-from " + options.valid_from +
                        "; change one of them");
}

/// A pack that is valid on no day would be flagged from its first start.
void require_valid_day(const PackOptions& options, const PackContents& contents) {
    for (const PackedFile& file : contents.files) {
        const std::string of = " of the packed " + file.path;
        if (!options.valid_from.empty() && !file.valid_until.empty() && options.valid_from > file.valid_until)
            throw UserError("--valid-from " + options.valid_from + ": lies after the last day" + of + " (" + file.valid_until +
                            "), so the pack would be valid on no day; change it, or build newer data");
        if (!options.valid_until.empty() && !file.valid_from.empty() && options.valid_until < file.valid_from)
            throw UserError("--valid-until " + options.valid_until + ": lies before the first day" + of + " (" + file.valid_from +
                            "), so the pack would be valid on no day; change it");
    }
}

void say_pack(const PackOptions& options, const PackContents& contents, const platform::CheckedPack& pack, Console& console) {
    nlohmann::ordered_json json = {{"folder", options.output},
                                   {"title", contents.title},
                                   {"files", pack.files},
                                   {"bytes", pack.bytes},
                                   {"signed", !options.sign.empty()},
                                   {"valid_from", pack.valid_from.view()},
                                   {"valid_until", pack.valid_until.view()}};
    std::string text = options.output + ": " + contents.title + ", " + std::to_string(pack.files) + " files, " +
                       std::to_string(pack.bytes) + " bytes";
    if (!options.sign.empty()) text += ", signed";
    if (!pack.valid_from.empty()) text += ", valid from " + std::string(pack.valid_from.view());
    if (!pack.valid_until.empty()) text += ", valid until " + std::string(pack.valid_until.view());
    console.result(text, json_text(json));
}

}  // namespace

int run_pack(const PackOptions& options, Console& console) {
    require_days(options);
    const InterruptGuard interrupt;
    const ReplayOptions configured = load_replay_config(options.config);
    const PackContents contents = pack_contents(configured, options.config);
    require_valid_day(options, contents);
    const PackSettings settings{options.output, options.replaces, options.valid_from, options.valid_until, options.sign};
    const auto pack = write_pack(contents, settings, [&](std::uint64_t done, std::uint64_t total) {
        console.progress("pack", done, total);
        if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
    });
    console.progress_done();
    if (!configured.log.empty() || !configured.switches.empty())
        console.note("note: logs of [replay] are no part of a pack; name them at each replay");
    if (!configured.config->has_can)
        console.note("note: " + options.config + " has no [can], so no board starts from this pack; the desk does");
    say_pack(options, contents, pack, console);
    return 0;
}

}  // namespace tedavis::host_sim
