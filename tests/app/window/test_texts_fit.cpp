// Every text is seen as a whole, and every dialog lies on the screen: in all languages, and in ones that take more
// room.
#include "app/panels/colour/colour_panel.h"
#include "app/panels/inspector/group_section.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/look/row_scroll.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/slider_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/all_dialogs.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QStyleOptionDockWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTranslator>
#include <QTreeWidget>

using namespace suffuse;

namespace {

/// A language whose words are three tenths longer than those of the one in use.
class LongerWords : public QTranslator {
public:
    explicit LongerWords(const QString &code) { m_known = m_texts.load(":/i18n/suffuse_" + code + ".qm"); }

    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *text, const char *note, int n) const override
    {
        QString known = m_known ? m_texts.translate(context, text, note, n) : QString();
        if (known.isEmpty())
            known = QString::fromUtf8(text);
        // Keys, names of languages and units are what they are.
        static const QRegularExpression key("^(Ctrl|Alt|Shift)\\+|^.{0,2}$|^[ /²%12.]*$");
        if (key.match(QString::fromUtf8(text)).hasMatch() || QByteArray(context) == "QShortcut")
            return known;
        const QString more = known.contains(QRegularExpression("[\\x{4e00}-\\x{9fff}]")) ? "字" : "m";
        const int letters = int(QString(known).remove(QRegularExpression("%[n0-9]|&|\\(&.\\)|\\*\\.\\w+")).size());
        return known + more.repeated((letters * 3 + 9) / 10);
    }

private:
    QTranslator m_texts;
    bool m_known = false;
};

QString plain(QString text)
{
    return text.remove(QRegularExpression("\\(&.\\)")).remove('&');
}

int widthOf(const QWidget &widget, const QString &text)
{
    return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

bool isCut(const QLabel &label)
{
    const bool takesWhatThereIs = label.sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
    if (!label.pixmap().isNull() || (takesWhatThereIs && label.toolTip() == label.text()))
        return false;
    if (!label.wordWrap())
        return label.sizeHint().width() > label.width() || label.sizeHint().height() > label.height();
    return label.heightForWidth(label.width()) > label.height() || label.minimumSizeHint().width() > label.width();
}

bool isCut(const QAbstractButton &button)
{
    const auto *tool = qobject_cast<const QToolButton *>(&button);
    if (tool && (tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()))
        return false;
    const int icon = button.icon().isNull() ? 0 : button.iconSize().width() + 4;
    const bool framed = tool || qobject_cast<const QPushButton *>(&button);
    return framed ? widthOf(button, button.text()) + icon + 6 > button.width()
                  : button.sizeHint().width() > button.width();
}

QStringList cutIn(const QComboBox &combo)
{
    QStyleOptionComboBox option;
    option.initFrom(&combo);
    option.editable = combo.isEditable();
    const int room =
        combo.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &combo).width();
    QStringList cut;
    for (int i = 0; i < combo.count(); ++i) {
        const int icon = combo.itemIcon(i).isNull() ? 0 : combo.iconSize().width() + 4;
        if (widthOf(combo, combo.itemText(i)) + icon > room)
            cut << combo.itemText(i);
    }
    return cut;
}

QStringList cutIn(const QTabBar &bar)
{
    QStringList cut;
    for (int i = 0; i < bar.count(); ++i)
        if (widthOf(bar, bar.tabText(i)) + 8 > bar.tabRect(i).width() || !bar.rect().contains(bar.tabRect(i)))
            cut << bar.tabText(i);
    return cut;
}

QStringList cutIn(const QHeaderView &header)
{
    QStringList cut;
    if (header.orientation() == Qt::Horizontal)
        for (int i = 0; i < header.count(); ++i) {
            const QString text = header.model() ? header.model()->headerData(i, Qt::Horizontal).toString() : QString();
            if (!header.isSectionHidden(i) && widthOf(header, text) + 6 > header.sectionSize(i))
                cut << text;
        }
    return cut;
}

bool isCut(const QDockWidget &dock)
{
    if (dock.visibleRegion().isEmpty())
        return false;
    QStyleOptionDockWidget option;
    option.initFrom(&dock);
    option.rect = QRect(0, 0, dock.width(), 24);
    option.title = dock.windowTitle();
    option.closable = option.floatable = true;
    return widthOf(dock, dock.windowTitle()) >
           dock.style()->subElementRect(QStyle::SE_DockWidgetTitleBarText, &option, &dock).width();
}

/// A dock behind another one lies anywhere, in any size.
bool isBehind(const QWidget *widget)
{
    while (widget && !qobject_cast<const QDockWidget *>(widget))
        widget = widget->parentWidget();
    return widget && widget->visibleRegion().isEmpty();
}

/// The texts in a window that cannot be read to their ends.
QStringList cutTexts(const QWidget &root)
{
    QStringList cut;
    for (const QWidget *widget : root.findChildren<QWidget *>()) {
        if (!widget->isVisible() || isBehind(widget))
            continue;
        QStringList own;
        if (const auto *label = qobject_cast<const QLabel *>(widget);
            label && !label->text().isEmpty() && isCut(*label))
            own << label->text();
        if (const auto *button = qobject_cast<const QAbstractButton *>(widget);
            button && !button->text().isEmpty() && isCut(*button))
            own << button->text();
        if (const auto *combo = qobject_cast<const QComboBox *>(widget))
            own << cutIn(*combo);
        if (const auto *bar = qobject_cast<const QTabBar *>(widget))
            own << cutIn(*bar);
        if (const auto *header = qobject_cast<const QHeaderView *>(widget))
            own << cutIn(*header);
        if (const auto *box = qobject_cast<const QGroupBox *>(widget);
            box && box->minimumSizeHint().width() > box->width())
            own << box->title();
        if (const auto *dock = qobject_cast<const QDockWidget *>(widget); dock && isCut(*dock))
            own << dock->windowTitle();
        // What scrolls only up and down cuts off what is wider than it.
        if (const auto *area = qobject_cast<const QScrollArea *>(widget);
            area && area->widget() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff &&
            area->widget()->width() > area->viewport()->width())
            own << QString("all that is in %1, by %2")
                       .arg(area->parentWidget()->metaObject()->className())
                       .arg(area->widget()->width() - area->viewport()->width());
        for (const QString &text : own)
            cut << QString("%1 (%2): %3")
                       .arg(widget->metaObject()->className(), widget->parentWidget()->metaObject()->className(),
                            plain(text));
    }
    return cut;
}

void settle()
{
    for (int i = 0; i < 3; ++i)
        QCoreApplication::processEvents();
}

} // namespace

class TestTextsFit : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QCOMPARE(QGuiApplication::primaryScreen()->availableGeometry(), QRect(0, 0, 1366, 768));
    }

    void init() { window_layout::reset(); }
    void cleanup()
    {
        m_longer.reset();
        settings::setLanguage("en");
        installTranslators();
    }

    void nothingIsCut_data() { languages(); }
    void nothingIsCut()
    {
        speak();
        WaveSession s;
        s.window.setGeometry(0, 24, 1366, 744);
        for (auto *dock : s.window.findChildren<QDockWidget *>())
            dock->show();
        QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs); // the status bar then says what draws
        QStringList cut;
        const auto look = [&](const QString &when) {
            settle();
            for (const QString &text : cutTexts(s.window))
                if (!cut.contains(when + text))
                    cut << when + text;
        };
        for (const Command tool :
             {Command::Brush, Command::Select, Command::Segments, Command::Shapes, Command::OutlinePen,
              Command::LassoFill, Command::Bucket, Command::Text, Command::Redraw, Command::Push, Command::Knife,
              Command::Eraser, Command::AttributeBrush, Command::Eyedropper, Command::Assistants, Command::Pan}) {
            s.use(tool);
            look("with a tool: ");
            const bool scrolls = tool == Command::Text; // that of texts is longer than others
            for (const auto *row : s.window.findChildren<RowScroll *>())
                if (!scrolls && row->isVisible() && row->horizontalScrollBar()->maximum() > 0)
                    cut << QString("the row over the canvas of %1, by %2")
                               .arg(plain(s.window.action(tool).text()))
                               .arg(row->horizontalScrollBar()->maximum());
        }
        for (auto *dock : s.window.findChildren<QDockWidget *>()) {
            dock->raise();
            look(dock->objectName() + ": ");
        }
        s.use(Command::EditHere);
        look("values: ");
        s.use(Command::BrushPalette);
        look("palette: ");
        s.window.findChild<QDockWidget *>("inspectorDock")->raise();
        s.use(Command::SelectAll);
        s.use(Command::GroupStrokes);
        QTRY_VERIFY(s.window.findChild<GroupSection *>()->isVisible());
        look("a group: ");
        s.editor().document().setSelection({});
        look("nothing selected: ");
        cut.removeDuplicates();
        QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
        QVERIFY2(s.window.width() <= 1366, qPrintable(QString::number(s.window.width())));
        QVERIFY2(s.window.height() <= 744, qPrintable(QString::number(s.window.height())));
        QVERIFY2(s.canvas().width() >= 400, qPrintable(QString::number(s.canvas().width())));
    }

    /// At 144 dpi a screen of 1366 pixels is 910 wide, and the brush's row needs no scrolling there.
    void theBrushsRowFitsSmallScreens_data() { languages(); }
    void theBrushsRowFitsSmallScreens()
    {
        if (QByteArray(QTest::currentDataTag()).endsWith("longer"))
            QSKIP("a language that nobody speaks");
        speak();
        WaveSession s;
        s.window.setGeometry(0, 24, 910, 488);
        s.use(Command::Brush);
        s.editor().setBrush(*findBrush("round-wash")); // with a field for its smoothing
        settle();
        int rows = 0;
        for (const auto *row : s.window.findChildren<RowScroll *>())
            if (row->widget() == s.canvas().tool()->options()) {
                QVERIFY(row->isVisible());
                QCOMPARE(row->horizontalScrollBar()->maximum(), 0);
                ++rows;
            }
        QCOMPARE(rows, 1);
        QCOMPARE(s.window.width(), 910);
    }

    /// Whoever has the system's letters half as large again finds all texts whole, in the window and in its dialogs.
    void largeLettersAreWhole()
    {
        const QFont usual = QApplication::font();
        const auto restore = qScopeGuard([&] { QApplication::setFont(usual); });
        QFont large = usual;
        large.setPointSizeF(1.5 * usual.pointSizeF());
        QApplication::setFont(large);
        WaveSession s;
        QStringList cut;
        const auto look = [&](const QWidget &window, const QString &when) {
            settle();
            for (const QString &text : cutTexts(window))
                cut << when + text;
        };
        s.window.setGeometry(0, 24, 1900, 1200);
        for (auto *dock : s.window.findChildren<QDockWidget *>()) {
            dock->show();
            dock->raise();
            look(s.window, dock->objectName() + ": ");
        }
        QVERIFY(s.window.menuBar()->fontMetrics().height() > 1.3 * QFontMetrics(usual).height());
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->show();
            look(*dialog, QString("%1: ").arg(maker.name));
        }
        cut.removeDuplicates();
        QVERIFY2(cut.isEmpty(), qPrintable('\n' + cut.join('\n')));
    }

    /// No slider of the colour is cut in the lowest window.
    void colourSlidersAreSeen()
    {
        WaveSession s;
        s.window.setGeometry(0, 24, 1366, 744);
        settle();
        const ColourPanel &panel = *s.window.findChild<ColourPanel *>();
        for (int channel = 0; channel < 4; ++channel) {
            const QWidget &slider = *panel.rows()->row(channel)->slider();
            QCOMPARE(slider.visibleRegion().boundingRect(), slider.rect());
        }
    }

    void slidersCanBeDragged_data() { languages(); }
    void slidersCanBeDragged()
    {
        speak();
        WaveSession s;
        s.window.setGeometry(0, 24, 1366, 744);
        int seen = 0;
        for (auto *dock : s.window.findChildren<QDockWidget *>()) {
            dock->raise();
            settle();
            for (const auto *slider : s.window.findChildren<BarSlider *>())
                if (slider->isVisible()) {
                    QVERIFY2(slider->width() >= 90, qPrintable(slider->accessibleName()));
                    ++seen;
                }
        }
        QVERIFY(seen > 10);
    }

    void dialogsAreWhole_data() { languages(); }
    void dialogsAreWhole()
    {
        speak();
        WaveSession s;
        s.window.setGeometry(300, 224, 1000, 500);
        const QRect screen = s.window.screen()->availableGeometry();
        QStringList wrong;
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->show();
            const auto look = [&] {
                settle();
                const QRect framed = dialog->geometry().adjusted(0, -24, 0, 0);
                if (!screen.contains(framed))
                    wrong << QString("%1 reaches beyond the screen: %2, %3, %4 × %5")
                                 .arg(maker.name)
                                 .arg(framed.x())
                                 .arg(framed.y())
                                 .arg(framed.width())
                                 .arg(framed.height());
                for (const QString &text : cutTexts(*dialog))
                    wrong << QString("%1: %2").arg(maker.name, text);
            };
            look();
            for (auto *tabs : dialog->findChildren<QTabWidget *>())
                for (int page = 1; page < tabs->count(); ++page) {
                    tabs->setCurrentIndex(page);
                    look();
                }
            dialog->reject();
        }
        wrong.removeDuplicates();
        QVERIFY2(wrong.isEmpty(), qPrintable('\n' + wrong.join('\n')));
    }

    /// In the list of shortcuts.
    void commandsHaveNamesOfTheirOwn_data() { languages(); }
    void commandsHaveNamesOfTheirOwn()
    {
        speak();
        Session s;
        ShortcutsDialog dialog(s.window.findChild<Commands *>()->all(), fixedKeys(), &s.window);
        dialog.show();
        settle();
        QSet<QString> names;
        const QTreeWidget &list = *dialog.list();
        for (int row = 0; row < list.topLevelItemCount(); ++row) {
            const QTreeWidgetItem *item = list.topLevelItem(row);
            const QString name = item->text(0);
            QVERIFY2(!names.contains(name), qPrintable(name));
            names << name;
            for (int column = 0; column < 2; ++column)
                QVERIFY2(list.visualItemRect(item).isNull() ||
                             widthOf(list, item->text(column)) + (column ? 0 : 20) <= list.columnWidth(column),
                         qPrintable(item->text(column)));
        }
        QVERIFY(names.size() > 100);
        if (QString(QTest::currentDataTag()) == "en") {
            QVERIFY(names.contains("File ▸ Import Strokes"));
            QVERIFY(names.contains("Object ▸ Align ▸ Left Edges"));
        }
    }

    void dialogsOpenOverTheirWindow()
    {
        const QRect screen(0, 0, 1366, 768);
        QCOMPARE(placeOver({400, 300}, {100, 100, 1000, 600}, screen), QRect(400, 250, 400, 300));
        QCOMPARE(placeOver({400, 300}, {-300, -200, 400, 300}, screen), QRect(0, 0, 400, 300));
        QCOMPARE(placeOver({400, 300}, {1300, 700, 400, 300}, screen), QRect(966, 468, 400, 300));
        QCOMPARE(placeOver({2000, 900}, {100, 100, 1000, 600}, screen), screen);
        MainWindow window;
        for (const QRect place : {QRect(300, 200, 900, 500), QRect(-500, -300, 800, 600), QRect(1200, 700, 800, 600)}) {
            window.setGeometry(place);
            window.show();
            NewDialog dialog(&window);
            dialog.show();
            settle();
            QVERIFY(screen.contains(dialog.frameGeometry()));
            if (screen.contains(place))
                QVERIFY((dialog.frameGeometry().center() - place.center()).manhattanLength() < 40);
            dialog.move(50, 60);
            dialog.hide();
            dialog.show();
            QCOMPARE(dialog.pos(), QPoint(50, 60)); // where the user put it
        }
    }

    /// One that grows after it is shown is put in the corner by window managers that have not yet put a frame around
    /// it.
    void dialogsHaveTheirSizeWhenTheyAreShown()
    {
        Session s;
        s.window.show();
        settle();
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->show();
            const QRect place = dialog->geometry();
            settle();
            QVERIFY2(dialog->geometry() == place, maker.name);
            dialog->reject();
        }
    }

private:
    static void languages()
    {
        QTest::addColumn<QString>("code");
        QTest::addColumn<bool>("longer");
        for (const QString &code : translationCodes()) {
            QTest::newRow(qPrintable(code)) << code << false;
            QTest::newRow(qPrintable(code + ", longer")) << code << true;
        }
    }

    void speak()
    {
        QFETCH(QString, code);
        QFETCH(bool, longer);
        settings::setLanguage(code);
        installTranslators();
        if (longer) {
            m_longer = std::make_unique<LongerWords>(code);
            QCoreApplication::installTranslator(m_longer.get());
        }
    }

    QTemporaryDir m_folder;
    std::unique_ptr<LongerWords> m_longer;
};

/// A small screen.
int main(int argc, char **argv)
{
    QTemporaryDir folder;
    QFile file(folder.filePath("screen.json"));
    if (!file.open(QIODevice::WriteOnly))
        return 1;
    file.write(R"({"screens": [{"name": "small", "x": 0, "y": 0, "width": 1366, "height": 768,
                   "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})");
    file.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + file.fileName().toLocal8Bit());
    QApplication application(argc, argv);
    TestTextsFit test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_texts_fit.moc"
