/// What the programs of spatial data are compiled for (data_frame.hpp). Plain data.
#pragma once

namespace tedavis::draw {

/// The features that frames may have; others are not compiled.
struct DataVariant {
    bool air = false, grid = false, shadows = false, magnified = false;
};

}  // namespace tedavis::draw
