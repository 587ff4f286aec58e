// A header with a fault: it does not include what it uses. The checks of headers that stand alone must refuse it.
#pragma once

namespace tedavis::tests::layering {

inline std::uint32_t leaning() { return 1; }

}  // namespace tedavis::tests::layering
