// The march from given sources, on flat grids of unit squares.
#include "talweg/intrinsic/exact_distance/window_front.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "intrinsic/test_surfaces.hpp"

namespace talweg {
namespace {

constexpr std::size_t kSide = 6;
constexpr double kMarched = 1e-9;

class MarchOnAGrid : public testing::Test {
 protected:
  static double from_origin(std::size_t v) {
    return std::hypot(static_cast<double>(v % (kSide + 1)), static_cast<double>(v / (kSide + 1)));
  }
  void march_to_the_end(WindowFront& front) const {
    while (!front.is_done()) front.march();
  }

  const Surface surface_ = test::surface_of(test::grid(kSide, kSide));
  WindowFront front_{surface_};
};

TEST_F(MarchOnAGrid, FromACornerIsEuclidean) {
  front_.reset(0.25);
  front_.start_at(VertexId{0}, {0, 7, 2});
  march_to_the_end(front_);
  for (std::size_t v = 0; v < surface_.vertex_count(); ++v) {
    const NearestOnCurve& nearest = front_.vertices()[VertexId{v}];
    EXPECT_NEAR(nearest.distance, from_origin(v), kMarched);
    EXPECT_EQ(nearest.curve, 7U);
    EXPECT_EQ(nearest.arc_length, 2);
  }
  // (3.5, 2) is the middle of the edge from (3, 2) to (4, 2).
  const HalfedgeId h = surface_.find_halfedge(VertexId{3 + 2 * 7}, VertexId{4 + 2 * 7});
  EXPECT_NEAR(front_.on_edge(edge_of(h), 0.5).distance, std::hypot(3.5, 2), kMarched);
  EXPECT_TRUE(std::isinf(front_.distance()));
}

TEST_F(MarchOnAGrid, DistancesBehindTheFrontAreFinal) {
  front_.reset(0.25);
  front_.start_at(VertexId{0}, {0, 0, 0});
  double before = 0;
  while (!front_.is_done()) {
    front_.march();
    EXPECT_GE(front_.distance(), before);
    before = front_.distance();
    for (std::size_t v = 0; v < surface_.vertex_count(); ++v) {
      const double known = front_.vertices()[VertexId{v}].distance;
      if (front_.is_final(known)) {
        EXPECT_NEAR(known, from_origin(v), kMarched);
      }
    }
  }
}

TEST_F(MarchOnAGrid, WindowsCanBeSourcesAndAreForgotten) {
  front_.reset(0.25);
  front_.start_at(VertexId{0}, {0, 0, 0});
  march_to_the_end(front_);
  // A source 0.5 above the base of the first face, in the frame of the face.
  front_.reset(0.25);
  EXPECT_EQ(front_.windows().size(), 0U);
  EXPECT_TRUE(std::isinf(front_.vertices()[VertexId{0}].distance));
  EdgeWindow window;
  window.end = 1;
  window.px = 0.75;
  window.py = 0.5;
  window.into = twin(surface_.find_halfedge(VertexId{0}, VertexId{1}));
  front_.send(window);
  march_to_the_end(front_);
  EXPECT_NEAR(front_.vertices()[VertexId{0}].distance, std::hypot(0.75, 0.5), kMarched);
  EXPECT_NEAR(front_.vertices()[VertexId{1}].distance, std::hypot(0.25, 0.5), kMarched);
}

TEST_F(MarchOnAGrid, WithoutRoomDistancesFartherOutAreLonger) {
  front_.reset(0.25, {12, 0, 1000});
  front_.start_at(VertexId{0}, {0, 0, 0});
  EXPECT_TRUE(std::isinf(front_.exact_within()));
  march_to_the_end(front_);
  EXPECT_LE(front_.windows().size(), 13U);
  const double exact = front_.exact_within();
  EXPECT_GT(exact, 0.2);
  EXPECT_LT(exact, 6);
  int longer = 0;
  for (std::size_t v = 0; v < surface_.vertex_count(); ++v) {
    const double known = front_.vertices()[VertexId{v}].distance, true_one = from_origin(v);
    if (true_one <= exact) {
      EXPECT_NEAR(known, true_one, kMarched);
    }
    EXPECT_GE(known, true_one - kMarched);
    EXPECT_LE(known, true_one * std::sqrt(2.0) + kMarched);  // at most the distance along edges
    if (known > true_one + 0.1) ++longer;
  }
  EXPECT_GT(longer, 0);
  front_.reset(0.25);
  EXPECT_TRUE(std::isinf(front_.exact_within()));
}

TEST_F(MarchOnAGrid, ContinuesWhereItWasInterrupted) {
  WindowFront whole(surface_);
  for (WindowFront* front : {&whole, &front_}) {
    front->reset(0.25);
    front->start_at(VertexId{0}, {0, 0, 0});
  }
  march_to_the_end(whole);
  int asked = 0;
  ProgressPoller poller([&](const char*, double) { return ++asked % 2 == 1; }, "march");
  front_.work().set_poller(&poller);
  int interrupted = 0;
  while (!front_.is_done()) {
    front_.work().add(ProgressPoller::kEvery);  // the poller is called at once
    try {
      front_.march();
    } catch (const Cancelled&) {
      ++interrupted;
    }
  }
  EXPECT_GT(interrupted, 3);
  for (std::size_t v = 0; v < surface_.vertex_count(); ++v) {
    EXPECT_EQ(front_.vertices()[VertexId{v}].distance, whole.vertices()[VertexId{v}].distance);
  }
  EXPECT_EQ(front_.windows().size(), whole.windows().size());
}

}  // namespace
}  // namespace talweg
