// The loader: searched folders, refused files with the reasons, and loading of all other files.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/temporary_folder.hpp"
#include "places.hpp"
#include "plugins/plugin_runs.hpp"

namespace talweg {
namespace {

namespace fs = std::filesystem;

class LoaderTest : public test::TemporaryFolder {
 protected:
  void put(const char* toy, const std::string& name) const {
    fs::create_directories(file(name).parent_path());
    fs::copy_file(fs::path(test::toy_folder()) / (std::string(toy) + ".so"), file(name));
  }
  [[nodiscard]] test::Loader open() const {
    return test::Loader(talweg_loader_open(file("").c_str()));
  }
  /// Refused files: pairs of file name and reason.
  static std::map<std::string, std::string> refused(const test::Loader& loader) {
    std::map<std::string, std::string> result;
    for (std::uint64_t k = 0; k < talweg_loader_refused_count(loader.get()); ++k) {
      result[fs::path(talweg_loader_refused_path(loader.get(), k)).filename()] =
          talweg_loader_refused_reason(loader.get(), k);
    }
    return result;
  }
  void expect_refused(const char* toy, const std::string& reason) const {
    put(toy, "a.so");
    const test::Loader loader = open();
    EXPECT_EQ(talweg_loader_count(loader.get()), 0U) << toy;
    const auto all = refused(loader);
    ASSERT_EQ(all.size(), 1U) << toy;
    EXPECT_NE(all.begin()->second.find(reason), std::string::npos)
        << toy << ": " << all.begin()->second;
    fs::remove(file("a.so"));
  }
};

double run_toy(const talweg_plugin& plugin, const talweg_host* host, const char* key) {
  talweg_instance* instance = nullptr;
  EXPECT_EQ(plugin.create(host, &instance), TALWEG_OK);
  const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t triangle[] = {0, 1, 2};
  const talweg_mesh mesh = {sizeof mesh, 0, plugin::view(xyz, 3, 3), plugin::view(triangle, 1, 3),
                            nullptr};
  EXPECT_EQ(plugin.set_mesh(instance, &mesh), TALWEG_OK);
  std::map<std::string, double> report;
  const talweg_sink sink = {sizeof sink,
                            0,
                            &report,
                            nullptr,
                            nullptr,
                            [](void* context, const talweg_report_entry* entry) -> talweg_status {
                              (*static_cast<std::map<std::string, double>*>(context))[entry->key] =
                                  entry->numbers[0];
                              return TALWEG_OK;
                            },
                            nullptr};
  EXPECT_EQ(plugin.run(instance, &sink), TALWEG_OK);
  plugin.destroy(instance);
  return report.at(key);
}

extern "C" const talweg_module* toy_linked_entry(std::uint32_t major, std::uint32_t minor);

const talweg_module* no_entry(std::uint32_t, std::uint32_t) { return nullptr; }

TEST_F(LoaderTest, LinkedModulesComeBeforeModulesOfFiles) {
  put("plain", "plain.so");
  const talweg_linked_module linked[] = {
      {"no use", no_entry}, {"linked", toy_linked_entry}, {"again", toy_linked_entry}};
  const test::Loader alone(talweg_loader_open_linked(linked, 2, nullptr));
  ASSERT_EQ(talweg_loader_count(alone.get()), 1U);
  EXPECT_STREQ(talweg_loader_plugin(alone.get(), 0)->id, "toy.linked");
  EXPECT_STREQ(talweg_loader_path(alone.get(), 0), "linked");
  EXPECT_STREQ(talweg_loader_folders(alone.get()), "");

  const test::Loader both(talweg_loader_open_linked(linked, 3, file("").c_str()));
  ASSERT_EQ(talweg_loader_count(both.get()), 2U);
  const talweg_plugin* plugin = talweg_loader_find(both.get(), "toy.linked");
  ASSERT_NE(plugin, nullptr);
  EXPECT_EQ(run_toy(*plugin, nullptr, "vertices"), 3);
  EXPECT_NE(talweg_loader_find(both.get(), "toy.count"), nullptr);
  const auto why = refused(both);
  ASSERT_EQ(why.size(), 2U);
  EXPECT_NE(why.at("no use").find("does not work with hosts"), std::string::npos);
  EXPECT_NE(why.at("again").find("found already, in linked"), std::string::npos);
}

TEST_F(LoaderTest, PluginsOfGoodModulesAreLoaded) {
  put("plain", "plain.so");
  const test::Loader loader = open();
  ASSERT_EQ(talweg_loader_count(loader.get()), 1U);
  const talweg_plugin* plugin = talweg_loader_find(loader.get(), "toy.count");
  ASSERT_NE(plugin, nullptr);
  EXPECT_EQ(talweg_loader_plugin(loader.get(), 0), plugin);
  EXPECT_EQ(talweg_loader_path(loader.get(), 0), file("plain.so").string());
  EXPECT_EQ(run_toy(*plugin, nullptr, "vertices"), 3);
  EXPECT_EQ(talweg_loader_find(loader.get(), "toy.other"), nullptr);
}

TEST_F(LoaderTest, OtherMajorVersionsAreRefusedAndNewerMinorVersionsWork) {
  expect_refused("older_major", "made for the plugin interface 0.9, but this host has 1.2");
  expect_refused("newer_major", "made for the plugin interface 2.0, but this host has 1.2");
  expect_refused("needs_newer", "needs the plugin interface 1.5, but this host has 1.2");
  expect_refused("refuses_host", "does not work with hosts of the plugin interface 1.2");
  put("newer_minor", "newer.so");
  const test::Loader loader = open();
  const talweg_plugin* newer = talweg_loader_find(loader.get(), "toy.newer");
  ASSERT_NE(newer, nullptr);
  // The plugin does without the extension in an older host, and asks a newer host for it.
  const host::Services services("test", "1");
  EXPECT_EQ(run_toy(*newer, services.host(), "of_tomorrow"), -1);
  talweg_host of_tomorrow = *services.host();
  of_tomorrow.interface_minor = 7;
  EXPECT_EQ(run_toy(*newer, &of_tomorrow, "of_tomorrow"), 0);
}

TEST_F(LoaderTest, ANewerHostRunsOurPlugins) {
  talweg_host newer = {};
  newer.size = sizeof newer + 64;  // as if a newer interface had more members
  newer.interface_major = TALWEG_INTERFACE_MAJOR;
  newer.interface_minor = TALWEG_INTERFACE_MINOR + 9;
  talweg_instance* instance = nullptr;
  const talweg_plugin& smooth = test::plugin_of_this_build("talweg.smooth");
  EXPECT_EQ(smooth.create(&newer, &instance), TALWEG_OK);
  smooth.destroy(instance);
}

TEST_F(LoaderTest, FilesThatAreNoPluginsAreRefusedAndLoadingContinues) {
  put("plain", "z.so");
  put("foreign", "foreign.so");
  put("small_module", "small.so");
  put("no_plugins", "none.so");
  put("twice", "twice.so");
  put("bad_default", "default.so");
  put("bad_id", "id.so");
  put("lacks_function", "lacks.so");
  write("text.so", "This is not a library.\n");
  write("empty.so", "");
  write("notes.txt", "not looked at");
  fs::create_directory(file("folder.so"));
  fs::create_symlink(file("nowhere"), file("dangling.so"));
  const std::string whole = bytes_of(fs::path(test::toy_folder()) / "plain.so");
  write("half.so", whole.substr(0, 5000));  // before the end of the loaded segments
  write("header.so", whole.substr(0, 40));
  std::string other_machine = whole;
  other_machine[18] = 0x28;  // ARM
  write("machine.so", other_machine);

  const test::Loader loader = open();
  ASSERT_EQ(talweg_loader_count(loader.get()), 1U);
  EXPECT_NE(talweg_loader_find(loader.get(), "toy.count"), nullptr);
  const auto all = refused(loader);
  const std::map<std::string, std::string> expected = {
      {"foreign.so", "no symbol talweg_plugin_entry"},
      {"small.so", "too small"},
      {"none.so", "no plugins"},
      {"twice.so", "listed twice"},
      {"default.so", "parameter weight that has a default out of its range"},
      {"id.so", "without a proper id"},
      {"lacks.so", "lacks a function"},
      {"text.so", "not a shared library"},
      {"empty.so", "not a shared library"},
      {"folder.so", "not a file"},
      {"dangling.so", "cannot be opened"},
      {"half.so", "ends too early"},
      {"header.so", "not a shared library"},
      {"machine.so", "cannot be loaded"}};
  EXPECT_EQ(all.size(), expected.size());
  for (const auto& [name, reason] : expected) {
    ASSERT_TRUE(all.contains(name)) << name;
    EXPECT_NE(all.at(name).find(reason), std::string::npos) << name << ": " << all.at(name);
    EXPECT_EQ(all.at(name).back(), '.') << name;
  }
}

TEST_F(LoaderTest, CutOffLibrariesAreLoadedOrRefused) {
  const std::string whole = bytes_of(fs::path(test::toy_folder()) / "plain.so");
  for (std::size_t bytes = 0; bytes < whole.size(); bytes += 1 + whole.size() / 60) {
    write("a.so", whole.substr(0, bytes));
    const test::Loader loader = open();  // section headers at the end are not needed
    EXPECT_EQ(talweg_loader_count(loader.get()) + talweg_loader_refused_count(loader.get()), 1U);
  }
}

TEST_F(LoaderTest, OfPluginsWithTheSameIdTheFirstIsKept) {
  put("plain", "one/a.so");
  put("plain", "two/a.so");
  put("newer_minor", "two/b.so");
  const std::string folders =
      file("one").string() + "::" + file("missing").string() + ":" + file("two").string();
  const test::Loader loader(talweg_loader_open(folders.c_str()));
  EXPECT_EQ(talweg_loader_count(loader.get()), 2U);
  EXPECT_EQ(talweg_loader_path(loader.get(), 0), file("one/a.so").string());
  ASSERT_EQ(talweg_loader_refused_count(loader.get()), 1U);
  EXPECT_NE(std::string(talweg_loader_refused_reason(loader.get(), 0)).find("one/a.so"),
            std::string::npos);
}

TEST_F(LoaderTest, OnlyTheNamedFoldersAreSearched) {
  put("plain", "mine/a.so");
  setenv("TALWEG_PLUGIN_PATH", file("mine").c_str(), 1);
  const test::Loader loader(talweg_loader_open(nullptr));
  unsetenv("TALWEG_PLUGIN_PATH");
  EXPECT_NE(talweg_loader_find(loader.get(), "toy.count"), nullptr);
  const std::string folders = talweg_loader_folders(loader.get());
  EXPECT_EQ(folders.find(file("mine").string() + ":"), 0U) << folders;
  EXPECT_LE(std::count(folders.begin(), folders.end(), ':'), 3) << folders;
  // This program lies in the build's bin, so the plugins of the build are found as well.
  EXPECT_NE(talweg_loader_find(loader.get(), "talweg.smooth"), nullptr) << folders;
  const test::Loader without(talweg_loader_open(nullptr));
  EXPECT_EQ(talweg_loader_find(without.get(), "toy.count"), nullptr);
}

TEST_F(LoaderTest, NullArgumentsGiveNullOrEmptyResults) {
  EXPECT_EQ(talweg_loader_count(nullptr), 0U);
  EXPECT_EQ(talweg_loader_plugin(nullptr, 0), nullptr);
  EXPECT_EQ(talweg_loader_find(nullptr, "a"), nullptr);
  EXPECT_EQ(talweg_loader_path(nullptr, 0), nullptr);
  EXPECT_EQ(talweg_loader_refused_count(nullptr), 0U);
  EXPECT_EQ(talweg_loader_refused_path(nullptr, 0), nullptr);
  EXPECT_EQ(talweg_loader_refused_reason(nullptr, 0), nullptr);
  EXPECT_EQ(talweg_loader_folders(nullptr), nullptr);
  talweg_loader_close(nullptr);
  const test::Loader loader = open();
  EXPECT_EQ(talweg_loader_find(loader.get(), nullptr), nullptr);
  EXPECT_EQ(talweg_loader_plugin(loader.get(), 7), nullptr);
  EXPECT_EQ(talweg_loader_path(loader.get(), 7), nullptr);
  EXPECT_EQ(talweg_loader_refused_path(loader.get(), 7), nullptr);
}

TEST_F(LoaderTest, AllPluginsOfTalwegAreInOneModule) {
  const test::Loader loader = test::open_loader();
  ASSERT_GE(talweg_loader_count(loader.get()), 12U);
  const std::string path = talweg_loader_path(loader.get(), 0);
  EXPECT_EQ(fs::path(path).filename(), "talweg_methods.so");
  for (std::uint64_t k = 0; k < talweg_loader_count(loader.get()); ++k) {
    EXPECT_EQ(talweg_loader_path(loader.get(), k), path);
    EXPECT_EQ(std::string(talweg_loader_plugin(loader.get(), k)->id).rfind("talweg.", 0), 0U);
  }
}

/// One process may have several versions of Talweg, each in a host of its own.
TEST_F(LoaderTest, TwoCopiesOfOneModuleShareNothing) {
  const test::Loader first = test::open_loader();
  fs::copy_file(talweg_loader_path(first.get(), 0), file("copy.so"));
  const test::Loader second = open();
  EXPECT_EQ(talweg_loader_count(second.get()), talweg_loader_count(first.get()));
  const talweg_plugin* ours = talweg_loader_find(first.get(), "talweg.smooth");
  const talweg_plugin* theirs = talweg_loader_find(second.get(), "talweg.smooth");
  ASSERT_NE(ours, nullptr);
  ASSERT_NE(theirs, nullptr);
  EXPECT_NE(ours, theirs);
  talweg_instance* instance = nullptr;
  ASSERT_EQ(ours->create(nullptr, &instance), TALWEG_OK);
  EXPECT_EQ(theirs->set_number(instance, "tau", 2),
            TALWEG_BAD_USAGE);  // the instance belongs to the other copy
  EXPECT_EQ(ours->set_number(instance, "tau", 2), TALWEG_OK);
  ours->destroy(instance);
}

TEST_F(LoaderTest, LoadsAndUnloadsAThousandTimes) {
  const test::Subject subject;
  for (int k = 0; k < 1000; ++k) {
    const test::Loader loader = test::open_loader();
    const talweg_plugin* plugin = talweg_loader_find(loader.get(), "talweg.smooth");
    ASSERT_NE(plugin, nullptr);
    if (k % 250 != 0) continue;  // a run now and then allocates memory that must be freed
    const host::Services services("test", "1");
    host::Instance instance(*plugin, services);
    test::set_mesh(instance, subject.lists);
    instance.set_curves({subject.curve});
    EXPECT_EQ(instance.run().text("termination"), "converged");
  }
}

}  // namespace
}  // namespace talweg
