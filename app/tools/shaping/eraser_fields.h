// The fields of the eraser: what it does, how much of it, and to which strokes.
#pragma once

#include "app/session/selecting/eraser_scope.h"
#include "model/shaping/erasing/soft_eraser.h"

#include <QObject>

#include <functional>

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace suffuse {

class NumberField;

enum class EraserMode {
    Fade, ///< makes paint paler, softly, wherever it is seen
    Lift, ///< takes its density away: edges draw in
    Cut   ///< cuts curves out, with hard edges
};

/// What the eraser does; the size is the tool's own.
struct EraserChoice {
    EraserMode mode = EraserMode::Fade;
    EraserMode soft = EraserMode::Fade; ///< the one that is not Cut which was chosen last
    EraserScope scope = EraserScope::Selected;
    double strength = 1;
    double softness = SoftTip{}.softness;

    /// What was chosen last, from the settings. A value out of range counts as unset.
    static EraserChoice stored();
    void store() const;
    /// The mode that a held key changes to: between the soft one and Cut.
    EraserMode other() const { return mode == EraserMode::Cut ? soft : EraserMode::Cut; }
    void setMode(EraserMode wanted)
    {
        mode = wanted;
        if (wanted != EraserMode::Cut)
            soft = wanted;
    }
    friend bool operator==(const EraserChoice &, const EraserChoice &) = default;
};

/// The fields in the row over the canvas. They belong to the row that they are added to.
class EraserFields : public QObject {
    Q_OBJECT

public:
    /// `addSize` adds the tool's size behind the mode.
    EraserFields(QHBoxLayout &row, const std::function<void()> &addSize);

    /// Shows a choice, and emits nothing.
    void show(const EraserChoice &choice);
    /// Says what the scope of the selected strokes means now: all, where none is selected.
    void setAnySelected(bool selected);
    /// What the row says of the way in which paint is lifted; seen in that mode alone.
    QLabel *liftNote() const { return m_lifts; }

signals:
    /// Emitted when somebody has changed it by hand.
    void chosen(const suffuse::EraserChoice &choice);

private:
    QComboBox *addChoices(QHBoxLayout &row, const QStringList &names, const QString &toolTip,
                          const std::function<void(int)> &take);
    void change(const std::function<void(EraserChoice &)> &change);
    void showScopes();

    EraserChoice m_choice;
    bool m_anySelected = false;
    QComboBox *m_modes = nullptr;
    QComboBox *m_scopes = nullptr;
    NumberField *m_strength = nullptr;
    NumberField *m_softness = nullptr;
    QLabel *m_lifts = nullptr; ///< what lifting does to sharp edges
};

} // namespace suffuse
