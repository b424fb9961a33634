// Tool tips and open messages follow a theme that changes while the program runs, and icons are sharp.
#include "app/canvas/overlay/overlay.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/session/editor.h"
#include "app/session/settings/motion.h"
#include "app/session/settings/settings.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/reduced_motion.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QStyleOption>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <cmath>

using namespace suffuse;

namespace {

void wear(settings::Theme theme)
{
    settings::setTheme(theme);
    applyTheme();
}

double luminance(const QColor &colour)
{
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor &a, const QColor &b)
{
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

QImage painted(QRgb colour)
{
    QImage image(20, 20, QImage::Format_ARGB32_Premultiplied);
    image.fill(0);
    for (int x = 2; x < 18; ++x)
        image.setPixel(x, 10, colour);
    return image;
}

} // namespace

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }

    void headingsOfMenusHaveRoom()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            wear(theme);
            QMenu menu;
            QAction *heading = menu.addSection("Heading"), *entry = menu.addAction("Entry");
            menu.ensurePolished();
            const QImage picture = menu.grab().toImage();
            const QRect area = menu.actionGeometry(heading);
            QVERIFY(menu.actionGeometry(entry).top() > area.bottom());
            // Below the frame there is nothing but ground above the heading's letters.
            const double ratio = picture.devicePixelRatio();
            const int top = int((area.top() + 1) * ratio);
            const QRgb ground = picture.pixel(int(2 * ratio), top);
            const auto hasInk = [&](int y) {
                for (int x = int((area.left() + 5) * ratio); x < int((area.left() + 40) * ratio); ++x)
                    if (picture.pixel(x, y) != ground)
                        return true;
                return false;
            };
            int above = 0;
            while (above < int((area.height() - 1) * ratio) && !hasInk(top + above))
                ++above;
            QVERIFY2(above >= 4 * ratio && above < (area.height() - 1) * ratio, qPrintable(QString::number(above)));
        }
    }

    void toolTipsAndOpenMessagesFollow()
    {
        QToolTip::setPalette(QPalette(Qt::yellow)); // as some platforms give them one
        wear(settings::Theme::Light);
        QMessageBox box(QMessageBox::Warning, "x", "y");
        const QImage light = box.iconPixmap().toImage();
        wear(settings::Theme::Dark);
        QVERIFY(box.iconPixmap().toImage() != light);
        QCOMPARE(QToolTip::palette().color(QPalette::ToolTipBase), darkPalette().color(QPalette::ToolTipBase));
    }

    void iconsOfTitlesAndDialogsAreSharp()
    {
        wear(settings::Theme::Light);
        using S = QStyle::StandardPixmap;
        for (const S standard :
             {S::SP_TitleBarNormalButton, S::SP_TitleBarCloseButton, S::SP_DockWidgetCloseButton,
              S::SP_MessageBoxWarning, S::SP_MessageBoxQuestion, S::SP_MessageBoxInformation, S::SP_MessageBoxCritical,
              S::SP_DialogOkButton, S::SP_DialogCancelButton, S::SP_DialogSaveButton, S::SP_DialogDiscardButton,
              S::SP_LineEditClearButton, S::SP_ToolBarHorizontalExtensionButton, S::SP_FileDialogNewFolder}) {
            const QIcon found = QApplication::style()->standardIcon(standard);
            for (const int side : {12, 16, 48})
                QCOMPARE(found.pixmap(QSize(side, side), 2.0).size(), QSize(2 * side, 2 * side));
            // Who asks for a picture instead is given the same one.
            const int small = QApplication::style()->pixelMetric(QStyle::PM_SmallIconSize);
            QCOMPARE(QApplication::style()->standardPixmap(standard).toImage(),
                     found.pixmap(QSize(small, small), 1.0).toImage());
            // Its lines have the palette's colour: they follow the theme.
            const QImage image = found.pixmap(QSize(48, 48), 1.0).toImage();
            bool inked = false;
            for (int y = 0; y < image.height() && !inked; ++y)
                for (int x = 0; x < image.width() && !inked; ++x)
                    inked = image.pixelColor(x, y) == QApplication::palette().color(QPalette::ButtonText);
            QVERIFY2(inked, qPrintable(QString::number(int(standard))));
        }
        for (const QString &name : iconNames()) // none is empty
            QVERIFY2(icon(name).pixmap(24).toImage() != QPixmap().toImage(), qPrintable(name));
    }

    /// Also of hints that were there before the theme changed.
    void hintsAreReadInBothThemes()
    {
        wear(settings::Theme::Light);
        QWidget panel;
        HintLabel hint(&panel);
        panel.show();
        hint.showHint("“abc” is not a number.");
        for (const settings::Theme theme : {settings::Theme::Dark, settings::Theme::Light}) {
            wear(theme);
            QTRY_COMPARE(hint.palette().color(hint.foregroundRole()), warningText());
            QVERIFY(contrast(warningText(), hint.palette().color(QPalette::Window)) >= 4.5);
        }
    }

    /// Each text on each ground that it stands on; what is disabled is meant to be paler.
    void textsAreReadInBothThemes()
    {
        using Role = QPalette::ColorRole;
        constexpr std::pair<Role, Role> pairs[] = {
            {Role::WindowText, Role::Window},     {Role::Text, Role::Base},
            {Role::Text, Role::AlternateBase},    {Role::ButtonText, Role::Button},
            {Role::HighlightedText, Role::Highlight}, {Role::ToolTipText, Role::ToolTipBase},
            {Role::PlaceholderText, Role::Base},  {Role::PlaceholderText, Role::AlternateBase},
            {Role::PlaceholderText, Role::Window}, {Role::Link, Role::Window},
            {Role::Link, Role::Base},             {Role::BrightText, Role::Window},
            {Role::BrightText, Role::Base}};
        for (const QPalette &palette : {lightPalette(), darkPalette()})
            for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive})
                for (const auto &[text, ground] : pairs) {
                    const double found = contrast(palette.color(group, text), palette.color(group, ground));
                    QVERIFY2(found >= 4.5, qPrintable(QString("%1 on %2: %3").arg(text).arg(ground).arg(found)));
                }
    }

    /// Of texts over the picture, whatever it is: they stand on plates. They are as large as the system's texts.
    void textsOverThePictureAreRead()
    {
        const QFont usual = QApplication::font();
        double height = 0;
        for (const double larger : {1.0, 1.5}) {
            QFont font = usual;
            font.setPointSizeF(larger * usual.pointSizeF());
            QApplication::setFont(font);
            QImage image(400, 100, QImage::Format_ARGB32_Premultiplied);
            image.fill(QColor(128, 128, 128));
            QPainter painter(&image);
            paintPlate(painter, "HHH", {200, 10}, 380, 1);
            painter.end();
            double most = 0;
            int rows = 0;
            for (int y = 0; y < image.height(); ++y) {
                bool inked = false;
                for (int x = 0; x < image.width(); ++x) {
                    const double found = contrast(image.pixelColor(x, y), QColor(20, 20, 24));
                    inked = inked || found > 10;
                    most = std::max(most, found);
                }
                rows += inked;
            }
            QVERIFY(most >= 4.5);
            QVERIFY(larger == 1 || std::abs(rows - larger * height) <= 2);
            height = rows;
        }
        QApplication::setFont(usual);
    }

    /// By the setting, or by what desktops keep in their files.
    void motionIsReducedOnDemand()
    {
        const auto glides = [](const QMainWindow &window) {
            applyMotion();
            return window.isAnimated() &&
                   QApplication::style()->styleHint(QStyle::SH_Widget_Animation_Duration) > 0 &&
                   QApplication::cursorFlashTime() > 0;
        };
        wear(settings::Theme::Light);
        qputenv("XDG_CONFIG_HOME", m_folder.filePath("config").toUtf8());
        QMainWindow window;
        QVERIFY(glides(window));
        settings::setMotion(settings::Motion::Reduced);
        QVERIFY(!glides(window));
        QVERIFY(!window.isAnimated() && QApplication::cursorFlashTime() == 0);
        settings::setMotion(settings::Motion::System);
        QVERIFY(glides(window));
        const auto says = [this](const char *file, const QByteArray &text) {
            const QFileInfo info(m_folder.filePath("config/") + file);
            QFile kept(info.filePath());
            return QDir().mkpath(info.path()) && kept.open(QIODevice::WriteOnly) && kept.write(text) == text.size();
        };
        QVERIFY(says("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations=0\n"));
        QVERIFY(!glides(window));
        settings::setMotion(settings::Motion::Full);
        QVERIFY(glides(window));
        settings::setMotion(settings::Motion::System);
        QVERIFY(says("kdeglobals", "[KDE]\nAnimationDurationFactor=1\n"));
        QVERIFY(glides(window));
        QVERIFY(says("kdeglobals", "[KDE]\nAnimationDurationFactor=0.0\n"));
        QVERIFY(!glides(window));
    }

    void coloursThatTheUserChoseAreSeen()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            wear(theme);
            for (const QPalette::ColorRole ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase})
                QVERIFY(contrast(edgeOfColours(), QApplication::palette().color(ground)) >= 3);
            QCOMPARE(paperFor(painted(0xFF202020)), previewPaper());
            QCOMPARE(paperFor(painted(0)), previewPaper());
            QVERIFY(contrast(paperFor(painted(0xFFFFFFFF)), Qt::white) >= 3);
        }
    }

    /// Also while it is empty.
    void checkBoxesInMenusAreSeen()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            wear(theme);
            QMenu menu;
            QAction *action = menu.addAction("m");
            action->setCheckable(true);
            menu.resize(menu.sizeHint());
            const QRect row = menu.actionGeometry(action);
            const QImage image = menu.grab(QRect(row.topLeft(), QSize(row.height(), row.height()))).toImage();
            const QColor ground = image.pixelColor(image.width() - 1, 1);
            double most = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    most = std::max(most, contrast(image.pixelColor(x, y), ground));
            QVERIFY2(most >= 3, qPrintable(QString::number(most)));
        }
    }

    /// Where dragged rows go is seen on any row, in both palettes.
    void thePlaceOfADropIsSeen()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            wear(theme);
            const QPalette palette = QApplication::palette();
            for (const auto ground : {QPalette::Base, QPalette::AlternateBase, QPalette::Highlight})
                for (const int height : {0, 24}) { // between two rows, and on one
                    QImage image(100, 40, QImage::Format_RGB32);
                    image.fill(palette.color(ground));
                    QPainter painter(&image);
                    QStyleOption option;
                    option.palette = palette;
                    option.rect = {0, 8, 100, height};
                    QApplication::style()->drawPrimitive(QStyle::PE_IndicatorItemViewItemDrop, &option, &painter,
                                                         nullptr);
                    painter.end();
                    double best = 0; // the contrast of what is drawn, across it
                    for (int y = 0; y < 20; ++y)
                        best = std::max(best, contrast(image.pixelColor(50, y), palette.color(ground)));
                    QVERIFY2(best > 3, qPrintable(QString::number(best)));
                }
        }
    }

    /// Whoever goes through a dialog by Tab sees where they are: the frame stands out from the window around it and
    /// from what it frames.
    void theFocusIsSeenInBothThemes()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            wear(theme);
            for (const QPalette::ColorRole ground : {QPalette::Window, QPalette::Base, QPalette::Button})
                QVERIFY(contrast(focusFrame(), QApplication::palette().color(ground)) >= 3);
            QDialog dialog;
            auto *column = new QVBoxLayout(&dialog);
            QLineEdit elsewhere;
            QPushButton button("Button"), usual("Usual");
            usual.setDefault(true);
            QComboBox combo;
            combo.addItem("List");
            QToolButton tool;
            tool.setText("Tool");
            tool.setMinimumWidth(120);
            QCheckBox box("          Box"); // the frame is around the text
            for (QWidget *widget : std::initializer_list<QWidget *>{&elsewhere, &button, &usual, &combo, &tool, &box}) {
                widget->setFocusPolicy(Qt::StrongFocus);
                column->addWidget(widget);
            }
            dialog.show();
            QVERIFY(QTest::qWaitForWindowActive(&dialog));
            dialog.setAttribute(Qt::WA_KeyboardFocusChange); // as after the first Tab
            for (QWidget *widget : std::initializer_list<QWidget *>{&button, &usual, &combo, &tool, &box}) {
                elsewhere.setFocus(Qt::TabFocusReason);
                QCoreApplication::processEvents();
                const QImage before = dialog.grab().toImage();
                widget->setFocus(Qt::TabFocusReason);
                QCoreApplication::processEvents();
                QVERIFY(widget->hasFocus());
                const QImage after = dialog.grab().toImage();
                // Along a line down through the widget the frame is crossed at the top.
                const double ratio = after.devicePixelRatio();
                const int x = int((widget->x() + 32) * ratio), top = int((widget->y() - 2) * ratio);
                const int bottom = int(widget->geometry().center().y() * ratio);
                bool isSeen = false;
                for (int y = top; y < bottom && !isSeen; ++y) {
                    const QColor frame = after.pixelColor(x, y);
                    isSeen = frame != before.pixelColor(x, y) && contrast(frame, before.pixelColor(x, y)) >= 3 &&
                             contrast(frame, after.pixelColor(x, top)) >= 3 &&
                             contrast(frame, after.pixelColor(x, y + int(3 * ratio))) >= 3;
                }
                QVERIFY2(isSeen, widget->metaObject()->className());
            }
        }
    }

    /// The same in lists, trees and tabs, whether or not the row is selected: the frame stands out from the row.
    void theFocusIsSeenInListsAndTabs()
    {
        for (const settings::Theme theme : {settings::Theme::Light, settings::Theme::Dark}) {
            wear(theme);
            QDialog dialog;
            auto *column = new QVBoxLayout(&dialog);
            QLineEdit elsewhere;
            QListWidget selected, bare;
            QTreeWidget tree;
            QTabBar tabs;
            tabs.setFocusPolicy(Qt::StrongFocus);
            for (const char *name : {"                    One", "                    Two"}) {
                selected.addItem(name);
                bare.addItem(name);
                new QTreeWidgetItem(&tree, {name});
                tabs.addTab(name);
            }
            bare.setSelectionMode(QAbstractItemView::NoSelection);
            tree.setRootIsDecorated(false);
            for (QWidget *widget : std::initializer_list<QWidget *>{&elsewhere, &selected, &bare, &tree, &tabs})
                column->addWidget(widget);
            selected.setCurrentRow(0);
            bare.setCurrentRow(0);
            tree.setCurrentItem(tree.topLevelItem(0));
            dialog.show();
            QVERIFY(QTest::qWaitForWindowActive(&dialog));
            dialog.setAttribute(Qt::WA_KeyboardFocusChange);
            const auto rowOf = [&](QWidget *widget) {
                if (widget == &tabs)
                    return tabs.tabRect(0).translated(tabs.pos());
                auto *view = qobject_cast<QAbstractItemView *>(widget);
                return view->visualRect(view->currentIndex()).translated(view->viewport()->mapTo(&dialog, QPoint()));
            };
            for (QWidget *widget : std::initializer_list<QWidget *>{&selected, &bare, &tree, &tabs}) {
                elsewhere.setFocus(Qt::TabFocusReason);
                QCoreApplication::processEvents();
                const QImage before = dialog.grab().toImage();
                widget->setFocus(Qt::TabFocusReason);
                QCoreApplication::processEvents();
                QVERIFY(widget->hasFocus());
                const QImage after = dialog.grab().toImage();
                const QRect row = rowOf(widget);
                const double ratio = after.devicePixelRatio();
                const int x = int((row.left() + 24) * ratio), bottom = int(row.center().y() * ratio);
                const QColor within = after.pixelColor(x, bottom);
                double best = 0;
                for (int y = int(row.top() * ratio); y < bottom; ++y)
                    if (const QColor frame = after.pixelColor(x, y); frame != before.pixelColor(x, y))
                        best =
                            std::max(best, std::min(contrast(frame, before.pixelColor(x, y)), contrast(frame, within)));
                QVERIFY2(best >= 3, qPrintable(QString("%1 %2").arg(widget->metaObject()->className()).arg(best)));
            }
        }
    }

    void groupsOfBrushesAreReadInBothThemes()
    {
        wear(settings::Theme::Light);
        Editor editor;
        BrushPanel panel(editor);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        for (const settings::Theme theme : {settings::Theme::Dark, settings::Theme::Light}) {
            wear(theme);
            QCoreApplication::processEvents();
            const QListWidgetItem *heading = panel.list()->item(0);
            QVERIFY(!(heading->flags() & Qt::ItemIsSelectable));
            const double found =
                contrast(heading->foreground().color(), QApplication::palette().color(QPalette::Window));
            QVERIFY2(found >= 4.5, qPrintable(QString::number(found)));
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTheme)
#include "test_theme.moc"
