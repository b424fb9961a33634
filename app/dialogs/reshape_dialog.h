#pragma once

#include "app/session/commands/reshaping.h"
#include "app/session/gesture.h"
#include "app/session/painting/picture_change.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;

namespace suffuse {

class NumberField;
struct Display;

/// Simplifies, smooths, straightens, widens or offsets what is selected, by numbers. What they do shows at once, with
/// the number of segments and how much another picture they make; Cancel takes it back.
class ReshapeDialog : public QDialog {
    Q_OBJECT

public:
    ReshapeDialog(Editor &editor, Reshaping what, QWidget *parent);
    ~ReshapeDialog() override;

    void choose(Reshaping what);
    Reshaping chosen() const;
    /// The fields of what is chosen, in order.
    std::vector<NumberField *> fields() const;
    /// What is said below the fields.
    QString report() const;

    void accept() override;
    void reject() override;

private:
    void addField(Reshaping of, double ReshapeAmounts::*amount, const QString &name, const QString &tip,
                  const Display &display, double least, double most);
    void showFields();
    void apply();
    void showReport();
    std::vector<StrokePtr> strokesNow();

    Editor &m_editor;
    PaintingPtr m_before;
    Selection m_selection; ///< of then
    ReshapeAmounts m_amounts;
    Gesture m_gesture;
    PictureChange m_difference;
    std::size_t m_countBefore;
    QTimer m_settled; ///< the report follows when the numbers have come to rest

    struct Row {
        Reshaping of;
        QLabel *label;
        NumberField *field;
    };
    std::vector<Row> m_rows;
    QFormLayout *m_form = nullptr;
    QComboBox *m_choice = nullptr;
    QLabel *m_report = nullptr;
};

} // namespace suffuse
