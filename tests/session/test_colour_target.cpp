// Whose colour is changed: the brush's, that of what is selected, or a swatch's. And Recolour Artwork without its
// dialog.
#include "app/session/colour/colour_target.h"
#include "app/session/colour/recolouring.h"
#include "app/session/commands/session_rows.h"
#include "app/session/settings/settings.h"
#include "undo/colour_edits.h"
#include "undo/edits.h"
#include "undo/swatch_edits.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;

namespace {

using Kind = ColourTarget::Kind;
using Mode = ColourTarget::Mode;
using ToolUse = ColourTarget::ToolUse;

constexpr Colour red{1, 0, 0, 1}, blue{0, 0, 1, 1}, green{0, 1, 1, 1}, violet{1, 0, 1, 1};
constexpr Colour thinRed{1, 0, 0, 0.25f}, dark{0.5f, 0.5f, 0.9f, 1}, sea{0, 0.2f, 1, 1};

StrokePtr strokeOf(StrokeId id, const std::vector<Colour> &colours)
{
    auto stroke = std::make_shared<Stroke>();
    stroke->id = id;
    for (const Colour &colour : colours) {
        const float x = float(30 * stroke->segments.size());
        Segment segment;
        segment.bezier = {Offset{x, 0}, {x + 10, 0}, {x + 20, 0}, {x + 30, 0}};
        segment.colour = colour;
        stroke->segments.push_back(segment);
    }
    return stroke;
}

/// A red stroke, one of two blues, a thin red one, and a locked one.
struct Work {
    Editor editor;
    ColourTarget &target = editor.colourTarget();
    PaintingPtr before;

    Work()
    {
        auto painting = std::make_shared<Painting>();
        Stroke locked = *strokeOf(4, {red});
        locked.locked = true;
        painting->strokes = {strokeOf(1, {red, red, red}), strokeOf(2, {blue, blue, dark}), strokeOf(3, {thinRed}),
                             std::make_shared<const Stroke>(locked)};
        painting->swatches = {{"roof", red, true}, {"sea", sea}};
        editor.document().reset(painting);
        editor.undoStack().clear();
        before = editor.document().painting();
        editor.setColour({0.2f, 0.3f, 0.4f, 0.5f});
    }
    Colour colour(StrokeId stroke, std::size_t segment = 0)
    {
        return editor.document().painting()->find(stroke)->segments[segment].colour;
    }
    void select(std::set<StrokeId> strokes, std::set<SegmentRef> segments = {})
    {
        editor.document().setSelection({std::move(strokes), std::move(segments)});
    }
    int steps() { return editor.undoStack().count(); }
    bool isAsBefore() { return *editor.document().painting() == *before; }
};

} // namespace

class TestColourTarget : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("colour"); }

    void theToolSaysWhoseColour()
    {
        Work w;
        QCOMPARE(w.target.kind(), Kind::Brush);
        w.select({1});
        QCOMPARE(w.target.kind(), Kind::Brush); // a brush is in the hand
        QVERIFY(w.target.canBeSelection());
        w.target.useTool(ToolUse::Refines);
        QCOMPARE(w.target.kind(), Kind::Selection);
        QCOMPARE(w.target.colour(), red);
        w.target.useTool(ToolUse::Either);
        QCOMPARE(w.target.kind(), Kind::Selection);
        w.select({});
        QCOMPARE(w.target.kind(), Kind::Brush);
        w.select({4}); // locked
        QCOMPARE(w.target.kind(), Kind::Brush);
        QVERIFY(!w.target.canBeSelection());
        w.select({1});
        w.target.choose(Kind::Brush);
        QCOMPARE(w.target.kind(), Kind::Brush);
        w.select({2});
        QCOMPARE(w.target.kind(), Kind::Brush); // until another tool is taken
        w.target.useTool(ToolUse::Paints);
        w.target.useTool(ToolUse::Refines);
        QCOMPARE(w.target.kind(), Kind::Selection);
        QCOMPARE(w.target.selected().segments, std::size_t(3));
        QVERIFY(w.target.selected().several);
        w.select({2}, {{2, 2}});
        QCOMPARE(w.target.selected().segments, std::size_t(1));
        QCOMPARE(w.target.colour(), dark);
        w.target.useTool(ToolUse::Paints);
        w.target.choose(Kind::Selection); // by hand, with the brush
        QCOMPARE(w.target.kind(), Kind::Selection);
        w.editor.newPainting({});
        QCOMPARE(w.target.kind(), Kind::Brush);
    }

    void theBrushKeepsItsOpacity()
    {
        Work w;
        QSignalSpy changed(&w.target, &ColourTarget::changed);
        w.target.setPaint(green);
        QCOMPARE(w.editor.brush().colour, (Colour{0, 1, 1, 0.5f}));
        QVERIFY(!changed.isEmpty());
        w.target.setOpacity(0.75f);
        QCOMPARE(w.editor.brush().colour.opacity, 0.75f);
        w.target.take(thinRed); // one that is thin brings its opacity
        QCOMPARE(w.editor.brush().colour, thinRed);
        w.target.take(blue);
        QCOMPARE(w.editor.brush().colour, (Colour{0, 0, 1, 0.25f}));
        QCOMPARE(w.steps(), 0);
        QVERIFY(w.isAsBefore());
    }

    void aDragOfOpacityKeepsWhatVaries()
    {
        Work w;
        w.target.useTool(ToolUse::Refines);
        w.select({1, 3}); // opacities 1 and 0.25
        ValueEntry entry;
        entry.beginDrag();
        w.target.setOpacity(0.9f, &entry);
        w.target.setOpacity(0.8f, &entry);
        entry.commitDrag();
        QVERIFY(std::abs(w.colour(1).opacity - 0.8f) < 1e-6f);
        QVERIFY(std::abs(w.colour(3).opacity - 0.05f) < 1e-6f);
        QCOMPARE(w.steps(), 1);
        w.target.setOpacity(0.5f); // a number
        QCOMPARE(w.colour(1).opacity, 0.5f);
        QCOMPARE(w.colour(3).opacity, 0.5f);
        w.editor.undoStack().undo();
        w.editor.undoStack().undo();
        QVERIFY(w.isAsBefore());
    }

    void allBecomeOne()
    {
        Work w;
        w.target.useTool(ToolUse::Refines);
        w.select({2, 3, 4});
        w.target.setPaint(green);
        QCOMPARE(w.colour(2, 0), green);
        QCOMPARE(w.colour(2, 2), green);
        QCOMPARE(w.colour(3), withOpacity(green, 0.25f));
        QCOMPARE(w.colour(4), red); // locked
        QCOMPARE(w.colour(1), red);
        QCOMPARE(w.steps(), 1);
        QCOMPARE(w.editor.undoText(), QString("Change colour"));
        w.target.setOpacity(0.5f);
        QCOMPARE(w.colour(3), withOpacity(green, 0.5f));
        QCOMPARE(w.colour(2, 1), withOpacity(green, 0.5f));
        QCOMPARE(w.steps(), 2);
        w.editor.undo();
        w.editor.undo();
        QVERIFY(w.isAsBefore());
        QCOMPARE(w.editor.brush().colour, (Colour{0.2f, 0.3f, 0.4f, 0.5f}));
        w.select({2, 3}, {{2, 2}}); // a segment of the one, the other whole
        w.target.setPaint(green);
        QCOMPARE(w.colour(2, 0), blue);
        QCOMPARE(w.colour(2, 2), green);
        QCOMPARE(w.colour(3), withOpacity(green, 0.25f));
    }

    void aDragIsOneStep()
    {
        Work w;
        w.target.useTool(ToolUse::Refines);
        w.select({1, 2});
        ValueEntry entry;
        entry.beginDrag();
        for (const Colour &colour : {green, violet, blue})
            w.target.setPaint(colour, &entry);
        QCOMPARE(w.steps(), 0);
        QCOMPARE(w.colour(1), blue);
        entry.giveUpDrag(); // as Esc does
        QVERIFY(w.isAsBefore());
        QCOMPARE(w.steps(), 0);
        entry.beginDrag();
        for (const Colour &colour : {green, violet})
            w.target.setPaint(colour, &entry);
        entry.commitDrag();
        QCOMPARE(w.steps(), 1);
        w.editor.undo();
        QVERIFY(w.isAsBefore());
    }

    /// Passing through white and grey, where colours lose their hue, and resting there loses nothing.
    void aShiftKeepsDifferences()
    {
        Work w;
        w.target.useTool(ToolUse::Refines);
        w.target.setMode(Mode::Shift);
        w.select({2});
        QCOMPARE(w.target.colour(), blue);
        ValueEntry entry;
        entry.beginDrag();
        for (const Colour &colour : {Colour{0, 0, 0, 1}, Colour{0.5f, 0.5f, 0.5f, 1}}) {
            w.target.setPaint(colour, &entry);
            w.editor.rest();
        }
        w.target.setPaint(red, &entry);
        entry.commitDrag();
        QCOMPARE(w.colour(2, 0), red); // exactly what was picked
        QCOMPARE(w.colour(2, 1), red);
        const Colour other = w.colour(2, 2); // a dark, pale blue became a dark, pale red
        QVERIFY(std::abs(other.red - 0.9f) < 1e-5f && std::abs(other.yellow - 0.5f) < 1e-5f &&
                std::abs(other.blue - 0.5f) < 1e-5f);
        QCOMPARE(w.steps(), 1);
        w.editor.undo();
        QVERIFY(w.isAsBefore());
        Editor another; // the mode is remembered
        QCOMPARE(another.colourTarget().mode(), Mode::Shift);
    }

    void aLinkedSwatchIsChanged()
    {
        Work w;
        w.target.editSwatch(9);
        QCOMPARE(w.target.kind(), Kind::Brush);
        w.target.editSwatch(0);
        QCOMPARE(w.target.kind(), Kind::Swatch);
        QCOMPARE(w.target.colour(), red);
        ValueEntry entry;
        entry.beginDrag();
        w.target.setPaint(blue, &entry); // through the colour of others
        w.target.setPaint(green, &entry);
        entry.giveUpDrag();
        QVERIFY(w.isAsBefore());
        QCOMPARE(w.target.kind(), Kind::Swatch); // goes on
        entry.beginDrag();
        w.target.setPaint(blue, &entry);
        w.target.setPaint(green, &entry);
        entry.commitDrag();
        QCOMPARE(w.steps(), 1);
        QCOMPARE(w.editor.document().painting()->swatches[0], (Swatch{"roof", green, true}));
        QCOMPARE(w.colour(1), green);
        QCOMPARE(w.colour(3), withOpacity(green, 0.25f));
        QCOMPARE(w.colour(4), green);
        QCOMPARE(w.colour(2), blue);
        w.editor.undo();
        QVERIFY(w.isAsBefore());
        w.target.setOpacity(0.5f); // its own
        QCOMPARE(w.colour(1), red);
        QCOMPARE(w.editor.document().painting()->swatches[0].colour.opacity, 0.5f);
        std::vector<Swatch> others = w.editor.document().painting()->swatches;
        others[0].linked = false;
        others[0].name = "wall";
        w.editor.push(setSwatches(w.editor.document(), others), "unlink");
        QCOMPARE(w.target.kind(), Kind::Swatch); // it is still the same one
        std::swap(others[0], others[1]);
        w.editor.push(setSwatches(w.editor.document(), others), "move");
        QCOMPARE(w.target.kind(), Kind::Brush); // another one stands there
        w.target.editSwatch(0);
        w.select({1});
        QCOMPARE(w.target.kind(), Kind::Brush);
        w.target.editSwatch(0);
        w.target.useTool(ToolUse::Refines);
        QCOMPARE(w.target.kind(), Kind::Selection);
    }

    void coloursAreMappedToSwatches()
    {
        Work w;
        QCOMPARE(mapToSwatches(w.editor), QString());
        QCOMPARE(w.steps(), 1);
        QCOMPARE(w.colour(1), red);
        QCOMPARE(w.colour(2), sea);
        QCOMPARE(w.colour(3), thinRed);
        QVERIFY(!mapToSwatches(w.editor).isEmpty()); // nothing changes
        QCOMPARE(w.steps(), 1);
        w.editor.undo();
        QVERIFY(w.isAsBefore());
        w.select({4});
        QVERIFY(!mapToSwatches(w.editor).isEmpty());
        w.select({1});
        QVERIFY(!mapToSwatches(w.editor).isEmpty());
        QVERIFY(w.isAsBefore()); // what is not selected is left alone

        OpenPainting open;
        open.editor.newPainting({});
        Commands table;
        addSessionRows(table, open);
        table.update();
        QVERIFY(!table[Command::MapToSwatches].isEnabled());
        QVERIFY(!mapToSwatches(open.editor).isEmpty());
        open.editor.document().reset(w.before);
        table.update();
        QVERIFY(table[Command::MapToSwatches].isEnabled());
        table[Command::MapToSwatches].trigger();
        QCOMPARE(open.editor.undoStack().count(), 1);
    }

    void whatHasAColourIsSelected()
    {
        Work w;
        selectColour(w.editor, red);
        QCOMPARE(w.editor.selection().strokes, std::set<StrokeId>({1, 3})); // not the locked one
        QVERIFY(w.editor.selection().segments.empty());
        selectColour(w.editor, dark);
        QCOMPARE(w.editor.selection().segments, std::set<SegmentRef>({{2, 2}}));
    }

    void artworkIsRecoloured()
    {
        Work w;
        Recolouring work(w.editor);
        QVERIFY(!work.isOfSelection());
        QCOMPARE(work.uses().size(), std::size_t(3));
        QCOMPARE(work.uses()[0].colour, red);
        work.set({0}, green);
        QCOMPARE(w.colour(1), green);
        QCOMPARE(w.colour(3), withOpacity(green, 0.25f));
        QCOMPARE(w.colour(4), red); // locked
        work.rest();
        work.set({1}, red); // colours change places, none runs into another one
        QCOMPARE(w.colour(1), green);
        QCOMPARE(w.colour(2), red);
        work.setShift({.hue = 1.0 / 3});
        QCOMPARE(w.colour(2), work.result(1));
        QVERIFY(std::abs(w.colour(2).yellow - 1) < 1e-5f);
        work.set({0}, violet); // What is set now is what it becomes, whatever the shift of all is.
        QCOMPARE(work.result(0), violet);
        QCOMPARE(w.colour(1), violet);
        work.setShift({.hue = 1.0 / 3, .saturation = 0}); // From there it is shifted with all.
        QCOMPARE(w.colour(1).red, w.colour(1).blue);
        work.set({0}, violet);
        QCOMPARE(w.colour(1), violet);
        work.set({0}, green);
        work.setShift({});
        work.set({0}, green);
        work.setMapped(true);
        QCOMPARE(w.colour(2, 2), sea);
        work.setMapped(false);
        work.set({0, 1}, {});
        QVERIFY(w.isAsBefore());
        work.set({0}, violet);
        work.accept();
        QCOMPARE(w.steps(), 1);
        QCOMPARE(w.editor.undoText(), QString("Recolour artwork"));
        QCOMPARE(w.colour(1), violet);
        w.editor.undo();
        QVERIFY(w.isAsBefore());
    }

    void recolouringIsGivenUp()
    {
        Work w;
        w.editor.push(changeSegments(w.editor.document(), {{1, 0}}, [](Segment &s) { s.density = 3; }), "other");
        w.editor.undo(); // a step to be redone
        {
            Recolouring work(w.editor);
            work.set({0}, green);
            work.giveUp();
            QVERIFY(w.isAsBefore());
            QVERIFY(w.editor.canRedo());
            work.giveUp();
        }
        {
            Recolouring work(w.editor);
            work.set({0}, green);
        } // it goes without a word
        QVERIFY(w.isAsBefore());
        QVERIFY(w.editor.canRedo());
        QCOMPARE(w.steps(), 1);
    }

    void whatIsAlikeShiftsOrBecomesOne()
    {
        Work w;
        std::vector<Colour> many;
        for (int i = 0; i < 60; ++i)
            many.push_back({0.9f, float(i) / 600, 0.05f, 1});
        for (int i = 0; i < 60; ++i)
            many.push_back({0.05f, float(i) / 600, 0.9f, 1});
        auto painting = std::make_shared<Painting>();
        painting->strokes = {strokeOf(1, many), strokeOf(2, {red})};
        w.editor.document().reset(painting);
        w.select({1});
        Recolouring work(w.editor);
        QVERIFY(work.isOfSelection());
        QVERIFY(work.uses().size() <= Recolouring::mostUses);
        const std::vector<Colour> &alike = work.uses()[0].members;
        QVERIFY(alike.size() > 1);
        const auto distinct = [&w] {
            std::set<QString> names;
            for (const Segment &segment : w.editor.document().painting()->find(1)->segments)
                names.insert(
                    QString("%1 %2 %3").arg(segment.colour.red).arg(segment.colour.yellow).arg(segment.colour.blue));
            return names.size();
        };
        QCOMPARE(distinct(), std::size_t(120));
        work.set({0}, green);
        QVERIFY(distinct() > 110); // they keep their differences
        QCOMPARE(work.result(0), green);
        work.setKeepsDifferences(false);
        QCOMPARE(distinct(), 120 - alike.size() + 1);
        QCOMPARE(w.colour(2), red);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestColourTarget)
#include "test_colour_target.moc"
