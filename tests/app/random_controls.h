// Uses fields, sliders, lists, buttons, menus and dialogs at random, as somebody without sense does.
#pragma once

#include "app/widgets/numbers/number_field.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <functional>
#include <random>

namespace suffuse {

class RandomControls {
public:
    /// `mayRun` says which entries of menus are chosen.
    RandomControls(std::mt19937 &random, std::function<bool(const QAction &)> mayRun)
        : m_random(random), m_mayRun(std::move(mayRun))
    {
        // Whatever waits for an answer gets one. A timer that is at work does not fire again, and what answers may wait
        // for another answer: each has a timer of its own.
        m_answers.setInterval(10);
        QObject::connect(&m_answers, &QTimer::timeout, [this] {
            if (QApplication::activePopupWidget() || QApplication::activeModalWidget())
                QTimer::singleShot(0, &m_answers, [this] { answer(); });
        });
        m_answers.start();
    }

    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }
    bool oneIn(int n) { return below(n) == 0; }

    /// One of those that are in reach within a window or a part of it; null where there is none.
    template <typename T>
    T *any(const QWidget &within, const std::function<bool(const T &)> &wanted = {})
    {
        QList<T *> found;
        for (T *widget : within.findChildren<T *>())
            if (widget->isEnabled() && widget->isVisible() && (!wanted || wanted(*widget)))
                found << widget;
        return found.isEmpty() ? nullptr : found[below(int(found.size()))];
    }

    /// These do something to one of its kind and say to which; nothing where none is in reach.
    QString field(const QWidget &within)
    {
        auto *line = any<NumberField>(within);
        if (!line)
            return {};
        static const char *const texts[] = {"5",   "0.3", "12*1.5", "*1.2", "+2", "-=3",
                                            "100", "1e9", "x",      "0",    "45", "/3"};
        line->setFocus();
        line->setText(QString::fromLatin1(texts[below(int(std::size(texts)))]));
        const QString said = line->accessibleName() + ' ' + line->text();
        QTest::keyClick(line, oneIn(4) ? Qt::Key_Up : Qt::Key_Return);
        return said;
    }
    QString slider(const QWidget &within, const std::function<void()> &meanwhile = {})
    {
        auto *slider = any<QSlider>(within);
        if (!slider)
            return {};
        const QString said = slider->accessibleName();
        const auto place = [&] { return QPoint(below(std::max(1, slider->width())), slider->height() / 2); };
        QTest::mousePress(slider, Qt::LeftButton, {}, place());
        for (int i = below(4); i > 0; --i)
            QTest::mouseMove(slider, place());
        if (meanwhile && oneIn(6))
            meanwhile();
        QTest::mouseRelease(slider, Qt::LeftButton, {}, place());
        return said;
    }
    /// None of the title bars' and none that asks.
    QString button(const QWidget &within)
    {
        auto *button = any<QAbstractButton>(within, [](const QAbstractButton &b) {
            const auto *tool = qobject_cast<const QToolButton *>(&b);
            return !b.text().endsWith(QStringLiteral("…")) && !b.objectName().startsWith("qt_") &&
                   !(tool && (tool->menu() || tool->defaultAction())) &&
                   !qobject_cast<const QDialogButtonBox *>(b.parentWidget());
        });
        if (!button)
            return {};
        const QString said = button->accessibleName() + ' ' + button->text() + ' ' + button->toolTip();
        button->click();
        return said;
    }
    QString choice(const QWidget &within)
    {
        auto *combo = any<QComboBox>(within);
        if (!combo)
            return {};
        const QString said = combo->accessibleName();
        QTest::keyClick(combo, oneIn(2) ? Qt::Key_Down : Qt::Key_Up);
        return said;
    }
    /// One of these.
    QString control(const QWidget &within)
    {
        switch (below(4)) {
        case 0:
            return field(within);
        case 1:
            return slider(within);
        case 2:
            return button(within);
        default:
            return choice(within);
        }
    }

    /// Clicks or drags anywhere in a dock where there is no field: on a wheel, a picture, a list, a line of time.
    QString poke(const QWidget &window)
    {
        auto *dock = any<QDockWidget>(window, [](const QDockWidget &d) { return !d.visibleRegion().isEmpty(); });
        if (!dock)
            return {};
        QWidget *part = dock->widget()->childAt(below(dock->widget()->width()), below(dock->widget()->height()));
        auto *area = part ? qobject_cast<QAbstractScrollArea *>(part->parentWidget()) : nullptr;
        if (area && area->viewport() == part)
            part = area;
        if (!part || !part->isEnabled() || qobject_cast<QAbstractButton *>(part) || qobject_cast<QLineEdit *>(part) ||
            qobject_cast<QAbstractSlider *>(part) || qobject_cast<QComboBox *>(part))
            return {};
        const QString said = QString::fromLatin1(part->metaObject()->className()).remove("suffuse::");
        // Dragging and dropping would wait for a mouse that there is not.
        const bool drags = !qobject_cast<QAbstractItemView *>(part) && !part->inherits("suffuse::SwatchGrid") &&
                           !part->inherits("suffuse::ColourSwatch");
        QPointer<QWidget> target = area == part ? area->viewport() : part;
        const auto place = [&] { return QPoint(below(target->width()), below(target->height())); };
        const Qt::MouseButton with = oneIn(8) ? Qt::RightButton : Qt::LeftButton;
        const auto modifiers = Qt::KeyboardModifiers(oneIn(4)   ? Qt::ShiftModifier
                                                     : oneIn(4) ? Qt::ControlModifier
                                                                : Qt::NoModifier);
        const QPoint first = place();
        if (oneIn(5)) {
            QTest::mouseDClick(target, with, modifiers, first);
            return said + " double click";
        }
        QTest::mousePress(target, with, modifiers, first);
        for (int i = drags ? below(5) : 0; i > 0 && target; --i)
            QTest::mouseMove(target, place());
        if (target)
            QTest::mouseRelease(target, with, modifiers, drags && oneIn(2) ? place() : first);
        return said;
    }

    /// Chooses an entry that can be used of a menu or of its menus; without any it does nothing.
    QString choose(const QMenu &menu)
    {
        QList<QAction *> entries;
        for (QAction *entry : menu.actions())
            if (entry->isEnabled() && entry->isVisible() && !entry->isSeparator() &&
                (entry->menu() || (!entry->text().endsWith(QStringLiteral("…")) && m_mayRun(*entry))))
                entries << entry;
        if (entries.isEmpty())
            return {};
        QAction *entry = entries[below(int(entries.size()))];
        if (entry->menu())
            return choose(*entry->menu());
        const QString said = entry->text();
        entry->trigger();
        return said;
    }

private:
    void answer()
    {
        if (QWidget *popup = QApplication::activePopupWidget()) {
            const QPointer<QMenu> menu = qobject_cast<QMenu *>(popup);
            popup->close();
            if (menu && oneIn(2))
                choose(*menu);
        } else if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
            const bool hasTime = dialog->inherits("suffuse::ReshapeDialog") ||
                                 dialog->inherits("suffuse::VaryDialog") || dialog->inherits("suffuse::RecolourDialog");
            hasTime && !oneIn(3) ? void(control(*dialog)) : end(*dialog);
        }
    }
    /// By a button, as people can, where it has any.
    void end(QDialog &dialog)
    {
        auto *button = any<QAbstractButton>(dialog, [](const QAbstractButton &b) {
            return qobject_cast<const QDialogButtonBox *>(b.parentWidget()) && !b.text().endsWith(QStringLiteral("…"));
        });
        if (button && oneIn(2))
            button->click();
        else
            dialog.reject();
    }

    std::mt19937 &m_random;
    std::function<bool(const QAction &)> m_mayRun;
    QTimer m_answers;
};

} // namespace suffuse
