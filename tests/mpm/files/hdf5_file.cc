#include "mpm/files/hdf5_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/scratch_directory.h"

using zona::mpm::Hdf5Error;
using zona::mpm::Hdf5File;

using zona::tests::ScratchDirectory;

TEST_CASE("HDF5 datasets and attributes are read back to the last bit", "[hdf5]") {
  const ScratchDirectory scratch;
  const std::string path = scratch / "round_trip.h5";
  const std::vector<double> doubles{0.1, -1e-300, 3.0, 1.0 / 3, 5.5, -0.0};
  {
    Hdf5File file = Hdf5File::create(path);
    file.write("/a/b/doubles", doubles, {2});
    file.write("/a/floats", std::vector<float>{0.1f, 2.0f});
    file.write("/integers", std::vector<std::int32_t>{-7, 2147483647});
    file.write("/long", std::vector<std::int64_t>{std::int64_t{1} << 62});
    file.write("/nothing", std::vector<double>{}, {3});
    file.write_attribute("/a", "time", 1e-6 / 3);
    file.write_attribute("/a", "time", 2e-6 / 3);
    file.write_attribute("/a/floats", "steps", std::int64_t{-3});
    file.write_attribute("/", "name", "µm of glass");
    file.write_attribute("/", "empty", "");
  }
  const Hdf5File file = Hdf5File::open(path);
  CHECK(file.read<double>("/a/b/doubles") == doubles);
  CHECK(file.shape("/a/b/doubles") == std::vector<std::size_t>{3, 2});
  CHECK(file.read<float>("/a/floats") == std::vector<float>{0.1f, 2.0f});
  CHECK(file.read<double>("/a/floats")[0] == double{0.1f});
  CHECK(file.read<std::int32_t>("/integers") == std::vector<std::int32_t>{-7, 2147483647});
  CHECK(file.read<std::int64_t>("/long")[0] == std::int64_t{1} << 62);
  CHECK(file.read<double>("/nothing").empty());
  CHECK(file.read_attribute<double>("/a", "time") == 2e-6 / 3);
  CHECK(file.read_attribute<std::int64_t>("/a/floats", "steps") == -3);
  CHECK(file.read_attribute<std::string>("/", "name") == "µm of glass");
  CHECK(file.read_attribute<std::string>("/", "empty").empty());
  CHECK(file.children("/") == std::vector<std::string>{"a", "integers", "long", "nothing"});
}

TEST_CASE("an HDF5 file lists its contents and refuses writes after it is closed", "[hdf5]") {
  const ScratchDirectory scratch;
  const std::string path = scratch / "closed.h5";
  Hdf5File writer = Hdf5File::create(path);
  writer.write("/first", std::vector<double>{1});
  writer.close();
  CHECK_THROWS_AS(writer.write("/second", std::vector<double>{2}), Hdf5Error);
  const Hdf5File reader = Hdf5File::open(path);
  CHECK(reader.contains("/first"));
  CHECK_FALSE(reader.contains("/second"));
  CHECK_FALSE(reader.contains("/no/such/group"));
}

TEST_CASE("HDF5 errors name the file, the dataset and the problem", "[hdf5]") {
  const ScratchDirectory scratch;
  const std::string path = scratch / "errors.h5";
  Hdf5File file = Hdf5File::create(path);
  file.write("/numbers", std::vector<double>{1, 2});
  file.write_attribute("/", "name", "text");
  const auto message_of = [](auto&& action) {
    try {
      action();
    } catch (const Hdf5Error& error) {
      return std::string(error.what());
    }
    return std::string("nothing thrown");
  };
  using Catch::Contains;
  CHECK_THAT(message_of([&] { Hdf5File::open(scratch / "missing.h5"); }),
             Contains("missing.h5") && Contains("No such file"));
  CHECK_THAT(message_of([&] { Hdf5File::create("/no/such/folder/x.h5"); }),
             Contains("cannot create") && Contains("No such file"));
  CHECK_THAT(message_of([&] { file.read<double>("/none"); }),
             Contains("errors.h5: /none: cannot open the dataset"));
  CHECK_THAT(message_of([&] { file.read<std::int32_t>("/numbers"); }),
             Contains("/numbers: does not hold integers"));
  CHECK_THAT(message_of([&] { file.write("/numbers", std::vector<double>{3}); }),
             Contains("/numbers: cannot create the dataset") && Contains("exists"));
  CHECK_THAT(message_of([&] { file.write("/rows", std::vector<double>{3}, {2}); }),
             Contains("1 values do not fill rows of 2"));
  CHECK_THAT(message_of([&] { file.read_attribute<double>("/", "name"); }),
             Contains("/@name: is not of the requested type"));
  CHECK_THAT(message_of([&] { file.read_attribute<double>("/", "none"); }), Contains("/@none"));
  std::ofstream(scratch / "not_hdf5.h5") << "plain text";
  CHECK_THAT(message_of([&] { Hdf5File::open(scratch / "not_hdf5.h5"); }), Contains("not_hdf5.h5"));
}

TEST_CASE("a dataset that its file cannot hold is refused before memory is allocated", "[hdf5]") {
  const ScratchDirectory scratch;
  const std::string path = scratch / "claims.h5";
  constexpr std::uint64_t length = 12345;
  Hdf5File::create(path).write("/numbers", std::vector<double>(length));
  CHECK(Hdf5File::open(path).read<double>("/numbers").size() == length);
  const auto bytes_of = [](std::uint64_t number) {
    return std::string(reinterpret_cast<const char*>(&number), sizeof number);
  };
  for (const int power : {24, 50, 61}) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    std::string bytes = content.str();
    const std::string before = bytes_of(length), after = bytes_of(std::uint64_t{1} << power);
    for (auto at = bytes.find(before); at != std::string::npos; at = bytes.find(before))
      bytes.replace(at, before.size(), after);
    const std::string claim = scratch / "claim.h5";
    std::ofstream(claim, std::ios::binary) << bytes;
    CHECK_THROWS_WITH(Hdf5File::open(claim).read<double>("/numbers"),
                      Catch::Contains("/numbers: claims to have"));
  }
}

TEST_CASE("threads take turns with open files", "[hdf5]") {
  const ScratchDirectory scratch;
  const std::vector<double> values(1000, 0.1);
  const auto write_files = [&](const std::string& name) {
    for (int i = 0; i < 20; ++i) {
      Hdf5File file = Hdf5File::create(scratch / (name + ".h5"));
      for (const char* dataset : {"/a", "/b/c", "/b/d"}) file.write(dataset, values);
      file.close();
      CHECK(Hdf5File::open(scratch / (name + ".h5")).read<double>("/a") == values);
    }
  };
  std::thread one(write_files, "one"), two(write_files, "two");
  one.join();
  two.join();
  for (const char* name : {"one.h5", "two.h5"})
    CHECK(Hdf5File::open(scratch / name).read<double>("/b/d") == values);
}
