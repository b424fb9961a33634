// What opens where the pointer is: the menu, the brush palette, the values; and the brushes in the row over the canvas.
#include "app/widgets/asking/messages.h"
#include "app/panels/inspector/segment_section.h"
#include "app/session/colour/colour_target.h"
#include "app/session/colour_convert.h"
#include "app/session/painting/seen_width.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/brush_palette.h"
#include "app/widgets/brush/brush_combo.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/brush/brush_pictures.h"
#include "app/widgets/colour/colour_chips.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/window/pointer/value_card.h"
#include "model/brush/stroke_builder.h"
#include "tests/app/selecting.h"
#include "undo/edits.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

namespace {

/// Three strokes that cross at (400, 300), and the window in front.
struct Crossing : Selecting {
    Crossing()
        : Selecting({line(1, {200, 300}, {600, 300}), line(2, {400, 100}, {400, 500}), line(3, {300, 200}, {500, 400})})
    {
        window.activateWindow();
        (void)QTest::qWaitForWindowActive(&window);
        canvas().setFocus();
    }
    QMenu &menu() { return *window.findChild<QMenu *>("canvasMenu"); }
    void askAt(Point where, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&canvas(), Qt::RightButton, modifiers, at(where));
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QWidget *focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &canvas(), Qt::Key(key), modifiers);
    }
    QStringList texts()
    {
        QStringList list;
        for (const QAction *action : menu().actions())
            if (!action->isSeparator())
                list << plainTitle(action->text());
        return list;
    }
    QAction *entry(const QString &title) { return entryIn(menu(), title); }
    static QAction *entryIn(const QMenu &menu, const QString &title)
    {
        for (QAction *action : menu.actions())
            if (plainTitle(action->text()).contains(title))
                return action;
        return nullptr;
    }
    /// An entry of a menu below.
    QAction *entry(const QString &menu, const QString &title)
    {
        const QAction *above = entry(menu);
        return above && above->menu() ? entryIn(*above->menu(), title) : nullptr;
    }
    BrushPalette *palette() { return window.findChild<BrushPalette *>(); }
    ValueCard *values() { return window.findChild<ValueCard *>(); }
    void doubleClick(Point where)
    {
        click(where);
        send(QEvent::MouseButtonDblClick, at(where), none);
        send(QEvent::MouseButtonRelease, at(where), none);
    }
    bool canvasHasKeyboard() { return QApplication::focusWidget() == &canvas(); }
};

/// Letters that two entries of a menu, or of one below it, share.
QStringList sharedLetters(const QMenu &menu)
{
    QStringList shared;
    QString taken;
    for (const QAction *action : menu.actions()) {
        static const QRegularExpression letter("&([^&])");
        if (const auto match = letter.match(QString(action->text()).remove("&&")); match.hasMatch()) {
            if (taken.contains(match.captured(1), Qt::CaseInsensitive))
                shared << menu.title() + ": " + action->text();
            taken += match.captured(1);
        }
        if (action->menu())
            shared += sharedLetters(*action->menu());
    }
    return shared;
}

/// Types into a field and presses Return there.
void enter(QLineEdit &field, const QString &text)
{
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

} // namespace

class TestAtPointer : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void menuNamesWhatLiesThereFromTheTop()
    {
        Crossing s;
        s.askAt({400, 300});
        QVERIFY(s.menu().isVisible());
        QCOMPARE(s.selected(), std::set<StrokeId>{3}); // as a click would
        const QStringList texts = s.texts();
        QVERIFY2(texts[0].endsWith("Stroke 3") && texts[1].endsWith("Stroke 2") && texts[2].endsWith("Stroke 1"),
                 qPrintable(texts.join('|')));
        QVERIFY(!s.entry("Stroke 2")->icon().isNull()); // its colour
        QVERIFY(s.entry("Stroke 3")->font().bold() && !s.entry("Stroke 2")->font().bold());
        QTest::keyClick(&s.menu(), Qt::Key_2);
        QVERIFY(!s.menu().isVisible());
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        QCOMPARE(s.steps(), 0);
    }

    void menuDoesWhatCanBeDoneWithTheSelection()
    {
        Crossing s;
        s.askAt({250, 300});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        for (const char *title :
             {"Copy", "Cut", "Duplicate", "Delete", "Group", "Lock", "Hide", "Arrange", "Reshape", "Edit Values Here"})
            QVERIFY2(s.entry(title), title);
        QVERIFY(!s.entry("Ungroup")); // nothing that cannot be done
        QVERIFY(!s.entry("Fit the Canvas"));
        QMenu *arrange = s.entry("Arrange")->menu();
        QVERIFY(arrange);
        for (QAction *action : arrange->actions())
            if (plainTitle(action->text()) == "Raise to Top")
                action->trigger();
        QCOMPARE(s.painting().strokes.back()->id, StrokeId(1));
        QCOMPARE(s.steps(), 1);
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        QVERIFY(!s.menu().isVisible());
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QCOMPARE(s.steps(), 1);
        // What is selected stays so where the pointer is on it, among others or on empty paper.
        s.select({1, 2});
        s.askAt({250, 300});
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        s.askAt({60, 60});
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        QVERIFY(!s.entry("Stroke"));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
    }

    void menuOfEmptyPaperIsAboutTheCanvas()
    {
        Crossing s;
        s.askAt({60, 60});
        QVERIFY(s.entry("Select All") && s.entry("Fit the Canvas") && s.entry("Show the Grid"));
        QVERIFY(!s.entry("Cut") && !s.entry("Group") && !s.entry("Stroke"));
        s.entry("Select All")->trigger();
        QCOMPARE(s.selected().size(), std::size_t(3));
        s.menu().hide();
    }

    void menuFollowsTheTool()
    {
        Crossing s;
        s.use(Command::Segments);
        s.editor().document().setSelection({{1}, {{1, 1}}});
        s.askAt({250, 300});
        QVERIFY(s.entry("Nodes", "Delete Segments"));
        QCOMPARE(s.selection().segments.size(), std::size_t(1)); // as it was
        s.menu().hide();
        s.select({});
        s.use(Command::Brush);
        s.askAt({400, 300}, shift); // without Shift it is the palette
        QVERIFY(s.menu().isVisible());
        QVERIFY(s.selected().empty()); // the Brush selects nothing by itself
        s.entry("Stroke 1")->trigger();
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QVERIFY(s.window.action(Command::Select).isChecked()); // so that it is seen
        s.menu().hide();
    }

    /// What refines strokes is there, in menus below; each letter once.
    void menuHasWhatRefines()
    {
        Crossing s;
        s.select({1, 2});
        s.use(Command::CopyAppearance);
        s.askAt({250, 300});
        for (const auto &[menu, title] : std::initializer_list<std::pair<const char *, const char *>>{
                 {"Combine and Break", "Combine"},
                 {"Reshape", "Simplify"},
                 {"Reshape", "Smooth"},
                 {"Brush and Colours", "Apply Brush"},
                 {"Brush and Colours", "Appearance"},
                 {"Brush and Colours", "Recolour Artwork"}})
            QVERIFY2(s.entry(menu, title), title);
        QVERIFY(!s.entry("Combine and Break", "Break Apart")); // each is of one piece
        QVERIFY2(s.texts().size() < 22, qPrintable(s.texts().join('|')));
        QVERIFY2(sharedLetters(s.menu()).isEmpty(), qPrintable(sharedLetters(s.menu()).join('|')));
        s.entry("Combine and Break", "Combine")->trigger();
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QCOMPARE(s.steps(), 1);
        s.menu().hide();
        s.askAt({250, 300});
        QVERIFY(s.entry("Combine and Break", "Break Apart"));
        s.menu().hide();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.painting().strokes.front()->id}, {}});
        s.askAt({250, 300});
        QVERIFY(s.entry("Nodes", "Reverse"));
        QVERIFY2(sharedLetters(s.menu()).isEmpty(), qPrintable(sharedLetters(s.menu()).join('|')));
        s.menu().hide();
        s.select({});
        s.use(Command::Select);
        s.askAt({60, 60});
        QVERIFY(s.entry("Colours", "Recolour Artwork"));
        QVERIFY2(sharedLetters(s.menu()).isEmpty(), qPrintable(sharedLetters(s.menu()).join('|')));
        s.menu().hide();
    }

    void menuOpensByKeys()
    {
        Crossing s;
        QTest::mouseMove(&s.canvas(), s.at({400, 300}));
        s.key(Qt::Key_F10, shift);
        QVERIFY(s.menu().isVisible());
        QVERIFY(s.entry("Stroke 2"));
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        s.key(Qt::Key_Menu);
        QVERIFY(s.menu().isVisible());
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        QVERIFY(!s.menu().isVisible());
    }

    void aPressInADragAsksNothing()
    {
        Crossing s;
        s.pressAndMove({{250, 300}, {260, 330}}, none);
        QTest::mousePress(&s.canvas(), Qt::RightButton, {}, s.at({260, 330}));
        QVERIFY(!s.menu().isVisible());
        QVERIFY(s.canvas().tool()->isBusy());
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QCOMPARE(s.steps(), 0);
    }

    /// What opens takes the pointer's release, so the stroke in hand is painted as far as it has come.
    void whatOpensFinishesTheStroke()
    {
        Crossing s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Brush);
        const auto begin = [&](double y) {
            s.canvas().setFocus();
            QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, y}));
            for (int i = 1; i <= 10; ++i) {
                s.advance(interval);
                QTest::mouseMove(&s.canvas(), s.at({250 + 10.0 * i, y}));
            }
            QVERIFY(s.canvas().tool()->isBusy());
        };
        begin(200);
        s.use(Command::CanvasMenu);
        QTRY_VERIFY_WITH_TIMEOUT(!s.canvas().tool()->isBusy(), waitMs);
        QTest::keyClick(&s.menu(), Qt::Key_Escape);
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
        begin(240);
        s.use(Command::BrushPalette);
        QTRY_VERIFY_WITH_TIMEOUT(!s.canvas().tool()->isBusy(), waitMs);
        s.palette()->close();
        QCOMPARE(s.painting().strokes.size(), std::size_t(5));
        begin(280);
        QMenu *file = s.window.menuBar()->actions().first()->menu();
        file->popup(s.window.mapToGlobal(QPoint(10, 10)));
        QTRY_VERIFY_WITH_TIMEOUT(!s.canvas().tool()->isBusy(), waitMs);
        file->hide();
        QCOMPARE(s.painting().strokes.size(), std::size_t(6));
        QVERIFY(s.painting().strokes.back()->segments.size() > 0);
        QCOMPARE(s.steps(), 3);
    }

    /// A stroke in hand when the window closes belongs to the work that is asked about.
    void closingFinishesTheStroke()
    {
        Crossing s;
        QTemporaryDir folder;
        QVERIFY(s.window.saveTo(folder.filePath("a.suffuse")));
        int asked = 0;
        MessageHooks hooks;
        hooks.unsaved = [&](const QString &) {
            ++asked;
            return SaveAnswer::Cancel;
        };
        setMessageHooks(hooks);
        const auto back = qScopeGuard([] { setMessageHooks({}); });
        s.use(Command::Brush);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({250, 200}));
        for (int i = 1; i <= 10; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({250 + 10.0 * i, 200}));
        }
        QVERIFY(!s.window.close());
        QCOMPARE(asked, 1);
        QVERIFY(!s.canvas().tool()->isBusy());
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
    }

    /// The pen's button asks when it is let go: what opens would not let the canvas hear of it.
    void aPensButtonAsksWhenItIsLetGo()
    {
        Crossing s;
        s.use(Command::Brush);
        QPointingDevice device("test pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                               QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 2);
        const auto send = [&](QEvent::Type type, Qt::MouseButtons down) {
            const QPointF at = s.at({400, 300});
            QTabletEvent event(type, &device, at, s.canvas().mapToGlobal(at), 0.5, 0, 0, 0, 0, 0, {}, Qt::RightButton,
                               down);
            QCoreApplication::sendEvent(&s.canvas(), &event);
        };
        send(QEvent::TabletPress, Qt::RightButton);
        QVERIFY(!s.palette());
        send(QEvent::TabletRelease, Qt::NoButton);
        QVERIFY(s.palette() && s.palette()->isOpen());
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
    }

    void paletteOpensWhereThePointerIsAndClosesByPainting()
    {
        Crossing s;
        s.use(Command::Brush);
        s.askAt({400, 300});
        QVERIFY(s.palette() && s.palette()->isOpen());
        QVERIFY(!s.menu().isVisible());
        const QRect card = s.palette()->geometry();
        QVERIFY(s.window.rect().contains(card));
        QVERIFY(card.contains(s.canvas().mapTo(&s.window, s.at({400, 300}))));
        s.paintLine({100, 60}, {180, 60}); // beside it
        QVERIFY(!s.palette()->isOpen());
        QCOMPARE(s.painting().strokes.size(), std::size_t(4)); // the press that closes it paints
        QVERIFY(s.canvasHasKeyboard());
        // In a corner it keeps within the window.
        s.askAt({5, 5});
        QVERIFY(s.palette()->isOpen());
        QVERIFY(s.window.rect().contains(s.palette()->geometry()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!s.palette()->isOpen());
        QVERIFY(s.canvasHasKeyboard());
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
    }

    void paletteIsWorkedByKeys()
    {
        Crossing s;
        s.key(Qt::Key_Q);
        QVERIFY(s.palette() && s.palette()->isOpen());
        BrushPalette &palette = *s.palette();
        QCOMPARE(QApplication::focusWidget(), palette.grid());
        QCOMPARE(BrushGrid::brushOf(palette.grid()->currentItem()), s.editor().brush().name);
        const QString before = s.editor().brush().name;
        s.key(Qt::Key_Right);
        QVERIFY(s.editor().brush().name != before);
        QCOMPARE(BrushGrid::brushOf(palette.grid()->currentItem()), s.editor().brush().name);
        QVERIFY(s.window.action(Command::Brush).isChecked()); // to paint with it
        s.key(Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), palette.nearChips());
        const Colour colour = s.editor().brush().colour;
        s.key(Qt::Key_Right);
        s.key(Qt::Key_Down);
        const Colour wanted = palette.nearChips()->colours()[std::size_t(palette.nearChips()->current())];
        s.key(Qt::Key_Space);
        QCOMPARE(s.editor().brush().colour, wanted);
        QVERIFY(!(wanted == colour));
        // Tab goes round within it.
        std::set<QWidget *> visited;
        for (int i = 0; i < 20; ++i) {
            s.key(Qt::Key_Tab);
            QVERIFY(palette.isAncestorOf(QApplication::focusWidget()));
            visited.insert(QApplication::focusWidget());
        }
        QVERIFY(visited.contains(palette.grid()) && visited.size() >= 7);
        s.key(Qt::Key_B); // no command of the canvas
        QVERIFY(palette.isOpen());
        palette.grid()->setFocus();
        s.key(Qt::Key_Q); // the key that opens it closes it
        QVERIFY(!palette.isOpen());
        QVERIFY(s.canvasHasKeyboard());
        QCOMPARE(s.steps(), 0);
    }

    void paletteChangesSizeAndZoom()
    {
        Crossing s;
        s.key(Qt::Key_Q);
        BrushPalette &palette = *s.palette();
        enter(*palette.zoom()->number(), "200");
        QVERIFY(std::abs(s.canvas().view().scale - 2) < 1e-9);
        if (!palette.isOpen()) // Return closes it when the number is taken
            s.key(Qt::Key_Q);
        enter(*palette.size()->number(), "31");
        QVERIFY(std::abs(s.editor().brush().spread() - 31) < 1e-4);
        QVERIFY(!palette.isOpen());
    }

    void paletteShowsWhatWasPaintedWith()
    {
        Crossing s;
        s.use(Command::Brush);
        s.editor().setColour(fromScreen(QColor("#c02040")));
        s.paintLine({100, 60}, {180, 60});
        s.key(Qt::Key_Q);
        const std::vector<Colour> &recent = s.palette()->recentChips()->colours();
        QVERIFY(!recent.empty());
        QCOMPARE(toOpaqueScreen(recent.front()).name(), QString("#c02040"));
        s.editor().setColour(fromScreen(QColor("#208040")));
        // Colours that differ only in their opacity are told apart.
        ColourChips chips(2);
        chips.showOpacity();
        const Colour opaque{0.2f, 0.3f, 0.8f, 1}, faint{0.2f, 0.3f, 0.8f, 0.3f};
        chips.setColours({opaque, faint});
        const QImage shown = chips.grab().toImage();
        QVERIFY(shown.copy(chips.cell(0)) != shown.copy(chips.cell(1)));
        QTest::mouseClick(s.palette()->recentChips(), Qt::LeftButton, {}, s.palette()->recentChips()->cell(0).center());
        QCOMPARE(toOpaqueScreen(s.editor().brush().colour).name(), QString("#c02040"));
    }

    /// As the Colour dock does, the palette colours what is selected where that is meant.
    void paletteColoursWhatIsSelected()
    {
        Crossing s;
        s.use(Command::Select);
        s.select({1, 2});
        s.editor().laterChanges().flush();
        QCOMPARE(s.editor().colourTarget().kind(), ColourTarget::Kind::Selection);
        const Colour ofBrush = s.editor().brush().colour;
        const float opacity = s.stroke(1).segments[0].colour.opacity;
        s.key(Qt::Key_Q);
        BrushPalette &palette = *s.palette();
        QCOMPARE(palette.whose()->text(), s.editor().colourTarget().title());
        QVERIFY(palette.whose()->text() != "Colour of the brush");
        const Colour wanted = palette.nearChips()->colours()[5];
        QTest::mouseClick(palette.nearChips(), Qt::LeftButton, {}, palette.nearChips()->cell(5).center());
        for (const StrokeId id : {1, 2}) {
            QCOMPARE(s.stroke(id).segments[0].colour.red, wanted.red);
            QCOMPARE(s.stroke(id).segments[0].colour.blue, wanted.blue);
            QCOMPARE(s.stroke(id).segments[0].colour.opacity, opacity);
        }
        QVERIFY(!(s.stroke(3).segments[0].colour == s.stroke(1).segments[0].colour));
        QCOMPARE(s.steps(), 1);
        enter(*palette.opacity()->number(), "37");
        QCOMPARE(s.stroke(2).segments[0].colour.opacity, 0.37f);
        QCOMPARE(s.steps(), 2);
        QCOMPARE(s.editor().brush().colour, ofBrush);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QCOMPARE(s.stroke(1).segments[0].colour.opacity, opacity);
        // With the brush in hand it is the brush's again.
        s.use(Command::Brush);
        s.key(Qt::Key_Q);
        QCOMPARE(palette.whose()->text(), QString("Colour of the brush"));
        QTest::mouseClick(palette.nearChips(), Qt::LeftButton, {}, palette.nearChips()->cell(2).center());
        QVERIFY(!(s.editor().brush().colour == ofBrush));
        QCOMPARE(s.editor().undoStack().index(), 0);
    }

    void nearColoursGoThroughTheColour()
    {
        for (const char *name : {"#3060a0", "#ffffff", "#000000", "#808080", "#ff0000"}) {
            const Colour colour = fromScreen(QColor(name));
            const std::vector<Colour> near = nearColours(colour);
            QCOMPARE(near.size(), std::size_t(21));
            for (const std::size_t middle : {3, 10, 17})
                QVERIFY2(std::abs(near[middle].red - colour.red) < 1e-5 &&
                             std::abs(near[middle].yellow - colour.yellow) < 1e-5 &&
                             std::abs(near[middle].blue - colour.blue) < 1e-5,
                         name);
            QVERIFY(toOpaqueScreen(near[0]).lightness() >= toOpaqueScreen(near[6]).lightness());
        }
    }

    void doubleClickEditsTheValuesThere()
    {
        Crossing s;
        s.doubleClick({250, 300});
        QCOMPARE(s.selection(), (Selection{{1}, {}}));
        QVERIFY(s.values() && s.values()->isOpen());
        ValueCard &card = *s.values();
        QCOMPARE(QApplication::focusWidget(), card.width()->number());
        const float before = s.stroke(1).segments[0].density;
        enter(*card.segments()->density()->number(), "31");
        QCOMPARE(s.stroke(1).segments[0].density, 31.f);
        QCOMPARE(s.stroke(1).segments[3].density, 31.f); // all of the stroke
        QCOMPARE(s.stroke(2).segments[0].density, before);
        QCOMPARE(s.steps(), 1);
        QVERIFY(!card.isOpen()); // by Return
        QVERIFY(s.canvasHasKeyboard());
        s.editor().undoStack().undo();
        QCOMPARE(s.stroke(1).segments[0].density, before);
        // One segment alone.
        s.doubleClick({250, 300});
        card.segmentButton()->click();
        QCOMPARE(s.selection().segments, (std::set<SegmentRef>{{1, 0}}));
        enter(*card.segments()->density()->number(), "17");
        QCOMPARE(s.stroke(1).segments[0].density, 17.f);
        QCOMPARE(s.stroke(1).segments[1].density, before);
        s.doubleClick({60, 60}); // nothing is there
        QVERIFY(!card.isOpen());
    }

    void escapeClosesTheValuesAndGivesUpTheDrag()
    {
        Crossing s;
        s.doubleClick({250, 300});
        ValueCard &card = *s.values();
        const Painting before = s.painting();
        BarSlider &slider = *card.segments()->density()->slider();
        QTest::mousePress(&slider, Qt::LeftButton, {}, slider.rect().center());
        QTest::mouseMove(&slider, slider.rect().center() + QPoint(20, 0));
        QVERIFY(!(s.painting() == before));
        QTest::keyClick(&slider, Qt::Key_Escape);
        QVERIFY(s.painting() == before);
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, slider.rect().center());
        QCOMPARE(s.steps(), 0);
        s.key(Qt::Key_Escape);
        QVERIFY(!card.isOpen());
        QVERIFY(s.canvasHasKeyboard());
        QVERIFY(s.painting() == before);
    }

    void widthKeepsWhatVaries()
    {
        Crossing s;
        Edit edit = changeStrokes(s.editor().document(), {1}, [](Stroke &stroke) {
            stroke.segments[1].density *= 1.4f;
            stroke.segments[2].density *= 0.8f;
        });
        s.editor().push(std::move(edit), "vary");
        const Microseconds time = s.editor().clock().time();
        const auto width = [&](int k) { return seenWidth(s.stroke(1), k, time)->width; };
        const double ratio = width(2) / width(1);
        s.doubleClick({250, 300});
        ValueCard &card = *s.values();
        QVERIFY(card.width()->number()->value());
        QVERIFY(std::abs(*card.width()->number()->value() - 2 * width(1)) < 1e-6); // the widest
        enter(*card.width()->number(), "30");
        QVERIFY2(std::abs(2 * width(1) - 30) < 1e-3, qPrintable(QString::number(2 * width(1))));
        QVERIFY(std::abs(width(2) / width(1) - ratio) < 1e-4);
        QCOMPARE(s.editor().undoStack().undoText(), QString("Change width"));
        s.editor().undoStack().undo();
        QVERIFY(std::abs(width(2) / width(1) - ratio) < 1e-9);
    }

    /// The handle that shows a width takes a number, too.
    void doubleClickOnTheWidthHandleTypesTheWidth()
    {
        Crossing s;
        s.use(Command::Segments);
        s.editor().document().setSelection({{1}, {{1, 1}}});
        s.dry();
        std::optional<Point> handle;
        for (double y = 250; y <= 350 && !handle; ++y) { // beside the middle of the segment
            const Point at{350, y};
            s.send(QEvent::MouseMove, s.at(at), none);
            if (s.canvas().tool()->hint().contains("set the width"))
                handle = at;
        }
        QVERIFY(handle);
        s.doubleClick(*handle);
        QVERIFY(s.values() && s.values()->isOpen());
        QCOMPARE(QApplication::focusWidget(), s.values()->width()->number());
        QVERIFY(s.values()->segmentButton()->isChecked());
        QCOMPARE(s.steps(), 0);
        enter(*s.values()->width()->number(), "24");
        const double width = seenWidth(s.stroke(1), 1, s.editor().clock().time())->width;
        QVERIFY2(std::abs(2 * width - 24) < 1e-3, qPrintable(QString::number(2 * width)));
        QCOMPARE(s.stroke(1).segments[0].density, 20.f);
        QCOMPARE(s.steps(), 1);
    }

    void returnOpensTheValuesOfTheSelection()
    {
        Crossing s;
        s.select({1, 2});
        s.key(Qt::Key_Return);
        QVERIFY(s.values() && s.values()->isOpen());
        QVERIFY(s.window.rect().contains(s.values()->geometry()));
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.key(Qt::Key_Escape);
        QVERIFY(!s.values()->isOpen());
        s.select({});
        QVERIFY(!s.window.action(Command::EditHere).isEnabled());
    }

    void rowDropsDownBrushesWithPictures()
    {
        Crossing s;
        s.use(Command::Brush);
        auto *combo = s.canvas().tool()->options()->findChild<BrushCombo *>();
        QVERIFY(combo);
        combo->showPopup();
        QVERIFY(combo->grid());
        const auto isDrawn = [&](const Brush &brush) {
            const QListWidgetItem *item = combo->grid()->itemOf(brush.name);
            const QImage picture = item ? item->icon().pixmap(BrushPictures::size).toImage() : QImage();
            const QPoint middle = picture.rect().center();
            return !picture.isNull() && picture.pixel(middle) != picture.pixel(8, 8); // there is paper
        };
        QTRY_VERIFY_WITH_TIMEOUT(std::ranges::all_of(BrushLibrary::instance().brushes(), isDrawn), waitMs);
        // Typing searches, Return takes.
        const QString before = s.editor().brush().name;
        QTest::keyClicks(combo->grid(), "goua");
        QCOMPARE(combo->search()->text(), QString("goua"));
        QTest::keyClick(combo->search(), Qt::Key_Return);
        QVERIFY(!combo->grid());
        QCOMPARE(s.editor().brush().name, QString("gouache"));
        combo->showPopup();
        QTest::keyClick(combo->grid(), Qt::Key_Down);
        QTest::keyClick(combo->grid(), Qt::Key_Escape);
        QVERIFY(!combo->grid());
        QCOMPARE(s.editor().brush().name, QString("gouache")); // only Return takes
        BrushLibrary::instance().use(s.editor(), before);
        QCOMPARE(combo->currentData().toString(), before);
    }

    /// Who opens the program for the first time paints with a brush that a mouse's speed shapes.
    void theFirstBrushIsShapedBySpeed()
    {
        settings::store().remove("brush");
        {
            const MainWindow window;
            QCOMPARE(const_cast<MainWindow &>(window).editor().brush(), firstBrush());
        }
        const auto stroke = [](double unitsASecond) {
            std::vector<PenSample> samples;
            for (int i = 0; i <= 60; ++i)
                samples.push_back({{double(10 * i), 0}, toMicroseconds(10 * i / unitsASecond)});
            return buildStroke(firstBrush(), 1, samples);
        };
        const auto widthOf = [](const Stroke &s) { // in the middle, dry
            const int k = int(s.segments.size()) / 2;
            return seenWidth(s, k, s.segments[std::size_t(k)].born + 100'000'000)->width;
        };
        const StrokePtr slow = stroke(150), quick = stroke(1500);
        QVERIFY2(widthOf(*slow) > 2 * widthOf(*quick),
                 qPrintable(QString("%1 %2").arg(widthOf(*slow)).arg(widthOf(*quick))));
        const auto tapers = [&](const Stroke &s) {
            const auto at = [&](std::size_t k) {
                return std::sqrt(4.0 * s.segments[k].diffusion * s.segments[k].maxAge);
            };
            return at(s.segments.size() - 1) < 0.6 * at(s.segments.size() / 2);
        };
        QVERIFY(tapers(*slow) && tapers(*quick));
        QVERIFY(slow->segments[slow->segments.size() / 2].colour.opacity >
                quick->segments[quick->segments.size() / 2].colour.opacity);
    }

    /// After the first strokes the status bar says what can be done with them, until somebody has done it once.
    void theFirstStrokesLeadToSelecting()
    {
        settings::store().remove("hints/hasSelected");
        Session s;
        const QString usual = s.canvas().tool()->hint();
        for (int i = 1; i <= 3; ++i) {
            QCOMPARE(s.canvas().tool()->hint(), usual);
            s.paintLine({100, 100.0 * i}, {400, 100.0 * i});
        }
        const QString said = s.canvas().tool()->hint();
        QVERIFY2(said.contains("press V"), qPrintable(said));
        s.use(Command::Select);
        s.click({250, 100});
        QCOMPARE(s.selection().strokes.size(), std::size_t(1));
        s.use(Command::Brush);
        s.paintLine({100, 450}, {400, 450});
        QCOMPARE(s.canvas().tool()->hint(), usual);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestAtPointer)
#include "test_at_pointer.moc"
