// A hand in the window "Along the Stroke" that changes, saves, undoes and redoes at random, the same for the same seed,
// and knows what must be seen.
#pragma once

#include "app/panels/inspector/along/along_dialog.h"
#include "app/widgets/numbers/number_field.h"
#include "model/formats/files.h"
#include "tests/app/panel_bench.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QSignalSpy>

#include <random>

namespace suffuse {

/// Drags in the curve editor from one place and value to another, in ten reports.
inline void dragCurve(CurveEditor &curve, QPointF from, QPointF to, bool release = true)
{
    QTest::mousePress(&curve, Qt::LeftButton, {}, curve.toWidget(from).toPoint());
    for (int i = 1; i <= 10; ++i)
        QTest::mouseMove(&curve, curve.toWidget(from + (i / 10.0) * (to - from)).toPoint());
    if (release)
        QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget(to).toPoint());
}

class AlongWalk {
public:
    AlongWalk(unsigned seed, const QString &file) : m_random(seed), m_file(file)
    {
        m_bench.select({1});
        m_seen.push_back(shown());
        if (oneIn(2)) { // There is something before the window that undo can go back to.
            m_bench.editor.push(changeStrokes(m_bench.editor.document(), {1},
                                              [value = 3.1f](Stroke &s) mutable {
                                                  for (Segment &segment : s.segments)
                                                      segment.density = value *= 1.7f;
                                              }),
                                "density");
            m_seen.push_back(shown());
        }
        m_opened = m_now = m_seen.size() - 1;
        m_dialog = new AlongDialog(m_bench.editor, nullptr);
        m_dialog->show();
        m_seen.back() = shown();
    }
    ~AlongWalk() { delete m_dialog; }

    /// One of the things that a hand does. Returns what is wrong then; empty: nothing.
    QString act()
    {
        static constexpr std::pair<const char *, QString (AlongWalk::*)()> deeds[] = {
            {"number", &AlongWalk::enter},     {"drag", &AlongWalk::drag},
            {"look", &AlongWalk::look},        {"save", &AlongWalk::save},
            {"undo", &AlongWalk::undo},        {"redo", &AlongWalk::redo},
            {"drag, Esc", &AlongWalk::giveUp}, {"drag, save, Esc", &AlongWalk::saveAndGiveUp},
        };
        const auto &[name, deed] = deeds[std::size_t(upTo(7))];
        m_trail << name;
        return (this->*deed)();
    }
    /// OK or Cancel, and then undo to the beginning and redo to the end.
    QString close(bool cancels)
    {
        m_trail << (cancels ? "Cancel" : "OK");
        if (cancels)
            m_dialog->reject();
        else
            m_dialog->accept();
        // The window takes back what was done in it, not that something before it was undone.
        const PaintingPtr end = m_seen[cancels ? std::min(m_opened, m_now) : m_now].painting;
        if (now() != *end)
            return "it ends in another painting";
        std::vector<PaintingPtr> way{m_bench.editor.document().painting()};
        while (m_bench.editor.canUndo()) {
            m_bench.editor.undo();
            way.push_back(m_bench.editor.document().painting());
        }
        if (now() != *m_seen.front().painting)
            return "undo ends in another painting";
        // On the way there are states that were seen, in their order.
        std::size_t k = cancels ? m_now + 1 : m_now;
        for (std::size_t i = 1; i < way.size(); ++i) {
            while (k > 0 && *m_seen[k - 1].painting != *way[i])
                --k;
            if (k-- == 0)
                return QString("undo shows what was not seen before, after %1").arg(i);
        }
        for (std::size_t i = way.size() - 1; i-- > 0;) {
            m_bench.editor.redo();
            if (now() != *way[i])
                return "redo does not come back by the same way";
        }
        return {};
    }
    QString trail() const { return m_trail.join(", "); }

private:
    struct Shown {
        PaintingPtr painting;
        QString quantity; ///< of which this is the curve
        PlaceCurve curve;
    };

    bool oneIn(int n) { return upTo(n - 1) == 0; }
    int upTo(int last) { return std::uniform_int_distribution(0, last)(m_random); }
    double share() { return std::uniform_real_distribution(0.1, 0.9)(m_random); }
    const Painting &now() { return *m_bench.editor.document().painting(); }
    Shown shown()
    {
        const PaintingPtr painting = m_bench.editor.document().painting();
        if (!m_dialog)
            return {painting, {}, {}};
        return {painting, m_dialog->findChild<QComboBox *>()->currentText(), m_dialog->curve()->curve()};
    }
    CurveEditor &curve() { return *m_dialog->curve(); }
    QPoint point(double place, double value) { return curve().toWidget({place, value}).toPoint(); }

    /// What is seen now was done to what was seen before; what had been undone is gone.
    QString changed()
    {
        if (now() == *m_seen[m_now].painting)
            return "nothing is changed";
        m_opened = std::min(m_opened, m_now);
        m_seen.resize(++m_now);
        m_seen.push_back(shown());
        return {};
    }
    QString unchanged()
    {
        const Shown &was = m_seen[m_now];
        if (now() != *was.painting)
            return "another painting is seen";
        const Shown is = shown();
        if (is.quantity == was.quantity && is.curve != was.curve)
            return "another curve is seen";
        return {};
    }
    QString enter()
    {
        NumberField &field = oneIn(3) ? *m_dialog->scale() : *m_dialog->start();
        const bool isDensity = m_dialog->findChild<QComboBox *>()->currentIndex() == 1;
        const double value = isDensity ? 2 + 20 * share() : 1 + 60 * share();
        type(field, QString::number(&field == m_dialog->scale() ? 0.5 + 0.3 * share() : value, 'f', 3));
        return changed();
    }
    void pressAndMove()
    {
        m_place = upTo(8) / 8.0; // Points lie so far apart that each changes a segment.
        m_value = curve().curve().at(m_place);
        QTest::mousePress(&curve(), Qt::LeftButton, {}, point(m_place, m_value));
        move();
    }
    /// To where it changes something.
    void move()
    {
        for (int k = 0; k < 2; ++k) {
            const double to = share();
            QTest::mouseMove(&curve(), point(m_place, std::abs(to - m_value) > 0.05 ? to : to > 0.5 ? 0.2 : 0.8));
        }
    }
    void release() { QTest::mouseRelease(&curve(), Qt::LeftButton, {}, point(m_place, share())); }
    QString drag()
    {
        pressAndMove();
        release();
        return changed();
    }
    QString look()
    {
        m_dialog->choose(oneIn(2) ? Quantity::Density : Quantity::Diffusion);
        return unchanged();
    }
    QString giveUp()
    {
        const Shown before = shown();
        pressAndMove();
        QTest::keyClick(&curve(), Qt::Key_Escape);
        release();
        if (shown().curve != before.curve)
            return "another curve is seen";
        return unchanged();
    }
    QString saveAndGiveUp()
    {
        pressAndMove();
        QString wrong = changed();
        if (wrong.isEmpty())
            wrong = save();
        const Shown saved = shown();
        if (!oneIn(4))
            move();
        QTest::keyClick(&curve(), Qt::Key_Escape);
        release();
        if (wrong.isEmpty() && m_bench.editor.isModified())
            wrong = "it is not as it was saved";
        if (wrong.isEmpty() && shown().curve != saved.curve)
            wrong = "another curve is seen";
        return wrong.isEmpty() ? unchanged() : wrong;
    }
    QString save()
    {
        QSignalSpy saved(&m_bench.editor, &Editor::saved);
        m_bench.editor.startSaving(m_file, true);
        if ((saved.isEmpty() && !saved.wait()) || m_bench.editor.isModified())
            return "it is not saved";
        if (*loadPainting(m_file) != now())
            return "the file has another painting";
        return unchanged();
    }
    QString undo()
    {
        if (m_bench.editor.canUndo() != (m_now > 0))
            return "whether it can be undone";
        m_bench.editor.undo();
        m_now -= m_now > 0;
        return unchanged();
    }
    QString redo()
    {
        if (m_bench.editor.canRedo() != (m_now + 1 < m_seen.size()))
            return "whether it can be redone";
        m_bench.editor.redo();
        m_now += m_now + 1 < m_seen.size();
        return unchanged();
    }

    Bench m_bench{1};
    std::mt19937 m_random;
    double m_place = 0, m_value = 0; ///< where the curve is dragged
    QString m_file;
    QPointer<AlongDialog> m_dialog;
    std::vector<Shown> m_seen; ///< all that undo and redo go through
    std::size_t m_now = 0;     ///< which of them is seen
    std::size_t m_opened = 0;  ///< which of them Cancel comes back to
    QStringList m_trail;
};

} // namespace suffuse
