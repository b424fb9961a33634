// What the wheel reaches: nothing is altered that was not meant.
#include "app/widgets/numbers/number_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/window/hands_on_widgets.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>

using namespace suffuse;

namespace {

/// What a hand can set in a widget, as a text.
QString valueOf(const QWidget *widget)
{
    if (const auto *box = qobject_cast<const QAbstractSpinBox *>(widget))
        return box->text();
    if (const auto *combo = qobject_cast<const QComboBox *>(widget))
        return QString::number(combo->currentIndex()) + combo->currentText();
    if (const auto *slider = qobject_cast<const QAbstractSlider *>(widget))
        return qobject_cast<const QScrollBar *>(widget) ? QString() : QString::number(slider->value());
    if (const auto *bar = qobject_cast<const QTabBar *>(widget))
        return QString::number(bar->currentIndex());
    if (const auto *field = qobject_cast<const QLineEdit *>(widget))
        return field->text();
    return {};
}

QStringList valuesIn(const QWidget &root)
{
    QStringList values;
    for (const QWidget *widget : root.findChildren<QWidget *>())
        values << valueOf(widget);
    return values;
}

/// As a hand does: what a widget does not take goes on to its parent. (Qt lets events that a program sends stay.)
void turnWheel(QWidget &widget, int delta)
{
    for (QWidget *w = &widget; w; w = w->isWindow() ? nullptr : w->parentWidget()) {
        const QPointF at = w->rect().center();
        QWheelEvent wheel(at, w->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(w, &wheel);
        if (wheel.isAccepted())
            break;
    }
}

/// The scroll bar that a wheel over the widget ought to move; none: null.
QScrollBar *barAround(const QWidget *widget)
{
    for (const QWidget *w = widget->parentWidget(); w && !w->isWindow(); w = w->parentWidget())
        if (const auto *area = qobject_cast<const QScrollArea *>(w))
            if (QScrollBar *bar = area->verticalScrollBar(); bar->maximum() > bar->minimum())
                return bar;
    return nullptr;
}

/// Without the canvas and its children.
QList<QWidget *> widgetsOf(QWidget &root, const QWidget &canvas)
{
    QList<QWidget *> widgets = root.findChildren<QWidget *>();
    widgets.removeIf([&](QWidget *w) { return w == &canvas || canvas.isAncestorOf(w); });
    return widgets;
}

/// Turns it over every widget that has no focus, back and forth; says what was altered, and counts what scrolled.
QStringList wheelOverAll(WaveSession &s, QWidget &root, int &scrolled)
{
    QStringList altered;
    for (QWidget *widget : widgetsOf(root, s.canvas())) {
        if (widget->hasFocus() || widget->parentWidget()->hasFocus() || widget->inherits("QMenuBar"))
            continue;
        if (widget->focusPolicy() == Qt::WheelFocus && widget->testAttribute(Qt::WA_WState_Polished))
            altered << QString("%1 gets the focus").arg(widget->accessibleName());
        for (const int delta : {-120, 240}) {
            const QStringList values = valuesIn(root);
            const PaintingPtr painting = s.editor().document().snapshot();
            const Brush brush = s.editor().brush();
            QScrollBar *bar = valueOf(widget).isEmpty() ? nullptr : barAround(widget);
            if (bar)
                bar->setValue((bar->minimum() + bar->maximum()) / 2);
            const int before = bar ? bar->value() : 0;
            turnWheel(*widget, delta);
            if (values != valuesIn(root) || painting != s.editor().document().snapshot() || brush != s.editor().brush())
                altered
                    << QString("%1 %2 %3").arg(widget->metaObject()->className(), widget->accessibleName()).arg(delta);
            if (bar && bar->value() == before && bar->maximum() > bar->minimum() + 1) {
                altered << QString("%1 %2 does not scroll")
                               .arg(widget->metaObject()->className(), widget->accessibleName());
            }
            scrolled += bar != nullptr;
        }
    }
    return altered;
}

} // namespace

class TestWheel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        keepSettingsIn(m_folder);
    }

    void init() { window_layout::reset(); }

    void noWindowsWidgetWithoutFocusTakesTheWheel()
    {
        WaveSession s;
        s.window.resize(1100, 560); // so that panels have something to scroll
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        for (auto *dock : s.window.findChildren<QDockWidget *>())
            dock->show();
        int scrolled = 0;
        for (const Command tool : tools) {
            s.use(tool);
            s.canvas().setFocus();
            QCoreApplication::processEvents();
            const QStringList altered = wheelOverAll(s, s.window, scrolled);
            QVERIFY2(altered.isEmpty(), qPrintable(altered.join('\n')));
            if (tool == Command::Select) // and the painting's own values
                s.editor().document().setSelection({});
        }
        QVERIFY2(scrolled > 40, qPrintable(QString::number(scrolled)));
    }

    void noDialogsWidgetWithoutFocusTakesTheWheel()
    {
        WaveSession s;
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->show();
            QCoreApplication::processEvents();
            for (auto *tabs : dialog->findChildren<QTabWidget *>())
                for (int page = tabs->count(); page-- > 0;)
                    tabs->setCurrentIndex(page); // polishes what is on it
            int scrolled = 0;
            const QStringList altered = wheelOverAll(s, *dialog, scrolled);
            QVERIFY2(altered.isEmpty(), qPrintable(QString(maker.name) + ": " + altered.join('\n')));
            dialog->reject();
        }
    }

    /// It is not the wheel that is forbidden.
    void whatHasTheFocusTakesTheWheel()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush(); // it shows what is selected
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField *field = fieldCalled(*inspector, "Red");
        QVERIFY(field);
        field->setFocus();
        const int before = s.steps();
        turnWheel(*field, -120);
        QCOMPARE(s.steps(), before + 1);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWheel)
#include "test_wheel.moc"
