/// How far a traced picture is from another of the same size, usually the best one: root of the mean square of differences of
/// linear light, over all pixels and colours. For the eye's measure of finished pictures see the CIEDE2000 of reports.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::raytrace {

/// Light above 1 counts as 1: the display shows no more. 0 for pictures without pixels.
[[nodiscard]] double picture_error(base::Span<const glm::vec3> light, base::Span<const glm::vec3> best);

}  // namespace tedavis::raytrace
