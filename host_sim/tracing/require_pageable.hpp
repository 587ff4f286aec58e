/// Which pictures can be drawn of paged ground: those that need primary hits only (needs_primary_hits_only).
#pragma once

#include <string>
#include <vector>

#include "host_sim/tracing/traced_ground.hpp"

namespace tedavis::host_sim {

/// Throws UserError where the ground is paged and one of the settings needs all heights in memory: what needs them, how much
/// memory they take, and what to do. `name` says whose settings they are, such as "--preset quality".
void require_pageable(const TracedGround& ground, const std::string& name, const std::vector<raytrace::TraceSettings>& settings);

}  // namespace tedavis::host_sim
