/// A drawn sheet of two groups whose pictures are of one colour each, for tests of what is made from sheets.
#pragma once

#include <string>

#include "host_sim/reports/drawn_sheet.hpp"
#include "tests/support/flights/frame_result.hpp"

namespace tedavis::test_support {

inline host_sim::DrawnSheet::Picture plain_picture(const std::string& name, std::uint8_t grey) {
    host_sim::DrawnSheet::Picture picture;
    picture.title = "Title " + name;
    picture.design = "styles/" + name;
    picture.file = name + ".png";
    picture.result = frame_result(1, 0);
    picture.pixels = {64, 48, std::vector<std::uint8_t>(64 * 48 * 4, grey)};
    return picture;
}

/// Three pictures and one, two a row.
inline host_sim::DrawnSheet small_sheet() {
    host_sim::DrawnSheet sheet;
    sheet.name = "small";
    sheet.title = "A <small> sheet";
    sheet.terrain = "hills.tdb";
    sheet.device = "es3-mid";
    sheet.gl = "egl: test";
    sheet.pose = {36.5, -84.25, 1000, 330, -6, 0};
    sheet.columns = 2;
    sheet.groups = {{"First", {plain_picture("a", 10), plain_picture("b", 60), plain_picture("c", 110)}},
                    {"Second", {plain_picture("d", 160)}}};
    return sheet;
}

}  // namespace tedavis::test_support
