#include "mpm/files/frame_writer.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mpm/files/atomic_file.h"
#include "tests/scratch_directory.h"

using namespace zona::mpm;
using zona::tests::ScratchDirectory;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

PointCloud tetrahedron(double x) {
  PointCloud cloud;
  cloud.name = "zona";
  cloud.positions = {x, 0, 0, x + 1e-6, 0, 0, x, 1e-6, 0, x, 0, 1e-6};
  cloud.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  cloud.fields["failed"] = {0, 1, 0, 0.1};
  cloud.fields["velocity"] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  return cloud;
}

PointCloud dots() {
  return {"medium", {0, 0, 0, 1, 1, 1}, {}, {{"pressure", {1e3, -1e3}}}};
}

}  // namespace

TEST_CASE("frames are read back with physical times, positions and fields", "[frames]") {
  const ScratchDirectory scratch;
  const std::string& folder = scratch.path();
  FrameWriter writer(folder);
  writer.add_frame(0, {tetrahedron(0), dots()});
  writer.add_frame(1e-6 / 3, {tetrahedron(1e-3), dots(), {"empty", {}, {}, {}}});

  const Hdf5File file = Hdf5File::open(folder + "/fields.h5");
  CHECK(file.children("/frames") == std::vector<std::string>{"000000", "000001"});
  CHECK(file.read_attribute<double>("/frames/000001", "time") == 1e-6 / 3);
  CHECK(file.shape("/frames/000001/zona/positions") == std::vector<std::size_t>{4, 3});
  CHECK(file.read<float>("/frames/000001/zona/positions")[3] == float(1e-3 + 1e-6));
  CHECK(file.read<float>("/frames/000000/zona/fields/failed")[3] == 0.1f);
  CHECK(file.shape("/frames/000000/zona/fields/velocity") == std::vector<std::size_t>{4, 3});
  CHECK(file.read<float>("/frames/000000/medium/fields/pressure")[1] == -1e3f);
  CHECK_FALSE(file.contains("/frames/000001/empty"));
}

TEST_CASE("triangles are stored once while they stay the same", "[frames]") {
  const ScratchDirectory scratch;
  const std::string& folder = scratch.path();
  FrameWriter writer(folder);
  for (int i = 0; i < 3; ++i) writer.add_frame(i, {tetrahedron(0)});
  PointCloud torn = tetrahedron(0);
  torn.triangles.pop_back();
  writer.add_frame(3, {torn});
  writer.add_frame(4, {torn});

  const Hdf5File file = Hdf5File::open(folder + "/fields.h5");
  CHECK(file.children("/topology/zona") == std::vector<std::string>{"000000", "000003"});
  CHECK(file.read<std::int32_t>("/topology/zona/000000").size() == 12);
  CHECK(file.read_attribute<std::string>("/frames/000002/zona", "topology") ==
        "/topology/zona/000000");
  CHECK(file.read_attribute<std::string>("/frames/000004/zona", "topology") ==
        "/topology/zona/000003");
}

TEST_CASE("three points and the triangle over them are different topologies", "[frames]") {
  const ScratchDirectory scratch;
  FrameWriter writer(scratch.path());
  PointCloud cloud{"a", {0, 0, 0, 1, 0, 0, 0, 1, 0}, {}, {}};
  writer.add_frame(0, {cloud});
  cloud.triangles = {{0, 1, 2}};
  writer.add_frame(1, {cloud});
  const Hdf5File file = Hdf5File::open(scratch / "fields.h5");
  CHECK(file.shape("/topology/a/000000") == std::vector<std::size_t>{3, 1});
  CHECK(file.shape("/topology/a/000001") == std::vector<std::size_t>{1, 3});
}

TEST_CASE("the XDMF file is closed after every frame and points to existing data", "[frames]") {
  const ScratchDirectory scratch;
  const std::string& folder = scratch.path();
  FrameWriter writer(folder, PositionPrecision::double_precision);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    const std::string text = text_of(folder + "/fields.xdmf");
    CHECK(count(text, "<Time Value=") == frame);
    CHECK(count(text, "<Grid ") == count(text, "</Grid>"));
    CHECK(count(text, "</Xdmf>") == 1);
    writer.add_frame(1e-7 * static_cast<double>(frame), {tetrahedron(0), dots()});
  }
  const std::string text = text_of(folder + "/fields.xdmf");
  CHECK(count(text, "Precision=\"8\"") == 8);
  std::size_t references = 0;
  for (auto at = text.find(">fields/"); at != std::string::npos;
       at = text.find(">fields/", at), ++references) {
    const auto colon = text.find(':', ++at);
    const Hdf5File file = Hdf5File::open(folder + "/" + text.substr(at, colon - at));
    CHECK(file.contains(text.substr(colon + 1, text.find('<', colon) - colon - 1)));
  }
  CHECK(references == 4 * 7);
  CHECK_FALSE(std::filesystem::exists(folder + "/fields.xdmf.tmp"));
}

TEST_CASE("a resumed run writes the same files as an uninterrupted one", "[frames]") {
  const ScratchDirectory scratch, whole;
  const auto add = [](FrameWriter& writer, int i) {
    PointCloud torn = tetrahedron(i);
    if (i > 0) torn.triangles.pop_back();
    writer.add_frame(i, {torn, dots()});
  };
  {
    FrameWriter writer(whole.path());
    for (int i = 0; i < 6; ++i) add(writer, i);
    FrameWriter interrupted(scratch.path());
    for (int i = 0; i < 5; ++i) add(interrupted, i);
  }
  std::ofstream(scratch / "fields/000005.h5.tmp") << "killed while writing";
  std::ofstream(scratch / "fields.h5.tmp") << "killed while writing";
  FrameWriter writer = FrameWriter::resume(scratch.path(), 2.0);
  CHECK(writer.frame_count() == 3);
  CHECK(count(text_of(scratch / "fields.xdmf"), "<Time Value=") == 3);
  CHECK_THROWS_AS(writer.add_frame(2.0, {}), std::invalid_argument);
  for (int i = 3; i < 6; ++i) add(writer, i);
  const auto same = [&](const std::string& name) {
    CHECK(text_of(scratch / name) == text_of(whole / name));
  };
  same("fields.h5");
  same("fields.xdmf");
  for (const char* frame : {"0", "1", "2", "3", "4", "5"})
    same(std::string("fields/00000") + frame + ".h5");
  CHECK_FALSE(std::filesystem::exists(scratch / "fields/000005.h5.tmp"));
}

TEST_CASE("inconsistent clouds are refused with the cloud's name and not written", "[frames]") {
  const ScratchDirectory scratch;
  const std::string& folder = scratch.path();
  FrameWriter writer(folder);
  const auto refused = [&](const std::vector<PointCloud>& clouds, const std::string& part) {
    CHECK_THROWS_WITH(writer.add_frame(0, clouds), Catch::Contains(part));
  };
  PointCloud cloud = tetrahedron(0);
  cloud.positions.pop_back();
  refused({cloud}, "'zona': 11 coordinates");
  cloud = tetrahedron(0);
  cloud.fields["failed"].pop_back();
  refused({cloud}, "field 'failed' has 3 values for 4 points");
  cloud = tetrahedron(0);
  cloud.triangles.push_back({0, 1, 4});
  refused({cloud}, "corner 4 of 4 points");
  cloud = tetrahedron(0);
  cloud.name = "a/b";
  refused({cloud}, "letters");
  refused({dots(), dots()}, "'medium': occurs twice");
  CHECK_THROWS_WITH(writer.add_frame(std::nan(""), {}), Catch::Contains("finite"));
  CHECK(writer.frame_count() == 0);
  CHECK(Hdf5File::open(folder + "/fields.h5").children("/frames").empty());
  CHECK_THROWS_AS(FrameWriter("/proc/no/such/folder"), FileError);
}
