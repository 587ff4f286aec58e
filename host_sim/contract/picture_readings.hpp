/// The measures of a contract that are taken of a picture. Conditions that need the layers of the pixels are only asked where the
/// picture has them.
#pragma once

#include "host_sim/contract/contract.hpp"
#include "host_sim/contract/contract_reading.hpp"
#include "host_sim/contract/measured_frame.hpp"

namespace tedavis::host_sim {

[[nodiscard]] ContractReading clutter_reading(const ContractCondition& condition, const MeasuredFrame& frame);
/// Of saliency_share and saliency_over_area. Absent where no aspect is prioritized, or data or their uncertainty are asked for in
/// a run without a scene; a design that shows nothing of a scene has 0.
[[nodiscard]] ContractReading saliency_reading(const ContractCondition& condition, const MeasuredFrame& frame);
/// Of the faintest sign. Absent where the layer has none.
[[nodiscard]] ContractReading contrast_reading(const ContractCondition& condition, const MeasuredFrame& frame);
/// Of obstacles on the way that are in the picture: one has the rank of the first salient place from which the disc of the focus
/// reaches the middle of its box (places beside layers that are left out do not count, either); one that the design leaves out
/// has none. Absent where there is no such obstacle.
[[nodiscard]] ContractReading obstacle_reading(const ContractCondition& condition, const MeasuredFrame& frame);

}  // namespace tedavis::host_sim
