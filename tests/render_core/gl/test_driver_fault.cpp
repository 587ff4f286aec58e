#include "render_core/gl/driver_fault.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "platform/surface_factory.hpp"
#include "tests/render_core/gl/renamed_driver.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_driver_fault {
namespace {

std::string faults_of(const char* renderer) {
    DriverFacts driver;
    driver.renderer = renderer;
    std::string names;
    for (const KnownFault& known : known_faults())
        if (known.shows_on(driver)) names += std::string(known.name) + ' ';
    return names;
}

TEST(DriverFault, EachHasAnEntryANameAndAStory) {
    ASSERT_EQ(known_faults().size(), static_cast<std::size_t>(DriverFault::count));
    for (std::size_t n = 0; n < known_faults().size(); ++n) {
        const KnownFault& known = known_faults()[n];
        EXPECT_EQ(known.fault, static_cast<DriverFault>(n));
        EXPECT_EQ(find_fault(known.name), known.fault);
        EXPECT_GT(std::string(known.story).size(), 60u);
    }
    EXPECT_EQ(find_fault("none-such"), DriverFault::count);
}

TEST(DriverFault, ShowsOnItsDriversAlone) {
    for (const char* adreno : {"Adreno (TM) 305", "Adreno (TM) 430", "Adreno (TM) 540"})
        EXPECT_EQ(faults_of(adreno), "adreno-program-binaries ") << adreno;
    for (const char* sound : {"Adreno (TM) 630", "Adreno (TM) ", "Adreno (TM) 225", "llvmpipe (LLVM 15.0.6, 256 bits)", "",
                              "Vivante GC7000Lite", "PowerVR SGX 530"})
        EXPECT_EQ(faults_of(sound), "") << sound;
    EXPECT_EQ(faults_of("PowerVR Rogue GE8300"), "powervr-program-binaries ");
}

std::unique_ptr<base::Surface> adreno() {
    auto real = platform::make_surface("egl", {64, 48, platform::ContextLane::es2});
    return std::make_unique<test_support::RenamedDriver>(std::move(real.value()), "Adreno (TM) 530");
}

/// What building a program on a device without a compiler is refused with.
std::string refused(const effects::DeviceSettings& device) {
    test_support::GlSession at(adreno(), device);
    return std::string(build_program(at.gl, test_support::triangle_program_source()).error().message.view());
}

TEST(DriverFault, BinariesAreNotTakenFromADriverThatSpoilsThemUnlessTheDeviceFileIgnoresTheFault) {
    effects::DeviceSettings sc2 = test_support::shipped_device("sc2");
    EXPECT_NE(refused(sc2).find("not trusted, for its fault adreno-program-binaries"), std::string::npos) << refused(sc2);
    ASSERT_TRUE(sc2.capability.gl.ignored_faults.try_push_back("adreno-program-binaries"));
    EXPECT_NE(refused(sc2).find("has no binary for this driver"), std::string::npos) << "it looks for one: " << refused(sc2);
    test_support::GlSession compiling(adreno(), test_support::shipped_device("es2-small"));
    EXPECT_TRUE(build_program(compiling.gl, test_support::triangle_program_source()).ok()) << "where programs are compiled";
}

TEST(DriverFault, IsSaidWithTheDriversName) {
    effects::DeviceSettings sc2 = test_support::shipped_device("sc2");
    const auto text = [&sc2] { return std::string(test_support::GlSession(adreno(), sc2).gl.driver_text().view()); };
    EXPECT_NE(text().find("Adreno (TM) 530, "), std::string::npos) << text();
    EXPECT_NE(text().find("; known faults: adreno-program-binaries"), std::string::npos) << text();
    ASSERT_TRUE(sc2.capability.gl.ignored_faults.try_push_back("adreno-program-binaries"));
    EXPECT_EQ(text().find("known faults"), std::string::npos) << text();
}

TEST(DriverFault, NobodyKnowsIsRefused) {
    effects::DeviceSettings sc2 = test_support::shipped_device("sc2");
    ASSERT_TRUE(sc2.capability.gl.ignored_faults.try_push_back("gremlins"));
    auto surface = adreno();
    ASSERT_TRUE(surface->make_current());
    Gl gl;
    const auto opened = gl.open(*surface, sc2.capability);
    ASSERT_FALSE(opened.ok());
    EXPECT_NE(opened.error().message.view().find("'gremlins', which nobody knows"), std::string::npos);
    surface->release_current();
}

}  // namespace
}  // namespace tedavis::gl::test_driver_fault
