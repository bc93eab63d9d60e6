// Plugins and threads: instances side by side, a shared mesh, cancelling at any moment.
#include <atomic>
#include <chrono>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/generated_meshes.hpp"
#include "plugins/plugin_runs.hpp"

namespace talweg {
namespace {

using test::same_bits;

const talweg_plugin& smooth_plugin() { return test::plugin_of_this_build("talweg.smooth"); }

std::vector<host::Curve> sweep(host::Instance& instance) {
  std::vector<host::Curve> results;
  for (const double tau : {0.5, 3.0, 1.0}) {
    instance.set("tau", tau);
    results.push_back(instance.run().curves.at(0));
  }
  return results;
}

void expect_equal(const std::vector<host::Curve>& a, const std::vector<host::Curve>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_TRUE(same_bits(a[k], b[k])) << k;
}

TEST(PluginThreads, TwoMeshesInTwoThreads) {
  const test::Subject subject;
  const MeshLists sheet = test::grid(30, 20);
  host::Curve line;
  line.vertices = {100, 101, 133, 134, 135, 167, 199, 200};
  const host::Services services("test", "1");
  const auto on_hills = [&] {
    host::Instance instance(smooth_plugin(), services);
    test::set_mesh(instance, subject.lists);
    instance.set_curves({subject.curve});
    return sweep(instance);
  };
  const auto on_sheet = [&] {
    host::Instance instance(smooth_plugin(), services);
    test::set_mesh(instance, sheet);
    instance.set_curves({line});
    return sweep(instance);
  };
  const auto hills = on_hills(), flat = on_sheet();
  for (int round = 0; round < 3; ++round) {
    std::vector<host::Curve> first, second;
    std::thread one([&] { first = on_hills(); });
    std::thread two([&] { second = on_sheet(); });
    one.join();
    two.join();
    expect_equal(first, hills);
    expect_equal(second, flat);
  }
}

TEST(PluginThreads, WorkspacesOnOneMesh) {
  const test::Subject subject;
  const host::Services services("test", "1");
  host::Instance owner(smooth_plugin(), services);
  test::set_mesh(owner, subject.lists);
  owner.set_curves({subject.curve});
  std::vector<std::vector<host::Curve>> results(3);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < results.size(); ++k) {
    threads.emplace_back([&, k] {
      host::Instance own(smooth_plugin(), services);
      own.share_mesh(owner);
      if (k == 0) own.set("potential", "paper");  // makes the factors that all would share
      own.set_curves({subject.curve});
      results[k] = sweep(own);
    });
  }
  const auto expected = sweep(owner);
  for (std::thread& thread : threads) thread.join();
  expect_equal(results[1], expected);
  expect_equal(results[2], expected);
}

TEST(PluginThreads, LoadersSideBySide) {
  std::vector<std::thread> threads;
  std::atomic<int> found = 0;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&found] {
      for (int round = 0; round < 10; ++round) {
        const test::Loader loader = test::open_loader();
        if (talweg_loader_find(loader.get(), "talweg.smooth") != nullptr) ++found;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(found, 40);
}

/// Runs with another thread that cancels after a random time; then the same without: the result is
/// the one of an instance that was never cancelled.
TEST(PluginThreads, CancelledAtTwoHundredRandomMoments) {
  const test::Subject subject;
  const host::Services services("test", "1");
  host::Instance instance(smooth_plugin(), services);
  test::set_mesh(instance, subject.lists);
  instance.set_curves({subject.curve});
  instance.set("potential", "paper");
  const auto began = std::chrono::steady_clock::now();
  const auto expected = instance.run();
  const auto whole = std::chrono::steady_clock::now() - began;

  std::mt19937 random(6);
  int cancelled = 0;
  for (int round = 0; round < 200; ++round) {
    // A new mesh now and then, so that the factors are made under way, too.
    if (round % 10 == 0) test::set_mesh(instance, subject.lists);
    instance.set_curves({subject.curve});
    instance.set("cap_corners", static_cast<double>(round % 2));  // solves anew
    const auto moment = whole * std::uniform_real_distribution<>(0, 1.2)(random);
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::duration_cast<std::chrono::microseconds>(moment));
      instance.cancel();
    });
    try {
      instance.run();
    } catch (const host::Error& error) {
      EXPECT_EQ(error.status(), static_cast<talweg_status>(TALWEG_CANCELLED)) << error.what();
      ++cancelled;
    }
    other.join();
  }
  EXPECT_LE(cancelled, 200);
  instance.reset("cap_corners");
  EXPECT_TRUE(same_bits(instance.run().curves.at(0), expected.curves.at(0)));
}

/// The same by the host's progress, call by call: every one of them ends the run.
TEST(PluginThreads, CancelledAtEveryProgress) {
  const test::Subject subject;
  for (const char* potential : {"corridor", "paper"}) {
    int calls_left = 1 << 30, calls = 0;
    const host::Services services("test", "1", [&](const char* stage, double fraction) {
      EXPECT_NE(stage, nullptr);
      EXPECT_GE(fraction, 0);
      EXPECT_LE(fraction, 1);
      ++calls;
      return --calls_left > 0;
    });
    host::Instance instance(smooth_plugin(), services);
    instance.set("potential", potential);
    MeshLists another = subject.lists;
    another.points.front() *= 1.001;
    const auto begin = [&] {
      test::set_mesh(instance, another);  // else the mesh is known, with what was computed for it
      test::set_mesh(instance, subject.lists);
      instance.set_curves({subject.curve});
      calls = 0;
    };
    begin();
    const host::Curve expected = instance.run().curves.at(0);
    const int all = calls;
    EXPECT_GT(all, 2) << potential;
    for (int k = 1; k <= all; k += 1 + all / 50) {
      begin();
      calls_left = k;
      try {
        instance.run();
        ADD_FAILURE() << "not cancelled at call " << k << " of " << all << ", " << potential;
      } catch (const host::Error& error) {
        EXPECT_EQ(error.status(), static_cast<talweg_status>(TALWEG_CANCELLED));
      }
      calls_left = 1 << 30;
      EXPECT_TRUE(same_bits(instance.run().curves.at(0), expected)) << k;
    }
  }
}

}  // namespace
}  // namespace talweg
