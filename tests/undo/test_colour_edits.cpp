// Edits of colours: from what was there when a drag began, one after the other; and swatches that paint is linked to.
#include "model/colour/colour_shift.h"
#include "model/formats/files.h"
#include "tests/undo/steps.h"
#include "undo/colour_edits.h"
#include "undo/swatch_edits.h"

#include <QTest>

using namespace suffuse;

namespace {

constexpr Colour red{1, 0, 0, 1}, blue{0, 0, 1, 1}, green{0, 1, 1, 1};

Stroke strokeOf(StrokeId id, const std::vector<Colour> &colours)
{
    Stroke stroke;
    stroke.id = id;
    for (const Colour &colour : colours) {
        const float x = float(30 * stroke.segments.size());
        Segment segment;
        segment.bezier = {Offset{x, 0}, {x + 10, 0}, {x + 20, 0}, {x + 30, 0}};
        segment.colour = colour;
        stroke.segments.push_back(segment);
    }
    return stroke;
}

/// Two strokes in red and blue, of which the second is thin, a third one that is locked, and two swatches.
PaintingPtr samplePainting(bool linked)
{
    Stroke thin = strokeOf(2, {withOpacity(red, 0.25f), blue}), locked = strokeOf(3, {red});
    locked.locked = true;
    auto painting = std::make_shared<Painting>();
    painting->strokes = {std::make_shared<const Stroke>(strokeOf(1, {red, blue})), std::make_shared<const Stroke>(thin),
                         std::make_shared<const Stroke>(locked)};
    painting->swatches = {{"sky", blue}, {"roof", red, linked}};
    return painting;
}

Colour colourOf(const Document &document, StrokeId stroke, std::size_t segment)
{
    return document.painting()->find(stroke)->segments[segment].colour;
}

} // namespace

class TestColourEdits : public QObject {
    Q_OBJECT

private slots:
    void oneTryAfterTheOther()
    {
        Document document;
        document.reset(samplePainting(false));
        const PaintingPtr before = document.painting();
        QUndoStack stack;
        const ColourParts parts = partsToColour(*before, {{1}, {}});
        const auto turned = [&](double hue) {
            return recolour(document, parts, [hue](const Colour &each) { return shifted(each, {.hue = hue}); });
        };
        pushStep(stack, document, turned(0.25));
        pushStep(stack, document, turned(1.0 / 3)); // of what was there, not of what is
        QCOMPARE(colourOf(document, 1, 0), shifted(red, {.hue = 1.0 / 3}));
        QVERIFY(turned(1.0 / 3).isEmpty());
        pushStep(stack, document, turned(0));
        QVERIFY(*document.painting() == *before);
        QCOMPARE(colourOf(document, 2, 0), withOpacity(red, 0.25f));
        stack.setIndex(0);
        QVERIFY(*document.painting() == *before);
    }

    void lockedOnesAndOthersAreLeftAlone()
    {
        Document document;
        document.reset(samplePainting(false));
        ColourParts parts = partsOfColour(*document.painting(), red);
        QCOMPARE(parts.size(), std::size_t(3));
        const auto toGreen = [](const Colour &each) { return withOpacity(green, each.opacity); };
        Edit edit = recolour(document, parts, toGreen);
        QCOMPARE(edit.strokes.size(), std::size_t(2)); // but not the locked one
        QCOMPARE(edit.strokes[2]->segments[0].colour, withOpacity(green, 0.25f));
        QCOMPARE(edit.strokes[2]->segments[1].colour, blue);
        // A stroke that has other segments by now is another one.
        parts[0].stroke = std::make_shared<const Stroke>(strokeOf(1, {red, blue, blue}));
        parts[0].chosen = {};
        QCOMPARE(recolour(document, parts, toGreen).strokes.size(), std::size_t(1));
        QVERIFY(recolour(document, parts, [](const Colour &) { return Colour{2, 0, 0, 1}; }).isEmpty());
    }

    void whatUsesALinkedSwatchFollowsIt()
    {
        Document document;
        document.reset(samplePainting(true));
        const PaintingPtr before = document.painting();
        QUndoStack stack;
        QVERIFY(usersOf(*before, 0).empty()); // not linked
        QVERIFY(usersOf(*before, 7).empty());
        const ColourParts users = usersOf(*before, 1);
        QCOMPARE(users.size(), std::size_t(3));
        pushStep(stack, document, changeSwatch(document, 1, green, users));
        QCOMPARE(stack.count(), 1);
        QCOMPARE(document.painting()->swatches[1], (Swatch{"roof", green, true}));
        QCOMPARE(colourOf(document, 1, 0), green);
        QCOMPARE(colourOf(document, 1, 1), blue);
        QCOMPARE(colourOf(document, 2, 0), withOpacity(green, 0.25f));
        QCOMPARE(colourOf(document, 3, 0), green); // locked, and linked
        // A drag through the colour of others takes none of them along.
        pushStep(stack, document, changeSwatch(document, 1, blue, users));
        pushStep(stack, document, changeSwatch(document, 1, green, users));
        QCOMPARE(colourOf(document, 1, 1), blue);
        QCOMPARE(colourOf(document, 2, 1), blue);
        stack.undo();
        stack.undo();
        stack.undo();
        QVERIFY(*document.painting() == *before);
        pushStep(stack, document, changeSwatch(document, 0, green, usersOf(*before, 0)));
        QCOMPARE(document.painting()->swatches[0].colour, green);
        QCOMPARE(colourOf(document, 1, 1), blue);
        QVERIFY(changeSwatch(document, 2, green, {}).isEmpty());
        QVERIFY(changeSwatch(document, 0, green, {}).isEmpty());
        QVERIFY(changeSwatch(document, 0, {0, -1, 0, 1}, {}).isEmpty());
    }

    /// Files know the link; those without one are what they were.
    void filesKnowTheLink()
    {
        const Painting linked = *samplePainting(true), plain = *samplePainting(false);
        QVERIFY(linked != plain);
        QVERIFY(hashOf(linked) != hashOf(plain));
        const QByteArray text = writeTextForm(linked), plainText = writeTextForm(plain);
        QVERIFY(text.contains("\"linked\": true") && !plainText.contains("linked"));
        QVERIFY(text.contains("\"version\": 2") && plainText.contains("\"version\": 1"));
        const Result<Painting> ofText = readTextForm(text, "a.json");
        QVERIFY2(ofText, ofText ? "" : qPrintable(ofText.error()));
        QVERIFY(*ofText == linked);
        QByteArray early = text;
        early.replace("\"version\": 2", "\"version\": 1");
        QVERIFY(!readTextForm(early, "a.json"));
        const Result<Painting> ofBytes = readSuffuseFile(writeSuffuseFile(linked), "a.suffuse");
        QVERIFY(ofBytes && *ofBytes == linked);
        const Result<Painting> again = readSuffuseFile(writeSuffuseFile(plain), "a.suffuse");
        QVERIFY(again && *again == plain);
        QVERIFY(!writeSuffuseFile(plain).contains("linked"));
    }
};

QTEST_GUILESS_MAIN(TestColourEdits)
#include "test_colour_edits.moc"
