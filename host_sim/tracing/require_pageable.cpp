#include "host_sim/tracing/require_pageable.hpp"

#include <algorithm>

#include "host_sim/tracing/trace_report.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::TraceSettings;

/// The operators that need all heights.
std::vector<std::string> needs_of(const TraceSettings& settings) {
    using namespace raytrace;
    std::vector<std::string> needs;
    if (!settings.search.is_exact())
        needs.emplace_back("the search");
    else if (settings.is_surface_stored || !is_kernel_surface(settings))
        needs.emplace_back("the smooth surface");
    if (settings.antialiasing == Antialiasing::average_mipmap) needs.emplace_back("averaged slopes");
    if (settings.antialiasing == Antialiasing::supersampling) needs.emplace_back("supersampling");
    if (settings.ambient == Ambient::sky_view) needs.emplace_back("the sky view");
    if (settings.ambient == Ambient::apertures) needs.emplace_back("apertures");
    if (settings.has_shadows) needs.emplace_back("cast shadows");
    if (settings.mirrors > 0) needs.emplace_back("mirrors");
    if (settings.paths > 0) needs.emplace_back("light paths");
    return needs;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text = words.front();
    for (std::size_t n = 1; n < words.size(); ++n) text += (n + 1 == words.size() ? " and " : ", ") + words[n];
    return text;
}

}  // namespace

void require_pageable(const TracedGround& ground, const std::string& name, const std::vector<TraceSettings>& settings) {
    if (!ground.is_paged()) return;
    std::vector<std::string> needs;
    for (const TraceSettings& one : settings)
        for (const std::string& need : needs_of(one))
            if (std::find(needs.begin(), needs.end(), need) == needs.end()) needs.push_back(need);
    if (needs.empty()) return;
    const std::string more =
        ground.can_be_in_memory() ? "give --memory " + megabytes_up(ground.bytes_in_memory()) + " or more, or " : "";
    throw UserError(ground.path() + ": " + listed(needs) + " of " + name + " need all heights in memory, where they take " +
                    megabytes(ground.bytes_in_memory()) + " or more and --memory allows " + megabytes(ground.memory().bytes) +
                    "; " + more + (ground.can_be_in_memory() ? "" : "use ") + "--preset time with the exact search");
}

}  // namespace tedavis::host_sim
