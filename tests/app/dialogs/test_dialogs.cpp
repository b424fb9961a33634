// Dialogs: shortcuts never clash, settings are kept or put back.
#include "app/dialogs/about_dialog.h"
#include "app/dialogs/new_dialog.h"
#include "app/dialogs/settings_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/ask_number.h"
#include "app/widgets/habits/dialog_scroll.h"
#include "app/widgets/habits/house_rules.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/length_units.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/paper/canvas_section.h"
#include "tests/app/all_dialogs.h"
#include "tests/app/panel_bench.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <array>

using namespace suffuse;

class TestDialogs : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder->filePath("settings.ini").toUtf8());
    }

    /// A laptop's fine screen is 384 logical pixels high, less title and task bar.
    void dialogsFitOnLowScreens()
    {
        WaveSession s;
        constexpr QSize room(683, 330);
        int scrolled = 0;
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->setAttribute(Qt::WA_DeleteOnClose, false);
            scrollIfHigher(*dialog, room);
            dialog->show();
            QVERIFY(QTest::qWaitFor([&] { return QApplication::activeWindow() == dialog.get(); }));
            QVERIFY2(dialog->minimumSizeHint().height() <= room.height(), maker.name);
            QVERIFY2(dialog->minimumSizeHint().width() <= room.width(), maker.name);
            dialog->resize(room);
            QCoreApplication::processEvents();
            const auto isSeen = [&](const QWidget &widget) {
                return dialog->rect().contains(QRect(widget.mapTo(dialog.get(), QPoint()), widget.size()));
            };
            for (const auto *box : dialog->findChildren<QDialogButtonBox *>())
                QVERIFY2(box->isVisible() && isSeen(*box), maker.name);
            // The keyboard brings into view what it comes to.
            auto *area = dialog->findChild<QScrollArea *>(QString(), Qt::FindDirectChildrenOnly);
            scrolled += area != nullptr;
            for (int i = 0; area && i < 40; ++i) {
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
                const QWidget *focus = QApplication::focusWidget();
                const QPoint middle = focus->mapTo(dialog.get(), focus->rect().center());
                QVERIFY2(dialog->rect().contains(middle) && !focus->visibleRegion().isEmpty(),
                         qPrintable(QString(maker.name) + ": " + focus->accessibleName()));
            }
            dialog->reject();
        }
        QVERIFY2(scrolled >= 4, qPrintable(QString::number(scrolled)));
    }

    void whatIsHigherThanTheScreenScrolls()
    {
        WaveSession s; // installs the rules
        for (const int higher : {-300, 500}) {
            const int screen = s.window.screen()->availableGeometry().height();
            QDialog dialog(&s.window);
            auto *column = new QVBoxLayout(&dialog);
            auto *content = new QLineEdit(&dialog);
            content->setMinimumHeight(screen + higher);
            auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok, &dialog);
            column->addWidget(content);
            column->addWidget(buttons);
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            QVERIFY(dialog.frameGeometry().height() <= screen);
            QVERIFY(dialog.rect().contains(QRect(buttons->mapTo(&dialog, QPoint()), buttons->size())));
            QCOMPARE(dialog.findChild<QScrollArea *>() != nullptr, higher > 0);
            QCOMPARE(dialog.focusWidget(), content);
        }
    }

    void newCanvas()
    {
        NewDialog dialog;
        dialog.show();
        QCOMPARE(dialog.canvas(), Editor::usualCanvas());
        emit dialog.presets()->activated(1);
        QCOMPARE(dialog.canvas().width, 1920.0);
        QCOMPARE(dialog.canvas().height, 1080.0);
        type(*dialog.section()->widthField(), "1000");
        QCOMPARE(dialog.canvas().width, 1000.0);
        QCOMPARE(dialog.presets()->currentIndex(), -1);
    }

    /// One list of sheets, wherever a painting begins.
    void newPaintingsHaveTheSheetsOfTheWelcomePage()
    {
        NewDialog dialog;
        dialog.show();
        const auto choose = [&](const QString &name) {
            for (int i = 0; i < dialog.presets()->count(); ++i)
                if (dialog.presets()->itemText(i).startsWith(name + " — "))
                    return emit dialog.presets()->activated(i);
            QFAIL(qPrintable(name));
        };
        const std::vector<SheetPreset> sheets = sheetPresets();
        for (const SheetPreset &sheet : sheets) {
            choose(sheet.name);
            QCOMPARE(dialog.canvas().width, sheet.canvas.width);
            QCOMPARE(dialog.canvas().height, sheet.canvas.height);
            QCOMPARE(sheet.hasGround, dialog.canvas().background == sheet.canvas.background &&
                                          dialog.canvas().paper == sheet.canvas.paper && sheet.hasGround);
            QCOMPARE(dialog.presets()->currentText(), sheet.name + " — " + sheet.size);
        }
        choose("A4");
        dialog.units()->setCurrentIndex(1);
        emit dialog.units()->activated(1);
        QCOMPARE(dialog.section()->widthField()->text(), QString("297 mm"));
        emit dialog.resolution()->entered(300);
        QCOMPARE(dialog.canvas().width, 3508.0);
        QCOMPARE(dialog.canvas().height, 2480.0);
        QVERIFY(dialog.presets()->currentText().startsWith("A4"));
        type(*dialog.section()->heightField(), "100");
        QCOMPARE(dialog.canvas().height, 1181.0); // whole pixels
        QCOMPARE(dialog.section()->heightField()->text(), QString("100 mm"));
        dialog.units()->setCurrentIndex(2);
        emit dialog.units()->activated(2);
        QCOMPARE(dialog.section()->heightField()->text(), QString("3.94 in"));
        QCOMPARE(dialog.canvas().height, 1181.0);
        QCOMPARE(dialog.sheet().resolution, 300.0);
        choose("Full HD");
        QCOMPARE(dialog.section()->widthField()->text(), QString("1920 px"));
        QCOMPARE(dialog.sheet().resolution, 0.0); // It has no size on paper.
        choose("A5");
        dialog.units()->setCurrentIndex(0);
        emit dialog.units()->activated(0); // only looked at in pixels
        QCOMPARE(dialog.sheet().resolution, 300.0);
        for (const SheetPreset &sheet : sheets)
            QCOMPARE(sheet.sheet().resolution, sheet.paper.isEmpty() ? 0.0 : usualResolution);
    }

    /// Another painting is open, whose units are of another size on paper.
    void aNewPapersGrainIsMeasuredByTheNewSheet()
    {
        const CanvasAids usual = settings::canvasAids();
        CanvasAids aids = usual;
        aids.rulerUnits = RulerUnits::Millimetres;
        settings::setCanvasAids(aids);
        QWidget window;
        new LengthUnits(window, 600);
        {
            NewDialog dialog(&window);
            dialog.show();
            Canvas canvas = Editor::usualCanvas();
            canvas.paper.kind = PaperKind::Procedural;
            canvas.paper.scale = 60;
            dialog.section()->setCanvas(canvas);
            NumberField *scale = dialog.section()->paperScale()->number();
            QCOMPARE(scale->text(), QString("10.16 mm")); // The sheet says nothing: 150 units an inch.
            dialog.units()->setCurrentIndex(1);
            emit dialog.units()->activated(1);
            emit dialog.resolution()->entered(300);
            QCOMPARE(scale->text(), QString("5.08 mm"));
            type(*scale, "2.54");
            QCOMPARE(dialog.canvas().paper.scale, 30.0F);
        }
        settings::setCanvasAids(usual);
    }

    void settingsAreKeptOrPutBack()
    {
        settings::setTheme(settings::Theme::Light);
        applyTheme();
        {
            SettingsDialog dialog;
            dialog.theme()->setCurrentIndex(int(settings::Theme::Dark));
            QVERIFY(isDarkTheme()); // shown at once
            dialog.reject();
        }
        QVERIFY(!isDarkTheme());
        QCOMPARE(settings::theme(), settings::Theme::Light);
        SettingsDialog dialog;
        dialog.language()->setCurrentIndex(dialog.language()->findData("de"));
        dialog.presenter()->setCurrentIndex(int(settings::Presenter::Raster));
        dialog.backend()->setCurrentText("CUDA");
        dialog.threads()->setValue(2);
        QCOMPARE(dialog.backups()->value(), 2);
        dialog.backups()->setValue(3);
        dialog.accept();
        QCOMPARE(settings::backups(), 3);
        QCOMPARE(settings::language(), QString("de"));
        QCOMPARE(settings::presenter(), settings::Presenter::Raster);
        QCOMPARE(settings::backend(), Backend::Cuda);
        QCOMPARE(settings::threads(), 2);
    }

    void shortcutsAreEditedAndKept()
    {
        const auto make = [](QObject *parent) {
            QList<QAction *> actions;
            for (const char *name : {"Open", "Save", "Undo"}) {
                auto *action = new QAction(QString::fromLatin1(name), parent);
                action->setObjectName(name);
                action->setShortcut(QKeySequence(QString("Ctrl+") + QLatin1Char(name[0])));
                actions << action;
            }
            return actions;
        };
        QObject first;
        const QList<QAction *> actions = make(&first);
        applyStoredShortcuts(actions);
        ShortcutsDialog dialog(actions);
        dialog.show();
        QCOMPARE(dialog.list()->topLevelItemCount(), 3);
        auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        dialog.list()->setCurrentItem(dialog.list()->topLevelItem(2));
        dialog.editor()->setKeySequence(QKeySequence("Ctrl+S"));
        QVERIFY(dialog.conflict()->isVisible());
        QVERIFY(!ok->isEnabled());
        dialog.editor()->setKeySequence(QKeySequence("Alt+Z"));
        QVERIFY(!dialog.conflict()->isVisible());
        QVERIFY(ok->isEnabled());
        dialog.accept();
        QCOMPARE(actions[2]->shortcut(), QKeySequence("Alt+Z"));

        QObject second; // the next start
        const QList<QAction *> next = make(&second);
        applyStoredShortcuts(next);
        QCOMPARE(next[2]->shortcut(), QKeySequence("Alt+Z"));
        QCOMPARE(next[1]->shortcut(), QKeySequence("Ctrl+S"));
        ShortcutsDialog again(next);
        again.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::RestoreDefaults)->click();
        again.accept();
        QCOMPARE(next[2]->shortcut(), QKeySequence("Ctrl+U"));
        QVERIFY(settings::store().allKeys().filter("shortcuts/").isEmpty());
    }

    /// Keys that no command can have are shown, and a clash with one cannot be kept.
    void fixedKeysClash()
    {
        QObject owner;
        QList<QAction *> actions;
        for (const auto &[name, keys] : {std::pair{"Open", "Ctrl+O"}, {"Knife", "K"}}) {
            auto *action = new QAction(QString::fromLatin1(name), &owner);
            action->setObjectName(QString("fixed") + name);
            action->setShortcuts(QKeySequence::listFromString(keys));
            actions << action;
        }
        applyStoredShortcuts(actions);
        ShortcutsDialog dialog(actions, fixedKeys());
        dialog.show();
        QCOMPARE(dialog.list()->topLevelItemCount(), 2 + int(fixedKeys().size()));
        auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        dialog.list()->setCurrentItem(dialog.list()->topLevelItem(2)); // the first fixed one
        QCOMPARE(dialog.list()->currentItem()->text(1), QString("Left, Right, Up, Down").replace(", ", "; "));
        QVERIFY(!dialog.editor()->isEnabled());
        for (const FixedKeys &fixed : fixedKeys())
            for (const QKeySequence &key : fixed.keys) {
                dialog.list()->setCurrentItem(dialog.list()->topLevelItem(1));
                dialog.editor()->setKeySequence(key);
                QVERIFY2(dialog.conflict()->isVisible() && !ok->isEnabled(), qPrintable(key.toString()));
                QVERIFY(dialog.conflict()->text().contains(fixed.title));
                for (QPushButton *button : dialog.findChildren<QPushButton *>())
                    QVERIFY(button->text() != "&Take Over" || !button->isVisible()); // there is nothing to take
            }
        dialog.editor()->setKeySequence(QKeySequence("X"));
        QVERIFY(!dialog.conflict()->isVisible() && ok->isEnabled());
    }

    void onlyShortcutsThatAreSeenChange()
    {
        QObject owner;
        QList<QAction *> actions;
        for (const auto &[name, keys] : {std::pair{"Open", "Ctrl+O"}, {"Cut", "Ctrl+X; Shift+Del"}, {"Knife", "K"}}) {
            auto *action = new QAction(QString::fromLatin1(name), &owner);
            action->setObjectName(QString("seen") + name);
            action->setShortcuts(QKeySequence::listFromString(keys));
            actions << action;
        }
        applyStoredShortcuts(actions);
        ShortcutsDialog dialog(actions);
        dialog.show();
        auto *search = dialog.findChild<QLineEdit *>();
        const std::array widths{dialog.list()->columnWidth(0), dialog.list()->columnWidth(1)};
        search->setText("knife");
        QTest::qWait(20); // The columns stay where they are, though the others' names and keys are gone.
        QCOMPARE((std::array{dialog.list()->columnWidth(0), dialog.list()->columnWidth(1)}), widths);
        QCOMPARE(dialog.list()->currentItem()->text(0), QString("Knife"));
        QCOMPARE(dialog.editor()->keySequence(), QKeySequence("K"));
        search->setText("nothing of the kind");
        QVERIFY(!dialog.list()->currentItem());
        QVERIFY(!dialog.editor()->isEnabled());
        search->clear();
        dialog.list()->setCurrentItem(dialog.list()->topLevelItem(1));
        dialog.editor()->setKeySequence(QKeySequence("Ctrl+O")); // a clash, resolved by taking it over
        auto *takeOver = [&] {
            for (QPushButton *button : dialog.findChildren<QPushButton *>())
                if (button->text() == "&Take Over")
                    return button;
            return static_cast<QPushButton *>(nullptr);
        }();
        QVERIFY(takeOver && takeOver->isVisible());
        takeOver->click();
        QVERIFY(!takeOver->isVisible());
        dialog.accept();
        QCOMPARE(actions[0]->shortcuts(), QList<QKeySequence>());
        QCOMPARE(actions[1]->shortcuts(), QList<QKeySequence>({QKeySequence("Ctrl+O"), QKeySequence("Shift+Del")}));
        settings::store().clear();
    }

    /// Commands are found by their English names, too, as Find a Command finds them.
    void shortcutsAreFoundInEnglish()
    {
        QObject owner;
        QList<QAction *> actions;
        for (const auto &[title, name] : {std::pair{"Messer", "knife"}, {"Verlauf hinzufügen", "addGradient"}}) {
            auto *action = new QAction(QString::fromUtf8(title), &owner);
            action->setObjectName(QString::fromLatin1(name));
            actions << action;
        }
        ShortcutsDialog dialog(actions);
        dialog.show();
        auto *search = dialog.findChild<QLineEdit *>();
        search->setText("knife");
        QVERIFY(dialog.list()->currentItem());
        QCOMPARE(dialog.list()->currentItem()->text(0), QString("Messer"));
        search->setText("add gradient");
        QVERIFY(dialog.list()->currentItem());
        QCOMPARE(dialog.list()->currentItem()->text(0), QString("Verlauf hinzufügen"));
    }

    /// Where no desktop has been told of Suffuse, too.
    void ownFilesHaveATypeInTheFileDialog()
    {
        installHouseRules();
        for (const char *name : {"a.suffuse", "b.suffuse-brush", "c.suffuse~"}) {
            QFile file(m_folder->filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        QFileDialog dialog(nullptr, "Open", m_folder->path());
        dialog.setOption(QFileDialog::DontUseNativeDialog);
        dialog.show();
        const QTreeView *view = dialog.findChild<QTreeView *>("treeView");
        QVERIFY(view);
        const auto typeOf = [&](const QString &name) {
            for (int row = 0; row < view->model()->rowCount(view->rootIndex()); ++row)
                if (view->model()->index(row, 0, view->rootIndex()).data().toString() == name)
                    return view->model()->index(row, 2, view->rootIndex()).data().toString();
            return QString();
        };
        QTRY_COMPARE(typeOf("a.suffuse"), QString("Suffuse painting"));
        QTRY_COMPARE(typeOf("b.suffuse-brush"), QString("Suffuse brush"));
        QTRY_COMPARE(typeOf("c.suffuse~"), QString("Backup of a painting"));
    }

    /// The question stands beside its number, and not above it.
    /// A letter that is underlined loses its kerning, and the end of the text still has room.
    void labelsWithUnderlinedLettersHaveRoom()
    {
        QWidget dialog;
        QLineEdit field(&dialog);
        for (const char *text : {"Temps de s\u00e9chage", "Valeur", "Type"}) {
            QLabel label(QString::fromUtf8(text), &dialog);
            label.setBuddy(&field);
            giveMnemonics(dialog);
            QVERIFY(label.text().contains('&'));
            const auto ink = [&label](int width) {
                label.resize(width, label.sizeHint().height());
                const QImage image = label.grab().toImage();
                int count = 0;
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x)
                        count += image.pixel(x, y) != image.pixel(image.width() - 1, 0);
                return count;
            };
            const int width = std::max(label.sizeHint().width(), label.minimumWidth());
            QCOMPARE(ink(width), ink(width + 40));
        }
    }

    void aNumberIsAskedForInOneLine()
    {
        QTimer::singleShot(0, this, [] {
            auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            const auto *label = dialog->findChild<QLabel *>();
            auto *box = dialog->findChild<QDoubleSpinBox *>();
            QVERIFY(std::abs(label->geometry().center().y() - box->geometry().center().y()) <= 2);
            QVERIFY(label->geometry().right() < box->geometry().left());
            box->setValue(2.5);
            dialog->accept();
        });
        QCOMPARE(askNumber(nullptr, {"Title", "Seconds", 1, 0, 10}), std::optional(2.5));
    }

    /// The handle stands out from its groove as the edges of fields do from theirs: by 3 to 1.
    void handlesOfScrollBarsAreSeen()
    {
        const auto luminance = [](const QColor &colour) {
            const auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
            return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
        };
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            settings::setTheme(theme);
            applyTheme();
            QScrollBar bar(Qt::Vertical);
            bar.setRange(0, 300);
            bar.setPageStep(300);
            bar.resize(bar.sizeHint().width(), 300);
            const QImage image = bar.grab().toImage();
            const int x = image.width() / 2;
            const double handle = luminance(image.pixelColor(x, 60)), groove = luminance(image.pixelColor(x, 220));
            const double contrast = (std::max(handle, groove) + 0.05) / (std::min(handle, groove) + 0.05);
            QVERIFY2(contrast >= 3, qPrintable(QString::number(contrast)));
        }
    }

    void iconsAreDrawnInThePalettesColour()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            settings::setTheme(theme);
            applyTheme();
            const QRgb ink = QApplication::palette().color(QPalette::ButtonText).rgb();
            for (const QString &name : iconNames()) {
                const QImage image = icon(name).pixmap(QSize(32, 32)).toImage().convertToFormat(QImage::Format_ARGB32);
                int drawn = 0;
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x)
                        if (qAlpha(image.pixel(x, y)) == 255) {
                            QVERIFY2(std::abs(qGray(image.pixel(x, y)) - qGray(ink)) < 3, qPrintable(name));
                            ++drawn;
                        }
                QVERIFY2(drawn > 5 && drawn < 32 * 32 / 2, qPrintable(name));
            }
        }
        QVERIFY(icon("no such icon").isNull());
        QVERIFY(iconNames().contains("brush"));
        for (const int size : {32, 256}) {
            const QImage image = applicationIcon().pixmap(QSize(size, size)).toImage();
            QCOMPARE(image.width(), size);
            QCOMPARE(image.pixelColor(size * 3 / 4, size / 4).alpha(), 255);                 // paper
            QVERIFY(image.pixelColor(size * 114 / 256, size * 151 / 256).lightness() < 128); // the curve
        }
    }

    void aboutSaysWhatRuns()
    {
        AboutDialog dialog;
        QString all;
        for (const QLabel *label : dialog.findChildren<QLabel *>())
            all += label->text() + '\n';
        QVERIFY(all.contains(SUFFUSE_VERSION));
        QVERIFY(all.contains("CPU"));
        QVERIFY(all.contains(qVersion()));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(TestDialogs)
#include "test_dialogs.moc"
