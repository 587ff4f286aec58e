/// The difference between a traced picture and another of the same size, usually the best one: root mean square of the
/// differences of linear light over all pixels and colours. Reports use CIEDE2000 for the visible difference of finished
/// pictures.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::raytrace {

/// Returns the error. Light above 1 counts as 1, the display's maximum. 0 for pictures without pixels.
[[nodiscard]] double picture_error(base::Span<const glm::vec3> light, base::Span<const glm::vec3> best);

}  // namespace tedavis::raytrace
