#include "film/film_facts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace overfly {
namespace {

constexpr Float4 kUp{0.0F, 0.0F, 1.0F, 0.0F};

TEST(Quantities, AreThoseThatLayersAreMadeOf) {
    EXPECT_EQ(Quantities(LayerSet{}).count(), 0U);
    const Quantities few(LayerSet{Layer::Normal, Layer::Coverage});
    EXPECT_TRUE(few.has(Quantity::Normal));
    EXPECT_TRUE(few.has(Quantity::Surface));
    EXPECT_FALSE(few.has(Quantity::Motion));
    // What is averaged over surfaces needs to know how much of them there is.
    for (const Layer layer : {Layer::Position, Layer::Slope, Layer::Longitude, Layer::Mean})
        EXPECT_TRUE(Quantities(LayerSet{layer}).has(Quantity::Surface));
    EXPECT_EQ(Quantities(*layers_named("all")).count(), kQuantities);
    for (std::size_t slot = 0; slot < few.count(); ++slot) EXPECT_EQ(few.slot(few.at(slot)), slot);
}

FactKinds normals_and_cost() { return FactKinds(LayerSet{Layer::Normal, Layer::Cost, Layer::Id}); }

// A normal, seen with a weight by one of so many lines.
void tell(FilmFacts& facts, std::size_t pixel, float weight, Float4 normal, float lines) {
    Told told{};
    told[facts.kinds().quantities.slot(Quantity::Normal)] = normal;
    facts.add(pixel, weight, told);
    facts.count_surface(pixel, weight, lines);
    facts.objects().add(pixel, 3, weight);
}

TEST(FilmFacts, AreAveragedByWeightButWhatIsCountedIsNot) {
    FilmFacts facts(2, normals_and_cost());
    tell(facts, 1, 0.5F, kUp, 4.0F);
    tell(facts, 1, 1.5F, kUp, 4.0F);
    facts.divide(1, 2.0F);
    EXPECT_EQ(facts.value(1, Quantity::Normal)[2], 1.0F);
    EXPECT_EQ(facts.value(1, Quantity::Effort)[0], 4.0F);  // lines for each pixel
    EXPECT_EQ(facts.value(1, Quantity::Effort)[1], 2.0F);  // surfaces that they met
    EXPECT_EQ(facts.objects().of(1)[0], (ObjectShares::Share{3, 1.0F}));
    EXPECT_EQ(facts.value(0, Quantity::Normal)[2], 0.0F);
}

TEST(FilmFacts, OfTwoPicturesAreTheirMeanAndAllThatTheyCounted) {
    FilmFacts one(1, normals_and_cost()), other(1, normals_and_cost());
    tell(one, 0, 1.0F, kUp, 2.0F);
    tell(other, 0, 1.0F, 3.0F * kUp, 2.0F);
    one.join(other);
    EXPECT_EQ(one.value(0, Quantity::Normal)[2], 2.0F);
    EXPECT_EQ(one.value(0, Quantity::Effort)[0], 4.0F);
    EXPECT_EQ(one.value(0, Quantity::Effort)[1], 2.0F);
    EXPECT_EQ(one.objects().of(0)[0], (ObjectShares::Share{3, 1.0F}));
}

TEST(FilmFacts, OfATileAreAddedToTheWholePicture) {
    FilmFacts tile(1, normals_and_cost()), film(4, normals_and_cost());
    tell(tile, 0, 1.0F, kUp, 2.0F);
    film.add_from(tile, 0, 2, 0.25F);
    EXPECT_EQ(film.value(2, Quantity::Normal)[2], 0.25F);
    EXPECT_EQ(film.value(2, Quantity::Effort)[1], 1.0F);
    EXPECT_EQ(film.objects().of(2)[0], (ObjectShares::Share{3, 0.25F}));
}

TEST(ObjectShares, AreRankedByWeight) {
    ObjectShares shares(1);
    shares.add(0, 7, 0.25F);
    shares.add(0, 2, 0.5F);
    shares.add(0, 9, 0.125F);
    shares.add(0, 9, 0.125F);
    const ObjectShares::Pixel ranked = shares.ranked(0);
    EXPECT_EQ(ranked[0], (ObjectShares::Share{2, 0.5F}));
    EXPECT_EQ(ranked[1], (ObjectShares::Share{7, 0.25F}));
    EXPECT_EQ(ranked[2], (ObjectShares::Share{9, 0.25F}));
    EXPECT_EQ(ranked[3], ObjectShares::Share{});
}

TEST(ObjectShares, OfMoreThanAPixelHoldsLoseTheLeast) {
    ObjectShares shares(1);
    for (ObjectNumber object = 1; object <= ObjectShares::kMost; ++object)
        shares.add(0, object, 0.01F * static_cast<float>(object));
    shares.add(0, 100, 0.005F);
    EXPECT_EQ(std::ranges::count(shares.of(0), 100, &ObjectShares::Share::object), 0);
    shares.add(0, 101, 0.5F);
    EXPECT_EQ(shares.ranked(0)[0].object, 101);
    EXPECT_EQ(std::ranges::count(shares.of(0), 1, &ObjectShares::Share::object), 0);
}

}  // namespace
}  // namespace overfly
