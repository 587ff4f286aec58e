/// Checks whether pictures can be drawn of paged ground: only those that need nothing but primary hits (needs_primary_hits_only).
#pragma once

#include <string>
#include <vector>

#include "host_sim/tracing/traced_ground.hpp"

namespace tedavis::host_sim {

/// Throws UserError where the ground is paged and one of the settings needs all heights in memory; the message names the setting,
/// the memory that the heights need, and what to do. `name` is the origin of the settings, such as "--preset quality".
void require_pageable(const TracedGround& ground, const std::string& name, const std::vector<raytrace::TraceSettings>& settings);

}  // namespace tedavis::host_sim
