// One number, one unit and one sense wherever a quantity stands; colours as they were set; messages that go with their
// cause; buttons with mnemonics in every language, and no slanted type.
#include "app/dialogs/about_dialog.h"
#include "app/dialogs/export/clock_box.h"
#include "app/dialogs/export/drawing_dialog.h"
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/timelapse_dialog.h"
#include "app/dialogs/new_dialog.h"
#include "app/dialogs/settings_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/panels/brushes/brush_dialog.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/session/colour_convert.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/tools/brush/attribute_brush_tool.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/curves/response_editor.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/quantity.h"
#include "app/widgets/numbers/time_text.h"
#include "app/widgets/paper/canvas_section.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>

using namespace suffuse;

namespace {

/// The unit at the end of what a field shows.
QString unitOf(const NumberField &field)
{
    QString text = field.text();
    while (!text.isEmpty() && (text[0].isDigit() || QString("+-−.,—e").contains(text[0])))
        text.remove(0, 1);
    return text;
}

QChar mnemonicOf(const QString &text)
{
    for (qsizetype i = 0; i + 1 < text.size(); ++i)
        if (text[i] == '&' && text[++i] != '&')
            return text[i].toUpper();
    return {};
}

/// The page of a tab widget that a widget is on; null: on none. Pages are never seen together.
const QWidget *pageOf(const QWidget &widget, const QWidget &dialog)
{
    for (const QTabWidget *tabs : dialog.findChildren<QTabWidget *>())
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->widget(i)->isAncestorOf(&widget))
                return tabs->widget(i);
    return nullptr;
}

/// What is wrong with the mnemonics of a dialog's buttons, check boxes and labels with buddies; empty: nothing.
QString mnemonicFault(const QWidget &dialog)
{
    std::vector<std::pair<QString, const QWidget *>> taken;
    for (const QWidget *widget : dialog.findChildren<QWidget *>()) {
        const auto *label = qobject_cast<const QLabel *>(widget);
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const bool counts = label
                                ? label->buddy() != nullptr
                                : qobject_cast<const QPushButton *>(widget) || qobject_cast<const QCheckBox *>(widget);
        const QString text = label ? label->text() : button ? button->text() : QString();
        if (!counts || text.isEmpty() || widget->window() != dialog.window())
            continue;
        if (mnemonicOf(text).isNull())
            return "no mnemonic: " + text;
        static const QRegularExpression strange("[A-Za-z].*\\(&.\\)$");
        if (strange.match(text).hasMatch())
            return "a mnemonic as in Chinese: " + text;
        const QWidget *page = pageOf(*widget, dialog);
        for (const auto &[other, otherPage] : taken)
            if (mnemonicOf(other) == mnemonicOf(text) && (!page || !otherPage || page == otherPage))
                return "the same mnemonic: " + other + " and " + text;
        taken.emplace_back(text, page);
    }
    return {};
}

/// A drop-down without a name, or a dialog none of whose labels leads to a field; empty: neither.
QString fieldWithoutKey(const QWidget &dialog)
{
    const QList<QLabel *> labels = dialog.findChildren<QLabel *>();
    for (const QComboBox *box : dialog.findChildren<QComboBox *>())
        if (box->accessibleName().isEmpty())
            return box->currentText();
    qsizetype keyed = 0;
    for (const QLabel *label : labels)
        keyed += label->buddy() && !mnemonicOf(label->text()).isNull();
    return keyed > 0 ? QString() : "no label with a buddy";
}

/// Looks at the message box that comes up, and closes it.
template <typename Ask>
QString faultOfBox(const Ask &ask)
{
    QString fault = "no box came";
    QTimer::singleShot(50, [&] {
        auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        if (!box)
            return;
        fault = mnemonicFault(*box);
        for (const QAbstractButton *button : box->buttons())
            if (button->icon().isNull())
                fault += " no icon: " + button->text();
        box->reject();
        if (box->isVisible())
            box->close();
    });
    ask();
    return fault;
}

/// Nobody's font in the window is slanted, not that of an item either.
QString slantedIn(const QWidget &window)
{
    for (const QWidget *widget : window.findChildren<QWidget *>())
        if (widget->font().italic())
            return widget->metaObject()->className();
    for (const QAbstractItemView *view : window.findChildren<QAbstractItemView *>())
        for (int row = 0; view->model() && row < view->model()->rowCount(); ++row)
            if (view->model()->index(row, 0).data(Qt::FontRole).value<QFont>().italic())
                return view->model()->index(row, 0).data().toString();
    return {};
}

Brush grainyBrush()
{
    Brush brush;
    brush.granulation = 0.7f;
    return brush;
}

} // namespace

class TestWords : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
        applyTheme();
    }

    /// With the Brush nothing on the canvas shows what is selected, so Delete says what it took.
    void deletingTheUnseenIsSaid()
    {
        Session s;
        s.paintLine({100, 100}, {300, 100});
        s.paintLine({100, 200}, {300, 200});
        const StrokeId first = s.painting().strokes.front()->id;
        s.editor().document().setSelection({{first}, {}});
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        const QString said = s.window.statusBar()->currentMessage();
        QVERIFY2(said.startsWith("1 stroke") && said.contains("deleted"), qPrintable(said));
        s.use(Command::Undo);
        s.use(Command::Select);
        s.window.statusBar()->clearMessage();
        s.editor().document().setSelection({{first}, {}});
        s.use(Command::Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QVERIFY(!s.window.statusBar()->currentMessage().contains("deleted")); // it was to be seen
    }

    void grainIsOneNumberEverywhere()
    {
        Session s;
        s.editor().setBrush(grainyBrush());
        s.paintLine({100, 100}, {300, 100});
        s.editor().document().setSelection({{s.painting().strokes.back()->id}, {}});
        QCOMPARE(s.painting().strokes.back()->segments[0].granulation, 0.7f);

        BrushDialog brush(s.editor(), &s.window);
        QCOMPARE(brush.field("Granulation")->number()->text(), QString("30 %"));
        auto *inspector = s.window.findChild<InspectorPanel *>();
        QTRY_COMPARE(inspector->segmentSection()->granulation()->number()->text(), QString("30 %"));
        {
            AlongDialog along(s.editor(), &s.window);
            along.choose(Quantity::Granulation);
            QCOMPARE(along.findChildren<NumberField *>().front()->text(), QString("30 %"));
        }

        // The slider agrees with its number, and typing into it goes the same way.
        const SliderField *field = inspector->segmentSection()->granulation();
        QCOMPARE(field->slider()->value(), 300);
        type(*field->number(), "75");
        QCOMPARE(s.painting().strokes.back()->segments[0].granulation, 0.25f);
        QCOMPARE(field->slider()->value(), 750);
        type(*field->number(), "100");
        QCOMPARE(s.painting().strokes.back()->segments[0].granulation, 0.0f);
        QVERIFY(!std::signbit(s.painting().strokes.back()->segments[0].granulation)); // files would show −0
        type(*field->number(), "140");
        QVERIFY(inspector->hint()->text().contains("0 to 100"));
        QTest::keyClick(field->number(), Qt::Key_Down);
        QVERIFY(std::abs(s.painting().strokes.back()->segments[0].granulation - 0.01f) < 1e-6f);
    }

    void attributeBrushAddsGrain()
    {
        Session s;
        s.use(Command::AttributeBrush);
        auto &tool = *qobject_cast<AttributeBrushTool *>(s.canvas().tool());
        QWidget *row = tool.options();
        const auto value = [row] {
            for (NumberField *field : row->findChildren<NumberField *>())
                if (field->accessibleName() == "Value")
                    return field;
            return static_cast<NumberField *>(nullptr);
        };
        tool.setWish({.attribute = Attribute::Granulation, .relative = false, .value = 0.7, .colour = {}});
        QCOMPARE(value()->text(), QString("30 %"));
        tool.setWish({.attribute = Attribute::Granulation, .relative = true, .value = -0.25, .colour = {}});
        QCOMPARE(value()->text(), QString("25 %")); // more grain, less ω
        type(*value(), "40");
        QCOMPARE(tool.wish().value, -0.4);
    }

    void brushCurveOfGrainGrowsUpwards()
    {
        Editor editor;
        Brush brush;
        brush.setCurve(BrushQuantity::Granulation, BrushInput::Speed, {{{0, 1}, {1, 0.25f}}});
        editor.setBrush(brush);
        BrushDialog dialog(editor);
        dialog.curves()->setCurrentCell(int(BrushQuantity::Granulation), int(BrushInput::Speed));
        dialog.curve()->resize(300, 200);
        const auto height = [&](double x, double y) { return dialog.curve()->toWidget({x, y}).y(); };
        QVERIFY(height(1, 0.25) < height(0, 1)); // a smaller ω stands higher: more grain
        dialog.curves()->setCurrentCell(int(BrushQuantity::Opacity), int(BrushInput::Speed));
        QVERIFY(height(1, 0.25) > height(0, 1));
    }

    void quantitiesOfOneNameHaveOneUnit()
    {
        Session s;
        s.paintLine({100, 100}, {300, 100});
        s.editor().document().setSelection({{s.painting().strokes.back()->id}, {}});
        s.use(Command::AttributeBrush);
        qobject_cast<AttributeBrushTool *>(s.canvas().tool())->options();
        BrushDialog brush(s.editor(), &s.window);
        NewDialog fresh(&s.window);
        QTest::qWait(1);
        QHash<QString, QString> units;
        int several = 0;
        for (const NumberField *field : s.window.findChildren<NumberField *>()) {
            const QString name = field->accessibleName();
            if (name.isEmpty() || name == "Value" || field->text() == "—")
                continue;
            if (field == fresh.section()->widthField() || field == fresh.section()->heightField())
                continue; // One chooses in what the sides of a new sheet are given.
            several += units.contains(name);
            if (units.contains(name))
                QVERIFY2(units[name] == unitOf(*field), qPrintable(name + units[name] + " and" + unitOf(*field)));
            units[name] = unitOf(*field);
        }
        QVERIFY(several >= 8); // size, flow, opacity, granulation, drying time, colours, β, angle …
        QCOMPARE(units["Opacity"], QString(" %"));
        QCOMPARE(units["Pigment β"], QString(" %"));
        QCOMPARE(units["Size"], QString(" u"));
    }

    void coloursAreShownInTenthsOfAPerCent()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel);
        const Colour odd{0.433333f, 0.85f, 0.99999f, 1};
        bench.editor.setColour(odd);
        QStringList texts;
        for (const NumberField *field : panel.rows()->findChildren<NumberField *>())
            texts << field->text();
        QCOMPARE(texts, (QStringList{"43.3 %", "85 %", "100 %", "100 %"}));
        QCOMPARE(bench.editor.brush().colour, odd);
        // A drag lands on whole per cents.
        auto *slider = panel.rows()->findChildren<BarSlider *>().front();
        QTest::mouseClick(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.3333));
        const double red = 100 * double(bench.editor.brush().colour.red);
        QVERIFY(std::abs(red - std::round(red)) < 1e-4);
    }

    void recentColoursKeepWhatWasSet()
    {
        const Colour set{0.85f, 0.031f, 0.2f, 0.4f};
        {
            Bench bench;
            ColourPanel panel(bench.editor);
            bench.editor.setColour(set);
            bench.editor.document().setDraft(makeStroke(9, 1, 10)); // painted with
            QTRY_COMPARE(panel.history()->swatches().front().colour, set);
        }
        Bench bench;
        ColourPanel panel(bench.editor); // as in the next session
        QCOMPARE(panel.history()->swatches().front().colour, set);
        for (int i = 0; i < 1000; ++i) {
            const Colour colour{float(i) / 1000, 1.0f / float(i + 1), 0.1f * float(i % 10), 1.0f / 3};
            QCOMPARE(colourOfText(textOf(colour)).value(), colour);
        }
        QVERIFY(!colourOfText("#ff0000"));
        QVERIFY(!colourOfText("0 0 2 1"));
    }

    void draggedColoursArriveExactly()
    {
        const Colour colour{0.1234567f, 0.7654321f, 1.0f / 3, 0.61803f};
        const std::unique_ptr<QMimeData> ours(dragDataOf(colour));
        QCOMPARE(colourOf(*ours).value(), colour);
        QVERIFY(ours->hasColor()); // other programs take it, too
        QMimeData foreign;
        QVERIFY(!colourOf(foreign));
        foreign.setColorData(QColor(255, 0, 0));
        QCOMPARE(colourOf(foreign).value(), fromScreen(QColor(255, 0, 0)));
    }

    void aMessageGoesWithItsCause()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel, {320, 760});
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        auto *hint = panel.findChild<HintLabel *>();
        NumberField *red = panel.rows()->findChildren<NumberField *>().front();
        type(*red, "#202020");
        QVERIFY(hint->isVisible());
        type(*red, "12"); // corrected
        QVERIFY(!hint->isVisible());
        type(*red, "#202020");
        QTRY_VERIFY(hint->isVisible());
        QTest::qWait(1);
        panel.hex()->setFocus(); // left
        QVERIFY(!hint->isVisible());
        type(*panel.hex(), "#202020");
        QVERIFY(!hint->isVisible());
        type(*panel.hex(), "greyish");
        QVERIFY(hint->isVisible());
        bench.editor.setColour({0.2f, 0.2f, 0.2f, 1}); // set by other means
        QVERIFY(!hint->isVisible());

        red->setFocus(); // what leaves the field with the Tab that gives it up is said, and stays a while
        QTest::qWait(1);
        red->selectAll();
        QTest::keyClicks(red, "red");
        QTest::keyClick(red, Qt::Key_Tab);
        QVERIFY(hint->isVisible());
        QTest::qWait(1);
        QVERIFY(hint->isVisible());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(!hint->isVisible());
    }

    /// With the first key that mends it; nobody has to finish first.
    void aMessageGoesWhenItsNumberIsTypedAnew()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel, {320, 760});
        panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        auto *hint = panel.findChild<HintLabel *>();
        NumberField *red = panel.rows()->findChildren<NumberField *>().front();
        type(*red, "#202020");
        QVERIFY(hint->isVisible());
        QTest::keyClick(red, Qt::Key_1);
        QVERIFY(!hint->isVisible());
    }

    void buttonsHaveMnemonicsAndNothingIsSlanted_data()
    {
        QTest::addColumn<QString>("language");
        for (const QString &code : translationCodes())
            QTest::newRow(qPrintable(code)) << code;
    }

    void buttonsHaveMnemonicsAndNothingIsSlanted()
    {
        QFETCH(QString, language);
        settings::setLanguage(language);
        installTranslators();
        const auto restore = qScopeGuard([] {
            settings::setLanguage("en");
            installTranslators();
        });
        Session s;
        s.paintLine({100, 100}, {300, 100}); // a stroke without a name, which the list shows paler
        BrushDialog brush(s.editor(), &s.window);
        AlongDialog along(s.editor(), &s.window);
        NewDialog fresh(&s.window);
        SettingsDialog options(&s.window);
        ExportDialog picture(s.editor(), {0, 0, 10, 10}, &s.window);
        DrawingDialog drawing(s.editor(), &s.window);
        TimelapseDialog film(s.editor(), {0, 0, 10, 10}, &s.window);
        ShortcutsDialog keys({&s.window.action(Command::Undo)}, {}, &s.window);
        AboutDialog about(&s.window);
        for (const QWidget *dialog :
             std::initializer_list<QWidget *>{&brush, &along, &fresh, &options, &picture, &drawing, &film, &keys, &about}) {
            const QString fault = mnemonicFault(*dialog);
            QVERIFY2(fault.isEmpty(), qPrintable(dialog->windowTitle() + ": " + fault));
        }
        for (const QWidget *dialog :
             std::initializer_list<QWidget *>{&brush, &along, &fresh, &options, &picture, &drawing, &film, &keys}) {
            const QString fault = fieldWithoutKey(*dialog);
            QVERIFY2(fault.isEmpty(), qPrintable(dialog->windowTitle() + ": " + fault));
        }
        QCOMPARE(slantedIn(s.window), QString());

        setMessageHooks({});
        for (const auto &ask : std::initializer_list<std::function<void()>>{
                 [&] { showError(&s.window, "x"); },
                 [&] { askToSave(&s.window, "x"); },
                 [&] { askAfterFailedSave(&s.window, "x"); },
                 [&] { askAboutConflict(&s.window, "x", true, true); },
                 [&] { askAboutConflict(&s.window, "x", true, false); },
             }) {
            const QString fault = faultOfBox(ask);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
    }

    void oneMomentIsOneNumber()
    {
        QCOMPARE(clockText(265'866'600), QString("4:25.867"));
        QCOMPARE(clockText(265'866'499), QString("4:25.866"));
        QCOMPARE(clockText(59'999'500), QString("1:00.000"));
        QCOMPARE(clockText(-400), QString("0:00.000"));
        QCOMPARE(clockText(-1'500'000), QString("−0:01.500"));
        for (Microseconds time = 0; time < 3'000'000; time += 333'377) {
            ClockBox box; // where exports ask for a moment
            box.setTime(time);
            QCOMPARE(box.text(), clockText(time));
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWords)
#include "test_words.moc"
