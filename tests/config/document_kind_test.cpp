#include <gtest/gtest.h>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;

TEST(DocumentKindOf, IsSeenByTheKeys) {
    EXPECT_EQ(document_kind(good_folder / "terrain.yaml"), DocumentKind::Terrain);
    EXPECT_EQ(document_kind(good_folder / "flight.yaml"), DocumentKind::Flight);
    EXPECT_EQ(document_kind(good_folder / "shot.yaml"), DocumentKind::Shot);
    EXPECT_EQ(document_kind(good_folder / "batch.yaml"), DocumentKind::Batch);
}

TEST(DocumentKindOf, DoesNotCheckTheDocument) {
    const TemporaryFolder folder;
    EXPECT_EQ(document_kind(folder.write("a.yaml", "keyframes: none\nunknown: 1\n")), DocumentKind::Flight);
    EXPECT_EQ(document_kind(folder.write("b.yaml", "flight: 5\n")), DocumentKind::Shot);
}

TEST(DocumentKindOf, RefusesToGuess) {
    const TemporaryFolder folder;
    const std::string allowed =
        " kind of document, allowed one of: 'dem' (terrain), 'keyframes' (flight), 'terrain' and 'flight' (shot), "
        "'shots' (batch)";
    const std::string none = folder.write("a.yaml", "name: x\n").string();
    EXPECT_EQ(error_text([&] { (void)document_kind(none); }), none + ": got the keys of no" + allowed);
    const std::string two = folder.write("b.yaml", "dem: a.tif\nkeyframes: []\n").string();
    EXPECT_EQ(error_text([&] { (void)document_kind(two); }), two + ": got the keys of more than one" + allowed);
    const std::string empty = folder.write("c.yaml", "").string();
    EXPECT_EQ(error_text([&] { (void)document_kind(empty); }),
              empty + ":1:1: got an empty document, allowed a mapping (`key: value` lines)");
}

}  // namespace
}  // namespace overfly
