#pragma once

#include "app/dialogs/manual/manual_pages.h"

#include <QTextBrowser>

namespace suffuse {

/// Shows a page of the manual in the system's font and the palette's tones. Lines are no longer than one reads well.
class PageView : public QTextBrowser {
    Q_OBJECT

public:
    explicit PageView(QWidget *parent = nullptr);

    /// Shows a page from its top. What `words` name is marked, and the page begins with the first such place.
    void showPage(const ManualPage &page, const QStringList &words = {});
    /// Sets the page that is shown anew, in another font or palette, and stays where it is.
    void setAnew();
    /// Zooms by so many steps of a tenth; 0: back to the system's size.
    void zoomBy(int steps);

signals:
    /// A link to another page was followed.
    void pageWanted(const QString &name);

protected:
    QVariant loadResource(int type, const QUrl &name) override;
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void setPage();
    void mark(const QStringList &words);
    void follow(const QUrl &link);
    QFont pageFont() const;
    int pictureRoom() const;

    ManualPage m_page;
    QTextDocument *m_document = nullptr; ///< of the page
    int m_zoom = 0;      ///< steps
    int m_pictures = -1; ///< the room that pictures had when the page was set
};

} // namespace suffuse
