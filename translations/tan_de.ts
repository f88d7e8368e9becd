<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Datensatz oder Modell öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>&amp;Bild speichern …</translation>
    </message>
    <message>
        <source>Save the view as a PNG picture</source>
        <translation>Speichert die Ansicht als PNG-Bild</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>Quit TAn</source>
        <translation>Beendet TAn</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig:</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen:</translation>
    </message>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Add an isosurface at another value</source>
        <translation>Fügt eine Isofläche bei einem weiteren Wert hinzu</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>&amp;Ecke</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Blick von dieser Seite</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Look From</source>
        <translation>&amp;Blick von</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Perspective, or parallel projection</source>
        <translation>Perspektive oder Parallelprojektion</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>&amp;Felder</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>&amp;Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default layout</source>
        <translation>Stellt die ursprüngliche Anordnung wieder her</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Nutzt den ganzen Bildschirm</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Plugins…</source>
        <translation>&amp;Plugins …</translation>
    </message>
    <message>
        <source>Installed plugins</source>
        <translation>Installierte Plugins</translation>
    </message>
    <message>
        <source>&amp;About TAn</source>
        <translation>Ü&amp;ber TAn</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>Save &amp;Mesh…</source>
        <translation>&amp;Netz speichern …</translation>
    </message>
    <message>
        <source>Save the displayed mesh for VTK, ParaView and other programs</source>
        <translation>Speichert das gezeigte Netz, für VTK, ParaView und andere</translation>
    </message>
    <message>
        <source>Save the displayed isosurfaces for 3D printing, Blender, ParaView and other programs</source>
        <translation>Speichert die gezeigten Isoflächen, für 3D-Drucker, Blender, ParaView und andere</translation>
    </message>
    <message>
        <source>Save the mesh size at each accuracy as a table</source>
        <translation>Speichert die Netzgröße jeder Genauigkeit als Tabelle</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>Be&amp;reich</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>&amp;Save Session</source>
        <translation>&amp;Sitzung speichern</translation>
    </message>
    <message>
        <source>Save the open model and its view, to continue later</source>
        <translation>Speichert, was offen ist, mit seiner Ansicht, um später weiterzuarbeiten</translation>
    </message>
    <message>
        <source>Save Session &amp;As…</source>
        <translation>Sitzung speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Die Sitzung in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>Import with Op&amp;tions…</source>
        <translation>Mit &amp;Optionen importieren …</translation>
    </message>
    <message>
        <source>Open a part of a dataset, or choose how its file is read</source>
        <translation>Öffnet einen Teil eines Datensatzes oder legt fest, wie seine Datei gelesen wird</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>Ha&amp;ndbuch</translation>
    </message>
    <message>
        <source>Open the manual in the browser</source>
        <translation>Öffnet das Handbuch im Webbrowser</translation>
    </message>
    <message>
        <source>Save S&amp;urfaces…</source>
        <translation>F&amp;lächen speichern …</translation>
    </message>
    <message>
        <source>Save Stat&amp;istics…</source>
        <translation>S&amp;tatistik speichern …</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>Be&amp;fehl suchen …</translation>
    </message>
    <message>
        <source>Search all commands</source>
        <translation>Durchsucht alle Befehle</translation>
    </message>
    <message>
        <source>Reduced &amp;Motion</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>Disable camera animation</source>
        <translation>Schaltet Kamerafahrten zwischen Ansichten aus</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help on This Control</source>
        <translation>&amp;Hilfe zu diesem Bedienelement</translation>
    </message>
    <message>
        <source>Explain the control that has the focus</source>
        <translation>Erklärt das Bedienelement, das den Fokus hat</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Click a control to read what it does</source>
        <translation>Auf ein Bedienelement klicken, um zu lesen, was es tut</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Es gibt nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>Save &amp;Film…</source>
        <translation>Fil&amp;m speichern …</translation>
    </message>
    <message>
        <source>Save the animation as pictures or a video</source>
        <translation>Die Animation als Bilder oder als Video speichern</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the view to the clipboard</source>
        <translation>Kopiert die Ansicht in die Zwischenablage</translation>
    </message>
    <message>
        <source>&amp;Annotations</source>
        <translation>Beschr&amp;iftung</translation>
    </message>
    <message>
        <source>Picked &amp;Value</source>
        <translation>&amp;Gewählter Wert</translation>
    </message>
    <message>
        <source>Close the model and its dataset</source>
        <translation>Schließt das Modell und seinen Datensatz</translation>
    </message>
    <message>
        <source>Reset &amp;View</source>
        <translation>A&amp;nsicht zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the default accuracy, colours, isovalues and camera</source>
        <translation>Stellt die anfängliche Genauigkeit, Farben, Isowerte und Kamera wieder her</translation>
    </message>
    <message>
        <source>There is nothing to close</source>
        <translation>Es ist nichts zu schließen</translation>
    </message>
    <message>
        <source>Open Samp&amp;le</source>
        <translation>Beis&amp;piel öffnen</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>Aus&amp;richtung</translation>
    </message>
    <message>
        <source>Ope&amp;n URL…</source>
        <translation>U&amp;RL öffnen …</translation>
    </message>
    <message>
        <source>Open a model on a server</source>
        <translation>Ein Modell öffnen, das auf einem Server liegt</translation>
    </message>
    <message>
        <source>Model Cac&amp;he…</source>
        <translation>Modell-Z&amp;wischenspeicher …</translation>
    </message>
    <message>
        <source>Manage the cache of downloaded and unpacked models</source>
        <translation>Wohin Modelle kommen, die entpackt oder geholt werden</translation>
    </message>
    <message>
        <source>Save Pac&amp;ked Model…</source>
        <translation>Gepac&amp;ktes Modell speichern …</translation>
    </message>
    <message>
        <source>Save the model at a fraction of its size, for archiving or for a server</source>
        <translation>Das Modell in einem kleinen Teil der Größe speichern, für Archive und Server</translation>
    </message>
    <message>
        <source>Open a whole model first</source>
        <translation>Öffnen Sie zuerst ein ganzes Modell</translation>
    </message>
    <message>
        <source>Appl&amp;y Look From…</source>
        <translation>&amp;Aussehen übernehmen von …</translation>
    </message>
    <message>
        <source>Apply the colours, isovalues, camera and settings of another session or picture to the open model</source>
        <translation>Zeigt das offene Modell so, wie eine andere Sitzung oder ein Bild das eigene zeigt: mit deren Farben, Isowerten, Kamera und Einstellungen</translation>
    </message>
    <message>
        <source>Frame what is shown, or the focus; press again for the whole domain</source>
        <translation>Passt ein, was gezeigt wird, oder den Fokus; noch einmal: das ganze Gebiet</translation>
    </message>
    <message>
        <source>Fit &amp;Whole Domain</source>
        <translation>&amp;Ganzes Gebiet einpassen</translation>
    </message>
    <message>
        <source>Frame the whole domain</source>
        <translation>Passt das ganze Gebiet ein</translation>
    </message>
    <message>
        <source>Save the displayed isosurfaces as closed surfaces of solids, for 3D printing</source>
        <translation>Die gezeigten Isoflächen als geschlossene Flächen von Körpern speichern, für 3D-Drucker</translation>
    </message>
    <message>
        <source>Save Soli&amp;ds…</source>
        <translation>Körper speic&amp;hern …</translation>
    </message>
    <message>
        <source>Tool Bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Bookmarks</source>
        <translation>&amp;Lesezeichen</translation>
    </message>
</context>
<context>
    <name>Annotations</name>
    <message>
        <source>Colour &amp;bar</source>
        <translation>Far&amp;bskala</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;chsen</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>Maß&amp;stab</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>A&amp;ccuracy</source>
        <translation>Gena&amp;uigkeit</translation>
    </message>
    <message>
        <source>Values and their colours, in data units; on the right their opacity, with marks at the isovalues</source>
        <translation>Werte und ihre Farben, in den Einheiten der Daten; rechts ihre Deckkraft, mit Marken an den Isowerten</translation>
    </message>
    <message>
        <source>The directions of x, y and z</source>
        <translation>Die Richtungen von x, y und z</translation>
    </message>
    <message>
        <source>A length in data units; in perspective it applies at the distance of the target</source>
        <translation>Eine Länge in den Einheiten der Daten; in der Perspektive die von Dingen in der Entfernung des Blickziels</translation>
    </message>
    <message>
        <source>The error bound of the displayed mesh, in % of the value range</source>
        <translation>Der Fehler, den das Gezeigte einhält, in % des Wertebereichs</translation>
    </message>
    <message>
        <source>The name of the model, or a text of your own</source>
        <translation>Der Name des Modells oder ein eigener Text</translation>
    </message>
    <message>
        <source>Axes with &amp;numbers</source>
        <translation>Achsen mit &amp;Zahlen</translation>
    </message>
    <message>
        <source>Coordinates along the edges of the box around the data, in data units</source>
        <translation>Koordinaten an den Kanten des Quaders um die Daten, in Einheiten der Daten</translation>
    </message>
</context>
<context>
    <name>Bookmarks</name>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Add Bookmark</source>
        <translation>Lesezeichen hinzufügen</translation>
    </message>
    <message>
        <source>Show Bookmark</source>
        <translation>Lesezeichen zeigen</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>%1 Up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>%1 Down</source>
        <translation>%1 nach unten</translation>
    </message>
</context>
<context>
    <name>ChangeView</name>
    <message>
        <source>Add Isovalue</source>
        <translation>Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Change Animation</source>
        <translation>Animation ändern</translation>
    </message>
    <message>
        <source>Change Annotations</source>
        <translation>Beschriftung ändern</translation>
    </message>
    <message>
        <source>Change Isovalue</source>
        <translation>Isowert ändern</translation>
    </message>
    <message>
        <source>Change Rendering Mode</source>
        <translation>Darstellungsart ändern</translation>
    </message>
    <message>
        <source>Change Transfer Function</source>
        <translation>Transferfunktion ändern</translation>
    </message>
    <message>
        <source>Change Rendering</source>
        <translation>Darstellung ändern</translation>
    </message>
    <message>
        <source>Change Focus</source>
        <translation>Fokus ändern</translation>
    </message>
    <message>
        <source>Change Crop Box</source>
        <translation>Fenster ändern</translation>
    </message>
    <message>
        <source>Change Values</source>
        <translation>Werte ändern</translation>
    </message>
    <message>
        <source>Change Budget</source>
        <translation>Budget ändern</translation>
    </message>
    <message>
        <source>Change Accuracy</source>
        <translation>Genauigkeit ändern</translation>
    </message>
    <message>
        <source>Change Background</source>
        <translation>Hintergrund ändern</translation>
    </message>
    <message>
        <source>Move Camera</source>
        <translation>Kamera bewegen</translation>
    </message>
    <message>
        <source>Remove Isovalue</source>
        <translation>Isowert entfernen</translation>
    </message>
    <message>
        <source>Change Range</source>
        <translation>Bereich ändern</translation>
    </message>
    <message>
        <source>Change Warping</source>
        <translation>Verwerfung ändern</translation>
    </message>
    <message>
        <source>Change Lens</source>
        <translation>Lupe ändern</translation>
    </message>
    <message>
        <source>Change Tool</source>
        <translation>Werkzeug ändern</translation>
    </message>
    <message>
        <source>Change Bookmarks</source>
        <translation>Lesezeichen ändern</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>There is no display for the window: neither DISPLAY nor WAYLAND_DISPLAY is set. “tan render” draws pictures into files instead; “tan --help” lists what else works without a window.</source>
        <translation>Es gibt keinen Bildschirm für das Fenster: Weder DISPLAY noch WAYLAND_DISPLAY ist gesetzt. „tan render“ zeichnet Bilder stattdessen in Dateien; „tan --help“ sagt, was sonst ohne Fenster geht.</translation>
    </message>
    <message>
        <source>Shows volume data at any accuracy.</source>
        <translation>Zeigt Volumendaten in jeder Genauigkeit.</translation>
    </message>
    <message>
        <source>Rendering back end: auto, cpu or gl.</source>
        <translation>Was das Bild zeichnet: auto, cpu oder gl.</translation>
    </message>
    <message>
        <source>A dataset, a .tan model or a session to open; each opens in its own window.</source>
        <translation>Datensätze, .tan-Modelle oder Sitzungen, die geöffnet werden; jede Datei in einem eigenen Fenster.</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isowerte</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>How far the mesh may deviate from the data, in percent of the value range; or how many tetrahedra it may have. The curve shows what each error costs.</source>
        <translation>Wie weit das Netz von den Daten abweichen darf, in Prozent des Wertebereichs, oder wie viele Tetraeder es haben darf. Die Kurve zeigt, was jeder Fehler kostet.</translation>
    </message>
    <message>
        <source>Rendering mode and its settings: surfaces, volume or both.</source>
        <translation>Darstellungsart und ihre Einstellungen: Flächen, Volumen oder beides.</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>What each accuracy costs in vertices, tetrahedra, time and memory, and the figures of the displayed mesh.</source>
        <translation>Was jede Genauigkeit an Knoten, Tetraedern, Zeit und Speicher kostet, und das gezeigte Netz in Zahlen.</translation>
    </message>
    <message>
        <source>Surfaces on which the field has a given value, in data units.</source>
        <translation>Flächen, auf denen das Feld je einen Wert hat, in den Einheiten der Daten.</translation>
    </message>
    <message>
        <source>A sphere or a box in which the mesh is more accurate than outside.</source>
        <translation>Eine Kugel oder ein Quader, in dem das Netz genauer ist als außerhalb.</translation>
    </message>
    <message>
        <source>Which part of the domain is shown: a crop box, and a range of values.</source>
        <translation>Welcher Teil des Gebiets überhaupt gezeigt wird: ein Quader und ein Bereich von Werten.</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Films of the model: a turntable, or a path through key frames of your choice.</source>
        <translation>Filme vom Modell: eine Runde um es herum oder ein Weg durch Schlüsselbilder, die Sie wählen.</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Transfer</translation>
    </message>
    <message>
        <source>Build a model from a dataset once; a mesh is then available at any accuracy. Choose a builder and a file, and press Build.</source>
        <translation>Ein Modell wird einmal aus einem Datensatz gebaut; danach gibt es sein Netz in jeder Genauigkeit. Wählen Sie ein Verfahren und eine Datei und drücken Sie „Bauen“.</translation>
    </message>
    <message>
        <source>The camera settings as numbers. In the picture: drag to turn, Shift+drag to move, use the wheel to zoom.</source>
        <translation>Die Kamera in Zahlen. Im Bild: Ziehen dreht, Ziehen mit Umschalt verschiebt, das Rad zoomt.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>What the chosen tool can do and what it measures. In the picture: click a place, drag a handle; Return selects the next handle, and arrow keys move it.</source>
        <translation>Was das gewählte Werkzeug kann und was es misst. Im Bild: eine Stelle anklicken, einen Griff ziehen; die Eingabetaste wählt den nächsten Griff, und Pfeiltasten bewegen ihn.</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>The editor cannot be used. %1</source>
        <translation>Der Editor kann nicht verwendet werden. %1</translation>
    </message>
    <message>
        <source>Help › Plugins lists all plugins and the folders that are searched for them.</source>
        <translation>Hilfe › Plugins zeigt alle Plugins und wo nach ihnen gesucht wird.</translation>
    </message>
    <message>
        <source>The mode %1 does not use a transfer function. Changes appear in other modes.</source>
        <translation>Der Modus %1 zeigt keine Transferfunktion. Änderungen sind in anderen Modi zu sehen.</translation>
    </message>
    <message>
        <source>The mode %1 has nothing to edit here. Choose another mode.</source>
        <translation>Im Modus %1 gibt es hier nichts zu bearbeiten. Wählen Sie einen anderen Modus.</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a Dataset or a Model</source>
        <translation>Datensatz oder Modell öffnen</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save Statistics</source>
        <translation>Statistik speichern</translation>
    </message>
    <message>
        <source>Tables of comma-separated values (*.csv)</source>
        <translation>Tabellen, durch Kommas getrennt (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>TIFF pictures (*.tif *.tiff)</source>
        <translation>TIFF-Bilder (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>JPEG pictures (*.jpg *.jpeg)</source>
        <translation>JPEG-Bilder (*.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
</context>
<context>
    <name>HelpActions</name>
    <message>
        <source>Restart TAn to change the language.</source>
        <translation>Starten Sie TAn neu, um die Sprache zu wechseln.</translation>
    </message>
    <message>
        <source>&amp;As the System</source>
        <translation>&amp;Wie das System</translation>
    </message>
</context>
<context>
    <name>ImportForm</name>
    <message>
        <source>%1 (of the cells)</source>
        <translation>%1 (der Zellen)</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>%1: t = %2</source>
        <translation>%1: t = %2</translation>
    </message>
    <message>
        <source>All that go together</source>
        <translation>Alle, die zusammenpassen</translation>
    </message>
    <message>
        <source>%1, %2 components</source>
        <translation>%1, %2 Komponenten</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
</context>
<context>
    <name>ImportTexts</name>
    <message>
        <source>%1 = %2 bytes: exactly the size of the file.</source>
        <translation>%1 = %2 Bytes: genau so viele hat die Datei.</translation>
    </message>
    <message>
        <source>All %1 = %2 points.</source>
        <translation>Alle %1 = %2 Punkte.</translation>
    </message>
    <message>
        <source>%1 = %2 of %3 points.</source>
        <translation>%1 = %2 von %3 Punkten.</translation>
    </message>
    <message>
        <source>The build takes about %1 of memory, %2 of disk and %3.</source>
        <translation>Der Bau braucht etwa %1 Arbeitsspeicher, %2 Plattenplatz und %3.</translation>
    </message>
    <message>
        <source>The build takes up to %1 of memory, %2 of disk and %3.</source>
        <translation>Der Bau braucht bis zu %1 Arbeitsspeicher, %2 Plattenplatz und %3.</translation>
    </message>
    <message>
        <source>This machine has %1 of memory.</source>
        <translation>Dieser Rechner hat %1 Arbeitsspeicher.</translation>
    </message>
    <message>
        <source>A volume needs at least two points along each axis. Choose a larger region or a smaller stride.</source>
        <translation>Ein Volumen braucht mindestens zwei Punkte entlang jeder Achse. Nehmen Sie einen größeren Bereich oder eine kleinere Schrittweite.</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 = %2 bytes; the file has %3 (%4 missing).</source>
        <translation>%1 = %2 Bytes; die Datei hat %3 (%4 fehlen).</translation>
    </message>
    <message>
        <source>%1 = %2 bytes; the file has %3 (%4 too many).</source>
        <translation>%1 = %2 Bytes; die Datei hat %3 (%4 zu viel).</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>LogarithmText</name>
    <message>
        <source>a factor of %1</source>
        <translation>Faktor %1</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>No web browser was found on this computer. Install one, or read %1.</source>
        <translation>Hier öffnet kein Programm Webseiten. Installieren Sie einen Webbrowser, oder lesen Sie %1.</translation>
    </message>
    <message>
        <source>The manual is not installed. Reinstall the package tan with its documentation, or build TAn on a system that has Sphinx (python3-sphinx, python3-myst-parser, furo); the same texts are in the folder docs of the source code.</source>
        <translation>Das Handbuch ist nicht installiert. Installieren Sie das Paket tan noch einmal mit seiner Dokumentation, oder bauen Sie TAn dort, wo Sphinx installiert ist (python3-sphinx, python3-myst-parser, furo); dieselben Texte liegen im Ordner docs der Quellen.</translation>
    </message>
</context>
<context>
    <name>MeshText</name>
    <message>
        <source>Limited by the budget of %1 tetrahedra.</source>
        <translation>Durch das Budget von %1 Tetraedern begrenzt.</translation>
    </message>
    <message>
        <source>Full resolution of the model.</source>
        <translation>Volle Auflösung des Modells.</translation>
    </message>
    <message>
        <source>The model contains no finer level.</source>
        <translation>Das Modell enthält keine feinere Stufe.</translation>
    </message>
    <message>
        <source>%1 of its %2 tetrahedra are shown.</source>
        <translation>%1 seiner %2 Tetraeder werden gezeigt.</translation>
    </message>
    <message>
        <source>Shown: %1, and the same warping.</source>
        <translation>Gezeigt: %1, Verwerfung ebenso.</translation>
    </message>
    <message>
        <source>Shown: %1.</source>
        <translation>Gezeigt: %1.</translation>
    </message>
    <message>
        <source>%1 tetrahedra in %2 pieces, cut by the crop box</source>
        <translation>%1 Tetraeder in %2 Stücken, wie das Fenster sie schneidet</translation>
    </message>
    <message>
        <source>Shown: tetrahedra of the meshes of %1. %2 of %3 are selected.</source>
        <translation>Gezeigt: Tetraeder der Netze (%1). %2 von %3 sind ausgewählt.</translation>
    </message>
    <message>
        <source>Shown: %1, warping %2.</source>
        <translation>Gezeigt: %1, Verwerfung %2.</translation>
    </message>
    <message>
        <source>Shown: %1, with any warping.</source>
        <translation>Gezeigt: %1, bei beliebiger Verwerfung.</translation>
    </message>
    <message>
        <source>in the grid; in space up to %1</source>
        <translation>im Gitter; im Raum bis %1</translation>
    </message>
</context>
<context>
    <name>NumberText</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Himmelblau</translation>
    </message>
    <message>
        <source>Bluish green</source>
        <translation>Blaugrün</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Reddish purple</source>
        <translation>Purpur</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
</context>
<context>
    <name>PaletteCommands</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Not possible now</source>
        <translation>Jetzt nicht möglich</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>Only in %1</source>
        <translation>Nur bei %1</translation>
    </message>
</context>
<context>
    <name>Places</name>
    <message>
        <source>%1, at its server</source>
        <translation>%1, auf seinem Server</translation>
    </message>
</context>
<context>
    <name>PluginChoice</name>
    <message>
        <source>Boundary: %1</source>
        <translation>Berandung: %1</translation>
    </message>
</context>
<context>
    <name>PresetNames</name>
    <message>
        <source>Cool to warm</source>
        <translation>Kalt bis warm</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Sequential: opaque where values are large</source>
        <translation>Sequentiell: deckend, wo die Werte groß sind</translation>
    </message>
    <message>
        <source>Diverging: opaque at both ends</source>
        <translation>Divergierend: deckend an beiden Enden</translation>
    </message>
    <message>
        <source>CT: bone</source>
        <translation>CT: Knochen</translation>
    </message>
    <message>
        <source>CT: skin and bone</source>
        <translation>CT: Haut und Knochen</translation>
    </message>
    <message>
        <source>CT: skin</source>
        <translation>CT: Haut</translation>
    </message>
    <message>
        <source>CT: muscle and soft tissue</source>
        <translation>CT: Muskeln und Weichteile</translation>
    </message>
    <message>
        <source>CT: fat</source>
        <translation>CT: Fett</translation>
    </message>
    <message>
        <source>CT: lung</source>
        <translation>CT: Lunge</translation>
    </message>
    <message>
        <source>CT: vessels with contrast medium</source>
        <translation>CT: Gefäße mit Kontrastmittel</translation>
    </message>
    <message>
        <source>CT: heart with contrast medium</source>
        <translation>CT: Herz mit Kontrastmittel</translation>
    </message>
    <message>
        <source>CT: organs of the abdomen</source>
        <translation>CT: Organe des Bauchs</translation>
    </message>
    <message>
        <source>CT: teeth</source>
        <translation>CT: Zähne</translation>
    </message>
    <message>
        <source>CT: metal and implants</source>
        <translation>CT: Metall und Implantate</translation>
    </message>
    <message>
        <source>CT: like an X-ray picture</source>
        <translation>CT: wie ein Röntgenbild</translation>
    </message>
    <message>
        <source>MR: head</source>
        <translation>MRT: Kopf</translation>
    </message>
    <message>
        <source>MR: brain</source>
        <translation>MRT: Gehirn</translation>
    </message>
    <message>
        <source>MR: vessels (angiography)</source>
        <translation>MRT: Gefäße (Angiographie)</translation>
    </message>
    <message>
        <source>MR: bright tissue</source>
        <translation>MRT: helles Gewebe</translation>
    </message>
    <message>
        <source>Metal part</source>
        <translation>Metallteil</translation>
    </message>
    <message>
        <source>Metal and pores</source>
        <translation>Metall und Poren</translation>
    </message>
    <message>
        <source>Stone and pores</source>
        <translation>Stein und Poren</translation>
    </message>
    <message>
        <source>Fire: glowing where values are large</source>
        <translation>Feuer: glühend, wo die Werte groß sind</translation>
    </message>
    <message>
        <source>Smoke and clouds</source>
        <translation>Rauch und Wolken</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Layers: five shells</source>
        <translation>Schichten: fünf Schalen</translation>
    </message>
    <message>
        <source>Sequential: opaque where values are small</source>
        <translation>Sequentiell: deckend, wo die Werte klein sind</translation>
    </message>
    <message>
        <source>Blue to orange</source>
        <translation>Blau bis Orange</translation>
    </message>
    <message>
        <source>Categories</source>
        <translation>Kategorien</translation>
    </message>
    <message>
        <source>Plasma: opaque where values are large</source>
        <translation>Plasma: deckend, wo die Werte groß sind</translation>
    </message>
    <message>
        <source>Turbo: opaque where values are large</source>
        <translation>Turbo: deckend, wo die Werte groß sind</translation>
    </message>
    <message>
        <source>Categories: seven colours, evenly opaque</source>
        <translation>Kategorien: sieben Farben, gleichmäßig deckend</translation>
    </message>
</context>
<context>
    <name>RescaleDialog</name>
    <message>
        <source>Rescale Transfer Function</source>
        <translation>Transferfunktion strecken</translation>
    </message>
    <message>
        <source>Value of the first point, in data units</source>
        <translation>Wert des ersten Punkts, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>Value of the last point, in data units</source>
        <translation>Wert des letzten Punkts, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Bis</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 × %1 × %1 points</source>
        <translation>%1 × %1 × %1 Punkte</translation>
    </message>
    <message>
        <source>Buckyball</source>
        <translation>Fußballmolekül</translation>
    </message>
    <message>
        <source>Electron density of a C60 molecule; regular grid, %1, computed by TAn. See the cage of atoms as an isosurface, and how few tetrahedra are enough for an error of 1 %.</source>
        <translation>Elektronendichte eines C60-Moleküls; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: der Käfig der Atome als Isofläche, und wie wenige Tetraeder für einen Fehler von 1 % genügen.</translation>
    </message>
    <message>
        <source>Hydrogen atom</source>
        <translation>Wasserstoffatom</translation>
    </message>
    <message>
        <source>Probability density of the 3d electron; regular grid, %1, computed by TAn. See the two lobes and the ring, as a volume or as isosurfaces.</source>
        <translation>Aufenthaltswahrscheinlichkeit des 3d-Elektrons; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: die beiden Keulen und der Ring, als Volumen oder als Isoflächen.</translation>
    </message>
    <message>
        <source>Supersonic flow</source>
        <translation>Überschallströmung</translation>
    </message>
    <message>
        <source>Density in front of a hemisphere; curvilinear grid, %1, computed by TAn. See the bow shock, and how the grid follows the body.</source>
        <translation>Dichte vor einer Halbkugel; krummliniges Gitter, %1, von TAn berechnet. Sehenswert: die Bugstoßwelle, und das Gitter, das dem Körper folgt.</translation>
    </message>
    <message>
        <source>Flow around a cylinder</source>
        <translation>Zylinderumströmung</translation>
    </message>
    <message>
        <source>Pressure of the flow; curvilinear grid that closes on itself, %1, computed by TAn. See the front, where the flow is stopped, and the sides, where it is fastest.</source>
        <translation>Druck der Strömung; in sich geschlossenes krummliniges Gitter, %1, von TAn berechnet. Sehenswert: die Vorderseite, wo die Strömung gestaut wird, und die Seiten, wo sie am schnellsten ist.</translation>
    </message>
    <message>
        <source>Flow in a duct</source>
        <translation>Kanalströmung</translation>
    </message>
    <message>
        <source>Speed in a bent duct; curvilinear grid, %1, computed by TAn. See how the flow keeps to the outer wall of the bend.</source>
        <translation>Geschwindigkeit in einem gebogenen Kanal; krummliniges Gitter, %1, von TAn berechnet. Sehenswert: wie sich die Strömung an die Außenwand der Biegung hält.</translation>
    </message>
    <message>
        <source>Plate with holes</source>
        <translation>Platte mit Löchern</translation>
    </message>
    <message>
        <source>Stress in a plate with five holes and a closed cavity; irregular mesh, computed by TAn. See how the boundary keeps its holes at every accuracy.</source>
        <translation>Spannung in einer Platte mit fünf Löchern und einem Hohlraum; unregelmäßiges Netz, von TAn berechnet. Sehenswert: die Berandung, die ihre Löcher in jeder Genauigkeit behält.</translation>
    </message>
    <message>
        <source>Scattered points</source>
        <translation>Verstreute Punkte</translation>
    </message>
    <message>
        <source>Waves that become finer outwards, sampled at random points in a ball; %1, computed by TAn. See the volume: it needs no grid.</source>
        <translation>Wellen, die nach außen feiner werden, an zufälligen Punkten einer Kugel abgetastet; %1, von TAn berechnet. Sehenswert: das Volumen, das kein Gitter braucht.</translation>
    </message>
    <message>
        <source>Ripples</source>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>The test signal of Marschner and Lobb; regular grid, %1, computed by TAn. See the fine ripples, which vanish first as the error grows.</source>
        <translation>Das Testsignal von Marschner und Lobb; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: die feinen Wellen, die bei wachsendem Fehler zuerst verschwinden.</translation>
    </message>
    <message>
        <source>Boundary layer</source>
        <translation>Grenzschicht</translation>
    </message>
    <message>
        <source>A layer at a wall; rectilinear grid with growing spacing, %1, computed by TAn. See how the tetrahedra crowd at the wall.</source>
        <translation>Eine Schicht an einer Wand; rechtwinkliges Gitter mit wachsenden Abständen, %1, von TAn berechnet. Sehenswert: wie sich die Tetraeder an der Wand drängen.</translation>
    </message>
    <message>
        <source>White noise</source>
        <translation>Weißes Rauschen</translation>
    </message>
    <message>
        <source>Random values, the worst case for any method; regular grid, %1, computed by TAn. See the statistics: even at a large error nearly all points are needed.</source>
        <translation>Zufallswerte, der schlimmste Fall für jedes Verfahren; regelmäßiges Gitter, %1, von TAn berechnet. Sehenswert: die Statistik, denn auch bei einem großen Fehler werden fast alle Punkte gebraucht.</translation>
    </message>
</context>
<context>
    <name>Statistics</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>± value</source>
        <translation>± Wert</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Total vertices</source>
        <translation>Knoten insgesamt</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 Knoten, %2 Tetraeder</translation>
    </message>
    <message>
        <source>Guaranteed</source>
        <translation>Garantiert</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Extraction</source>
        <translation>Extraktion</translation>
    </message>
    <message>
        <source>Preparation</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Ein Bild</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>Visibility cycles</source>
        <translation>Zyklen der Sichtfolge</translation>
    </message>
    <message>
        <source>tetrahedra cut: %1</source>
        <translation>zerschnittene Tetraeder: %1</translation>
    </message>
    <message>
        <source>tetrahedra cut: %1; overlapping groups, drawn by distance: %2</source>
        <translation>zerschnittene Tetraeder: %1; überlappende Gruppen, nach Entfernung gezeichnet: %2</translation>
    </message>
    <message>
        <source>Faulty cells</source>
        <translation>Fehlerhafte Zellen</translation>
    </message>
    <message>
        <source>Faulty cells outlined</source>
        <translation>Davon umrissen</translation>
    </message>
    <message>
        <source>Used from the file</source>
        <translation>Aus der Datei genommen</translation>
    </message>
    <message>
        <source>Not used from the file</source>
        <translation>Nicht daraus benutzt</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>logarithmic; an error of 1 % is %1</source>
        <translation>logarithmisch; ein Fehler von 1 % entspricht dem %1</translation>
    </message>
</context>
<context>
    <name>ValueReadOut</name>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Knoten</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 Knoten</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyBox</name>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Error in percent of the value range</source>
        <translation>Fehler in Prozent des Wertebereichs</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyCurve</name>
    <message>
        <source>%1G</source>
        <translation>%1G</translation>
    </message>
    <message>
        <source>%1M</source>
        <translation>%1M</translation>
    </message>
    <message>
        <source>%1k</source>
        <translation>%1k</translation>
    </message>
    <message>
        <source>Tetrahedra against error</source>
        <translation>Tetraeder gegen Fehler</translation>
    </message>
    <message>
        <source>Number of tetrahedra needed for each error. Click, drag or use the arrow keys to choose the accuracy.</source>
        <translation>Wie viele Tetraeder jeder Fehler braucht. Klicken, ziehen oder Pfeiltasten wählen die Genauigkeit.</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>%1 tetrahedra at an %2 of %3</source>
        <translation>%1 Tetraeder bei einem %2 von %3</translation>
    </message>
    <message>
        <source>%1, % of the value range</source>
        <translation>%1, % des Wertebereichs</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyPanel</name>
    <message>
        <source>%1 of all</source>
        <translation>%1 von allen</translation>
    </message>
    <message>
        <source>Error of %1 of the value range</source>
        <translation>Fehler von %1 des Wertebereichs</translation>
    </message>
    <message>
        <source>Every sample exact</source>
        <translation>Jeder Abtastwert genau</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Bu&amp;dget</source>
        <translation>Bud&amp;get</translation>
    </message>
    <message>
        <source>The smallest mesh with this error</source>
        <translation>Das kleinste Netz mit diesem Fehler</translation>
    </message>
    <message>
        <source>The best mesh with at most this number of tetrahedra. A focus keeps its ratio to the rest.</source>
        <translation>Das beste Netz mit so vielen Tetraedern. Ein Fokus behält sein Verhältnis zum Rest.</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Err&amp;or</source>
        <translation>Fehle&amp;r</translation>
    </message>
    <message>
        <source>War&amp;ping</source>
        <translation>&amp;Verwerfung</translation>
    </message>
    <message>
        <source>Same as the error</source>
        <translation>Wie der Fehler</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Limit of the warping</source>
        <translation>Grenze der Verwerfung</translation>
    </message>
    <message>
        <source>Limit on the warping, the distance of the mesh from the data: the same percentage as the error, but of the diagonal; a percentage of its own; or none, for the smallest mesh whose values are within the error</source>
        <translation>Grenze der Verwerfung, des Abstands des Netzes von den Daten: der Prozentsatz des Fehlers, dann von der Diagonale; ein eigener; oder keine, für das kleinste Netz, dessen Werte innerhalb des Fehlers liegen</translation>
    </message>
    <message>
        <source>Warping in percent of the diagonal</source>
        <translation>Verwerfung in Prozent der Diagonale</translation>
    </message>
    <message>
        <source>Warping in percent of the diagonal of the data&apos;s bounding box</source>
        <translation>Verwerfung in Prozent der Diagonale des Quaders um die Daten</translation>
    </message>
    <message>
        <source>The percentages in data units. The warping of curvilinear and irregular data is the distance of the mesh from the data, in percent of the diagonal of the data&apos;s bounding box. Samples just outside the mesh, of irregular data and of grids decimated as a mesh, are compared with a place on its boundary within the warping; at the nearest place the error may be larger, and &apos;tan verify&apos; measures it.</source>
        <translation>Was die Prozentsätze in Einheiten der Daten bedeuten. Die Verwerfung krummliniger und unregelmäßiger Daten ist der Abstand des Netzes von den Daten, in Prozent der Diagonale des Quaders um diese. Abtastwerte unregelmäßiger Daten und als Netz vergröberter Gitter, die knapp außerhalb des Netzes liegen, werden mit einer Stelle seiner Berandung innerhalb der Verwerfung verglichen; am nächsten Ort kann der Fehler größer sein, und „tan verify“ misst ihn.</translation>
    </message>
    <message>
        <source>This model was built down to an %1 of %2; it contains nothing finer.</source>
        <translation>Dieses Modell wurde bis zu einem %1 von %2 gebaut; Feineres enthält es nicht.</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>%1 in value
any warping</source>
        <translation>%1 im Wert
beliebige Verwerfung</translation>
    </message>
    <message>
        <source>%1 in value
warping %2</source>
        <translation>%1 im Wert
Verwerfung %2</translation>
    </message>
    <message>
        <source>of the range
%1</source>
        <translation>des Wertebereichs
%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracySlider</name>
    <message>
        <source>Error in percent of the value range</source>
        <translation>Fehler in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>Error in percent of the value range: coarse on the left, every sample exact on the right</source>
        <translation>Fehler in Prozent des Wertebereichs: links grob, ganz rechts jeder Abtastwert genau</translation>
    </message>
</context>
<context>
    <name>tetra::AddressDialog</name>
    <message>
        <source>Access token issued by the server&apos;s operator; forgotten when TAn quits</source>
        <translation>Was der Betreiber des Servers festgelegt hat; es wird behalten, bis das Programm endet</translation>
    </message>
    <message>
        <source>&amp;Token:</source>
        <translation>&amp;Token:</translation>
    </message>
    <message>
        <source>&amp;Fetch the model</source>
        <translation>Modell &amp;holen</translation>
    </message>
    <message>
        <source>&amp;Leave the model at the server</source>
        <translation>Modell auf dem Server &amp;lassen</translation>
    </message>
    <message>
        <source>Open URL</source>
        <translation>URL öffnen</translation>
    </message>
    <message>
        <source>&amp;Address of a model on a server:</source>
        <translation>&amp;Adresse eines Modells auf einem Server:</translation>
    </message>
    <message>
        <source>Address of the model, packed or not: http:// or https://</source>
        <translation>Wo das Modell liegt, gepackt oder nicht: http:// oder https://</translation>
    </message>
    <message>
        <source>The server extracts each mesh and sends only that: for models too large for this computer. Every change waits for the network.</source>
        <translation>Der Server bestimmt jedes Netz und sendet nur dieses: für Modelle, die für diesen Rechner zu groß sind. Jede Änderung wartet auf das Netzwerk.</translation>
    </message>
    <message>
        <source>Requires a TAn server: &apos;tan serve&apos;</source>
        <translation>Wenn der Server einer von TAn ist: „tan serve“</translation>
    </message>
    <message>
        <source>This server requires a token.</source>
        <translation>Dieser Server antwortet nur dem, der sein Token hat.</translation>
    </message>
    <message>
        <source>Wrong token.</source>
        <translation>Das ist nicht das Token des Servers.</translation>
    </message>
    <message>
        <source>%L1 vertices, %2.</source>
        <translation>%L1 Knoten, %2.</translation>
    </message>
    <message>
        <source>%1 packed, %2 unpacked</source>
        <translation>%1 gepackt, %2 entpackt</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>The server of %1 requires its &amp;token:</source>
        <translation>Der Server von %1 antwortet nur dem, der sein &amp;Token hat:</translation>
    </message>
    <message>
        <source>Downloads only what is needed; cached afterwards.</source>
        <translation>Es kommt auf diesen Rechner, soweit es gebraucht wird, und ist von da an schnell.</translation>
    </message>
    <message>
        <source>An address begins with http:// or https://.</source>
        <translation>Eine Adresse beginnt mit http:// oder https://.</translation>
    </message>
    <message>
        <source>Asking the server…</source>
        <translation>Der Server wird gefragt …</translation>
    </message>
    <message>
        <source>This server only delivers files, so the model must be downloaded.</source>
        <translation>Dieser Server gibt nur Dateien, das Modell muss also geladen werden.</translation>
    </message>
    <message>
        <source>%1 That is more than this computer has room for: leave it at the server.</source>
        <translation>%1 Das ist mehr, als auf diesem Rechner Platz hat: Lassen Sie es auf dem Server.</translation>
    </message>
</context>
<context>
    <name>tetra::AnimationPanel</name>
    <message>
        <source>&amp;Save Film…</source>
        <translation>Film spe&amp;ichern …</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Turntable, or a camera path through key frames</source>
        <translation>Drehteller oder Kamerafahrt durch Schlüsselbilder</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>Frames per second of the film</source>
        <translation>Bilder pro Sekunde des Films</translation>
    </message>
    <message>
        <source>Write it as pictures or a video</source>
        <translation>Als Bilder oder als Video schreiben</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>Ra&amp;te</source>
        <translation>Bildra&amp;te</translation>
    </message>
    <message>
        <source>Around the vertical axis</source>
        <translation>Um die senkrechte Achse</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Auf und ab</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Number of frames of the film</source>
        <translation>Anzahl der Bilder des Films</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;chse</translation>
    </message>
    <message>
        <source>An&amp;gle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>B&amp;ilder</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame shown</source>
        <translation>Gezeigtes Bild</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 Bilder, %2</translation>
    </message>
    <message>
        <source>Kind of film</source>
        <translation>Art des Films</translation>
    </message>
    <message>
        <source>Axis to turn around</source>
        <translation>Achse der Drehung</translation>
    </message>
    <message>
        <source>Angle to turn by</source>
        <translation>Drehwinkel</translation>
    </message>
    <message>
        <source>Number of frames</source>
        <translation>Zahl der Bilder</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Up and down: the camera returns to its start and stops at the poles</source>
        <translation>Auf und ab: Die Kamera kehrt an ihren Anfang zurück und hält an den Polen</translation>
    </message>
    <message>
        <source>Angle to turn by, in degrees; negative turns the other way</source>
        <translation>Drehwinkel in Grad; negativ dreht andersherum</translation>
    </message>
    <message>
        <source>Add at least two views.</source>
        <translation>Fügen Sie mindestens zwei Ansichten hinzu.</translation>
    </message>
</context>
<context>
    <name>tetra::AnnotationRows</name>
    <message>
        <source>Top left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>Unten rechts</translation>
    </message>
    <message>
        <source>Corner of the picture</source>
        <translation>Ecke des Bildes</translation>
    </message>
    <message>
        <source>%1: corner</source>
        <translation>%1: Ecke</translation>
    </message>
    <message>
        <source>Fixed ends</source>
        <translation>Feste Enden</translation>
    </message>
    <message>
        <source>The colour bar covers a chosen range, so that several pictures can share it; otherwise it covers all values of the data</source>
        <translation>Die Farbskala geht von einem gewählten Wert bis zu einem anderen, sodass mehrere Bilder dieselbe haben; sonst geht sie über alle Werte der Daten</translation>
    </message>
    <message>
        <source>Colour bar: smaller end</source>
        <translation>Farbskala: kleineres Ende</translation>
    </message>
    <message>
        <source>Value at the lower end of the colour bar</source>
        <translation>Wert am unteren Ende der Farbskala</translation>
    </message>
    <message>
        <source>Colour bar: larger end</source>
        <translation>Farbskala: größeres Ende</translation>
    </message>
    <message>
        <source>Value at the upper end of the colour bar</source>
        <translation>Wert am oberen Ende der Farbskala</translation>
    </message>
    <message>
        <source>Text of the title</source>
        <translation>Text des Titels</translation>
    </message>
    <message>
        <source>The title; if empty, the name of the model</source>
        <translation>Der Titel; wenn leer, der Name des Modells</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Colour bar: quantity</source>
        <translation>Farbskala: Größe</translation>
    </message>
    <message>
        <source>What the colour bar shows, such as density; if empty, the name of the values in the data</source>
        <translation>Was die Farbskala zeigt, etwa Dichte; wenn leer, der Name der Werte in den Daten</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Colour bar: unit</source>
        <translation>Farbskala: Einheit</translation>
    </message>
    <message>
        <source>The unit of the values, such as HU or K, written in brackets behind the quantity</source>
        <translation>Die Einheit der Werte, etwa HU oder K; sie steht in Klammern hinter der Größe</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Ausgeschrieben</translation>
    </message>
    <message>
        <source>Powers of ten</source>
        <translation>Zehnerpotenzen</translation>
    </message>
    <message>
        <source>Colour bar: format of the numbers</source>
        <translation>Farbskala: Zahlenformat</translation>
    </message>
    <message>
        <source>How the numbers at the colour bar are written: as short as tells them apart, or with a chosen number of decimals, plain or in powers of ten</source>
        <translation>Wie die Zahlen an der Farbskala geschrieben werden: so kurz, dass sie sich unterscheiden, oder mit einer gewählten Zahl von Nachkommastellen, ausgeschrieben oder in Zehnerpotenzen</translation>
    </message>
    <message>
        <source>Colour bar: decimals</source>
        <translation>Farbskala: Nachkommastellen</translation>
    </message>
    <message>
        <source>Number of digits behind the decimal point</source>
        <translation>Zahl der Stellen hinter dem Dezimalkomma</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>Lengths: format of the numbers</source>
        <translation>Längen: Zahlenformat</translation>
    </message>
    <message>
        <source>How the numbers of the scale bar and of the axes are written: as short as tells them apart, or with a chosen number of decimals, plain or in powers of ten</source>
        <translation>Wie die Zahlen des Maßstabs und der Achsen geschrieben werden: so kurz, dass sie sich unterscheiden, oder mit einer gewählten Zahl von Nachkommastellen, ausgeschrieben oder in Zehnerpotenzen</translation>
    </message>
    <message>
        <source>Lengths: decimals</source>
        <translation>Längen: Nachkommastellen</translation>
    </message>
    <message>
        <source>Annotations: size of the text</source>
        <translation>Beschriftung: Schriftgröße</translation>
    </message>
    <message>
        <source>How large the texts of all annotations are; bars, arrows and lines grow with them</source>
        <translation>Wie groß die Schrift aller Beschriftung ist; Balken, Pfeile und Linien wachsen mit</translation>
    </message>
    <message>
        <source>Write all annotations in bold letters</source>
        <translation>Alle Beschriftung fett schreiben</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
</context>
<context>
    <name>tetra::BookmarkActions</name>
    <message>
        <source>&amp;Add Bookmark</source>
        <translation>Lesezeichen &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Keep the current view as a bookmark, which the session saves</source>
        <translation>Die jetzige Ansicht als Lesezeichen behalten; die Sitzung speichert es</translation>
    </message>
    <message>
        <source>&amp;Edit Bookmarks…</source>
        <translation>Lesezeichen &amp;bearbeiten …</translation>
    </message>
    <message>
        <source>Show, rename, replace, move and remove bookmarks</source>
        <translation>Lesezeichen zeigen, umbenennen, ersetzen, verschieben und entfernen</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>Show this bookmark</source>
        <translation>Dieses Lesezeichen zeigen</translation>
    </message>
</context>
<context>
    <name>tetra::BookmarkDialog</name>
    <message>
        <source>Bookmarks</source>
        <translation>Lesezeichen</translation>
    </message>
    <message>
        <source>Enter shows a bookmark, F2 renames it, Delete removes it, Alt with an arrow moves it</source>
        <translation>Eingabe zeigt ein Lesezeichen, F2 benennt es um, Entf entfernt es, Alt mit einem Pfeil verschiebt es</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Add the current view as a bookmark</source>
        <translation>Die jetzige Ansicht als Lesezeichen hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Show this bookmark (Enter)</source>
        <translation>Dieses Lesezeichen zeigen (Eingabe)</translation>
    </message>
    <message>
        <source>Re&amp;place</source>
        <translation>E&amp;rsetzen</translation>
    </message>
    <message>
        <source>Replace this bookmark with the current view</source>
        <translation>Dieses Lesezeichen durch die jetzige Ansicht ersetzen</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Um&amp;benennen</translation>
    </message>
    <message>
        <source>Rename this bookmark (F2)</source>
        <translation>Dieses Lesezeichen umbenennen (F2)</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Swap with the previous bookmark (Alt+Up)</source>
        <translation>Mit dem vorigen Lesezeichen tauschen (Alt+Pfeil auf)</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>Swap with the next bookmark (Alt+Down)</source>
        <translation>Mit dem nächsten Lesezeichen tauschen (Alt+Pfeil ab)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Remove this bookmark (Delete)</source>
        <translation>Dieses Lesezeichen entfernen (Entf)</translation>
    </message>
</context>
<context>
    <name>tetra::BudgetBox</name>
    <message>
        <source>Most tetrahedra</source>
        <translation>Höchstzahl der Tetraeder</translation>
    </message>
    <message>
        <source>The best mesh with at most this number of tetrahedra</source>
        <translation>Das beste Netz mit höchstens so vielen Tetraedern</translation>
    </message>
</context>
<context>
    <name>tetra::BuildPanel</name>
    <message>
        <source>Open a dataset to build a model of it.</source>
        <translation>Öffnen Sie einen Datensatz, um sein Modell zu bauen.</translation>
    </message>
    <message>
        <source>Builder</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the model is built</source>
        <translation>Wie das Modell gebaut wird</translation>
    </message>
    <message>
        <source>B&amp;uilder</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>Model file</source>
        <translation>Modelldatei</translation>
    </message>
    <message>
        <source>Model file to write</source>
        <translation>Zu schreibende Modelldatei</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen …</translation>
    </message>
    <message>
        <source>&amp;Model file</source>
        <translation>&amp;Modelldatei</translation>
    </message>
    <message>
        <source>Progress of the build</source>
        <translation>Fortschritt des Bauens</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Stop the build and discard the result</source>
        <translation>Den Bau anhalten und das Ergebnis verwerfen</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>Anhalten und behal&amp;ten</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Keeping what is finished…</source>
        <translation>Das Fertige wird behalten …</translation>
    </message>
    <message>
        <source>&amp;Build and Replace</source>
        <translation>Ba&amp;uen und ersetzen</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>Ba&amp;uen</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt …</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>Model File</source>
        <translation>Modelldatei</translation>
    </message>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelle (*.tan)</translation>
    </message>
    <message>
        <source>%1 scattered points</source>
        <translation>%1 verstreute Punkte</translation>
    </message>
    <message>
        <source>irregular mesh of %1 points, %2 tetrahedra</source>
        <translation>unregelmäßiges Netz aus %1 Punkten, %2 Tetraedern</translation>
    </message>
    <message>
        <source>curvilinear grid of %1 points, %2 cells</source>
        <translation>krummliniges Gitter mit %1 Punkten, %2 Zellen</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Abtastwerte</translation>
    </message>
    <message>
        <source>%1, %2, values %3 to %4</source>
        <translation>%1, %2, Werte %3 bis %4</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>&amp;Importoptionen …</translation>
    </message>
    <message>
        <source>Estimated from a few thousand samples of the dataset; it may be off by a factor of two</source>
        <translation>Aus einigen Tausend Abtastwerten des Datensatzes geschätzt; kann um den Faktor zwei abweichen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Qui&amp;ck look, error 1 %</source>
        <translation>&amp;Schneller Blick, Fehler 1 %</translation>
    </message>
    <message>
        <source>Keeps enough for an error of 1 % of the value range: enough for a first look</source>
        <translation>Behält, was für einen Fehler von 1 % des Wertebereichs nötig ist: genug für einen ersten Blick</translation>
    </message>
    <message>
        <source>&amp;Good, error 0.1 %</source>
        <translation>&amp;Gut, Fehler 0,1 %</translation>
    </message>
    <message>
        <source>Keeps enough for an error of 0.1 % of the value range: pictures can hardly be told from those of the full data</source>
        <translation>Behält, was für einen Fehler von 0,1 % des Wertebereichs nötig ist: Bilder sind von denen aller Daten kaum zu unterscheiden</translation>
    </message>
    <message>
        <source>&amp;Everything</source>
        <translation>&amp;Alles</translation>
    </message>
    <message>
        <source>Keeps every value of the dataset, so that any accuracy can be shown later</source>
        <translation>Behält jeden Wert des Datensatzes, sodass später jede Genauigkeit gezeigt werden kann</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detailgrad</translation>
    </message>
    <message>
        <source>Detail (model size, build time)</source>
        <translation>Detailgrad (Modellgröße, Bauzeit)</translation>
    </message>
    <message>
        <source>rectilinear grid of %1 points, %2 cells</source>
        <translation>rechtwinkliges Gitter mit %1 Punkten, %2 Zellen</translation>
    </message>
    <message>
        <source>Re&amp;sume if interrupted</source>
        <translation>Bei Unterbrechung &amp;fortsetzbar</translation>
    </message>
    <message>
        <source>Save checkpoints so that the build can be paused and resumed, even after a crash. Short builds take up to 20 % longer, and until the build ends it needs up to three times the model&apos;s size on disk</source>
        <translation>Hält ab und zu fest, wie weit der Bau ist, sodass er angehalten werden kann und dort weitergeht, wo er war, wenn das Programm oder der Rechner ausfällt. Kurze Bauten dauern dadurch bis zu ein Fünftel länger, und bis zum Ende des Baus belegt das bis zum Dreifachen der Modellgröße auf der Platte</translation>
    </message>
    <message>
        <source>St&amp;art Over</source>
        <translation>Vo&amp;n vorn beginnen</translation>
    </message>
    <message>
        <source>Delete the interrupted build</source>
        <translation>Löscht, was der unterbrochene Bau hinterlassen hat</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Stop the build; it can be resumed later, even after TAn has been closed</source>
        <translation>Hält den Bau an; er geht später von dort weiter, auch wenn das Programm inzwischen beendet wird</translation>
    </message>
    <message>
        <source>Resume &amp;Build</source>
        <translation>Ba&amp;u fortsetzen</translation>
    </message>
    <message>
        <source>An interrupted build of these data was found: it will continue where it stopped.</source>
        <translation>Ein unterbrochener Bau dieser Daten wurde gefunden: Er geht dort weiter, wo er aufgehört hat.</translation>
    </message>
    <message>
        <source>Found an interrupted build of different data or with different options. Restore those options, or start over.</source>
        <translation>Ein unterbrochener Bau anderer Daten oder mit anderen Optionen wurde gefunden. Geben Sie dieselben an, oder beginnen Sie von vorn.</translation>
    </message>
    <message>
        <source>Pausing…</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>&amp;Open the Existing Model</source>
        <translation>Vorhandenes M&amp;odell öffnen</translation>
    </message>
    <message>
        <source>Open the existing model; nothing is built or replaced</source>
        <translation>Öffnet das Modell, das schon da ist; es wird nichts gebaut oder ersetzt</translation>
    </message>
    <message>
        <source>Stop the build and keep what is finished as a model, with the accuracy reached so far. A finished model of the same name is not changed.</source>
        <translation>Beendet den Bau und behält das Fertige als Modell, mit der bisher erreichten Genauigkeit. Ein fertiges Modell desselben Namens bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>This file exists. You can open it; if you build, it is replaced when the build is complete.</source>
        <translation>Diese Datei gibt es schon. Sie können sie öffnen; wenn Sie bauen, wird sie ersetzt, sobald das Modell fertig ist.</translation>
    </message>
    <message>
        <source>This exists and is not a model. Choose another name.</source>
        <translation>Das gibt es schon, und es ist kein Modell. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>spacing %1</source>
        <translation>Abstand %1</translation>
    </message>
    <message>
        <source>Scale: logarithmic; an error of 1 % is %1</source>
        <translation>Skala: logarithmisch; ein Fehler von 1 % entspricht dem %1</translation>
    </message>
    <message>
        <source>Scale: linear. The values span several powers of ten: with the logarithmic scale in Import Options, errors are factors.</source>
        <translation>Skala: linear. Die Werte gehen über mehrere Zehnerpotenzen: Mit der logarithmischen Skala unter Importoptionen sind Fehler Faktoren.</translation>
    </message>
    <message>
        <source>Read the file again with other options: other values, another scale, a part of it, or fewer points</source>
        <translation>Liest die Datei mit anderen Optionen noch einmal: andere Werte, eine andere Skala, ein Ausschnitt, weniger Punkte</translation>
    </message>
</context>
<context>
    <name>tetra::CacheDialog</name>
    <message>
        <source>C&amp;lear Now</source>
        <translation>Jetzt &amp;leeren</translation>
    </message>
    <message>
        <source>Model Cache</source>
        <translation>Modell-Zwischenspeicher</translation>
    </message>
    <message>
        <source>Packed models and models on servers are unpacked or downloaded into this folder, and opened from there the next time. When room is needed, those unused for longest are removed.</source>
        <translation>Modelle, die gepackt sind oder auf einem Server liegen, werden in diesen Ordner entpackt oder geholt und das nächste Mal von dort geöffnet. Wird Platz gebraucht, so wird entfernt, was am längsten nicht verwendet wurde.</translation>
    </message>
    <message>
        <source>Cache folder (leave empty for the default)</source>
        <translation>Der Ordner; leer für den üblichen</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>A&amp;uswählen …</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Einen anderen Ordner auswählen</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>Maximum size of the cache</source>
        <translation>Wie viel Platz er höchstens belegen darf</translation>
    </message>
    <message>
        <source>Remove all models in the folder that are not open</source>
        <translation>Alle Modelle des Ordners entfernen, die nicht geöffnet sind</translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation>&amp;Ordner:</translation>
    </message>
    <message>
        <source>At &amp;most:</source>
        <translation>&amp;Höchstens:</translation>
    </message>
    <message>
        <source>In use:</source>
        <translation>Belegt:</translation>
    </message>
</context>
<context>
    <name>tetra::Canvas</name>
    <message>
        <source>CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>OpenGL</source>
        <translation>OpenGL</translation>
    </message>
    <message>
        <source>OpenGL cannot draw this picture; the CPU draws it instead. %1</source>
        <translation>OpenGL kann dieses Bild nicht zeichnen; stattdessen zeichnet es der Prozessor. %1</translation>
    </message>
</context>
<context>
    <name>tetra::ColourButton</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Other Colour…</source>
        <translation>Andere Farbe …</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materialien</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
</context>
<context>
    <name>tetra::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Eingeben, was zu tun ist</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Type the beginnings of words to find a command or a setting. Enter runs it, Esc closes the list.</source>
        <translation>Geben Sie die Anfänge seiner Wörter ein, um einen Befehl oder eine Einstellung zu finden. Enter führt ihn aus, Esc schließt.</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nichts gefunden</translation>
    </message>
</context>
<context>
    <name>tetra::EditMenu</name>
    <message>
        <source>&amp;More opaque</source>
        <translation>&amp;Deckender</translation>
    </message>
    <message>
        <source>&amp;Less opaque</source>
        <translation>Durch&amp;sichtiger</translation>
    </message>
    <message>
        <source>Swap &amp;ends</source>
        <translation>&amp;Enden vertauschen</translation>
    </message>
    <message>
        <source>Select &amp;all points</source>
        <translation>&amp;Alle Punkte auswählen</translation>
    </message>
    <message>
        <source>&amp;Copy points</source>
        <translation>Punkte &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste points</source>
        <translation>Punkte e&amp;infügen</translation>
    </message>
    <message>
        <source>D&amp;uplicate points</source>
        <translation>Punkte &amp;verdoppeln</translation>
    </message>
    <message>
        <source>&amp;Remove points</source>
        <translation>Punkte &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Distribute values evenly</source>
        <translation>Werte &amp;gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>&amp;Flip left to right</source>
        <translation>&amp;Links und rechts vertauschen</translation>
    </message>
    <message>
        <source>&amp;Invert opacities</source>
        <translation>Deckkraft &amp;umkehren</translation>
    </message>
    <message>
        <source>Ramp from first to last</source>
        <translation>Rampe vom ersten zum letzten</translation>
    </message>
    <message>
        <source>&amp;Simplify: fewer points, same look</source>
        <translation>Ver&amp;einfachen: weniger Punkte, gleiches Aussehen</translation>
    </message>
    <message>
        <source>Add a pea&amp;k</source>
        <translation>S&amp;pitze hinzufügen</translation>
    </message>
    <message>
        <source>Ali&amp;gn</source>
        <translation>A&amp;usrichten</translation>
    </message>
    <message>
        <source>Opacities to the &amp;first</source>
        <translation>Deckkraft wie beim &amp;ersten</translation>
    </message>
    <message>
        <source>Opacities to the &amp;mean</source>
        <translation>Deckkraft im &amp;Mittel</translation>
    </message>
    <message>
        <source>Opacities to the &amp;least</source>
        <translation>Deckkraft wie beim &amp;niedrigsten</translation>
    </message>
    <message>
        <source>Opacities to the l&amp;argest</source>
        <translation>Deckkraft wie beim &amp;höchsten</translation>
    </message>
    <message>
        <source>&amp;Values of two neighbours: a step</source>
        <translation>&amp;Werte zweier Nachbarn: eine Stufe</translation>
    </message>
    <message>
        <source>Make a gr&amp;oup</source>
        <translation>&amp;Gruppe bilden</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Gruppe auswählen</translation>
    </message>
    <message>
        <source>&amp;No group</source>
        <translation>&amp;Keine Gruppe</translation>
    </message>
    <message>
        <source>When points meet neighbouri&amp;ng points</source>
        <translation>Beim Treffen auf Nachbarpu&amp;nkte</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Push them along</source>
        <translation>Mit&amp;schieben</translation>
    </message>
    <message>
        <source>Move p&amp;ast them</source>
        <translation>&amp;Überholen</translation>
    </message>
    <message>
        <source>Mas&amp;k: show some values only</source>
        <translation>&amp;Maske: nur einige Werte zeigen</translation>
    </message>
    <message>
        <source>Add an iso&amp;value</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Group &amp;%1</source>
        <translation>Gruppe &amp;%1</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Breiter</translation>
    </message>
    <message>
        <source>Na&amp;rrower</source>
        <translation>S&amp;chmaler</translation>
    </message>
    <message>
        <source>Add a &amp;point</source>
        <translation>&amp;Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add an &amp;isovalue</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>Cl&amp;ear mark</source>
        <translation>&amp;Markierung löschen</translation>
    </message>
    <message>
        <source>Follow the logarit&amp;hm of the value</source>
        <translation>Dem &amp;Logarithmus des Wertes folgen</translation>
    </message>
    <message>
        <source>From &amp;the picked value</source>
        <translation>Vom &amp;gewählten Wert</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe …</translation>
    </message>
    <message>
        <source>Rescale</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>To the values of the &amp;data</source>
        <translation>Über die Werte der &amp;Daten</translation>
    </message>
    <message>
        <source>To the values &amp;shown in the plot</source>
        <translation>Über die im Diagramm &amp;gezeigten Werte</translation>
    </message>
    <message>
        <source>To &amp;numbers…</source>
        <translation>Über einen &amp;Zahlenbereich …</translation>
    </message>
</context>
<context>
    <name>tetra::EmptyPage</name>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Datensatz oder Modell öffnen</translation>
    </message>
    <message>
        <source>Drop a file: a dataset (a volume, a grid, a mesh or points), a .tan model or a session. TAn shows large data at any accuracy, with a known error.</source>
        <translation>Legen Sie eine Datei ab: einen Datensatz (ein Volumen, ein Gitter, ein Netz oder Punkte), ein .tan-Modell oder eine Sitzung. TAn zeigt große Daten in jeder Genauigkeit, mit bekanntem Fehler.</translation>
    </message>
    <message>
        <source>Open a dataset, a model or a session (Ctrl+O)</source>
        <translation>Einen Datensatz, ein Modell oder eine Sitzung öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>Or try a sample</source>
        <translation>Oder ein Beispiel ansehen</translation>
    </message>
    <message>
        <source>Samples are computed when you choose them; nothing is downloaded.</source>
        <translation>Beispiele werden berechnet, wenn Sie eines wählen; nichts wird heruntergeladen.</translation>
    </message>
</context>
<context>
    <name>tetra::Exporting</name>
    <message>
        <source>Nothing was saved: the model was closed in the meantime.</source>
        <translation>Nichts wurde gespeichert: Das Modell wurde inzwischen geschlossen.</translation>
    </message>
</context>
<context>
    <name>tetra::FilmDialog</name>
    <message>
        <source>Numbered PNG pictures</source>
        <translation>Nummerierte PNG-Bilder</translation>
    </message>
    <message>
        <source>MP4 video (H.264)</source>
        <translation>MP4-Video (H.264)</translation>
    </message>
    <message>
        <source>WebM video (VP9)</source>
        <translation>WebM-Video (VP9)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen …</translation>
    </message>
    <message>
        <source>Save Film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Videos require the program ffmpeg</source>
        <translation>Videos gibt es, wo das Programm ffmpeg installiert ist</translation>
    </message>
    <message>
        <source>Videos are made by %1</source>
        <translation>Videos macht %1</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Fil&amp;e</source>
        <translation>Dat&amp;ei</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>A film that is being written continues</source>
        <translation>Ein Film, der geschrieben wird, läuft weiter</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>It has no frames yet: add at least two views in the Animation panel.</source>
        <translation>Er hat noch keine Bilder: Fügen Sie im Feld Animation zwei oder mehr Ansichten hinzu.</translation>
    </message>
    <message>
        <source>%1; writing takes about %2</source>
        <translation>%1; das Schreiben dauert etwa %2</translation>
    </message>
    <message>
        <source>%1, …</source>
        <translation>%1, …</translation>
    </message>
    <message>
        <source>&amp;Replace and Save</source>
        <translation>E&amp;rsetzen und speichern</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Beginnt …</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, noch etwa %2</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 Bilder, %2</translation>
    </message>
    <message>
        <source>Files with this name already exist and will be replaced: %1.</source>
        <translation>Dateien dieses Namens gibt es schon, sie werden ersetzt: %1.</translation>
    </message>
    <message>
        <source>Video file, or base name of the numbered pictures</source>
        <translation>Videodatei oder Name der nummerierten Bilder, ohne die Nummer</translation>
    </message>
</context>
<context>
    <name>tetra::FocusPanel</name>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>The same error everywhere</source>
        <translation>Überall derselbe Fehler</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>A box with its own error (B)</source>
        <translation>Ein Quader mit eigenem Fehler (B)</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>A sphere with its own error (F)</source>
        <translation>Eine Kugel mit eigenem Fehler (F)</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Mitte</translation>
    </message>
    <message>
        <source>Centre of the focus, in the coordinates of the data</source>
        <translation>Mitte des Fokus, in den Koordinaten der Daten</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Edges of the box, in data units</source>
        <translation>Kanten des Quaders, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>Radius of the sphere</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>Radius of the sphere, in data units</source>
        <translation>Radius der Kugel, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>The distance over which the error grows from its value in the focus to that outside, in data units; 0 gives a sharp border</source>
        <translation>Die Strecke, auf der der Fehler von dem im Fokus auf den außerhalb wächst, in Einheiten der Daten; 0 ist eine scharfe Grenze</translation>
    </message>
    <message>
        <source>Error in the focus</source>
        <translation>Fehler im Fokus</translation>
    </message>
    <message>
        <source>Error in the focus, in percent of the value range</source>
        <translation>Fehler im Fokus in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>Move the focus to the camera&apos;s target (C)</source>
        <translation>Den Fokus zum Zielpunkt der Kamera bewegen (C)</translation>
    </message>
    <message>
        <source>Reset position, size, error and fall-off</source>
        <translation>Ort, Größe, Fehler und Übergang zurücksetzen</translation>
    </message>
    <message>
        <source>Outside %1, as chosen under Accuracy.</source>
        <translation>Außerhalb %1, wie unter Genauigkeit gewählt.</translation>
    </message>
    <message>
        <source>Between %1 and %2 tetrahedra.</source>
        <translation>Zwischen %1 und %2 Tetraedern.</translation>
    </message>
    <message>
        <source>Rad&amp;ius</source>
        <translation>Rad&amp;ius</translation>
    </message>
    <message>
        <source>Error i&amp;nside</source>
        <translation>Fehler i&amp;nnen</translation>
    </message>
    <message>
        <source>Fa&amp;ll-off</source>
        <translation>&amp;Übergang</translation>
    </message>
    <message>
        <source>&amp;Move to Centre of View</source>
        <translation>&amp;In die Bildmitte</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>With the budget, the error outside is %1 times the error inside.</source>
        <translation>Mit dem Budget ist der Fehler außerhalb das %1-fache davon.</translation>
    </message>
    <message>
        <source>A focus is never coarser than its surroundings, so it gets the same error.</source>
        <translation>Ein Fokus ist nicht gröber als seine Umgebung, also erhält er denselben Fehler.</translation>
    </message>
    <message>
        <source>A focus is never coarser than its surroundings, so it gets %1.</source>
        <translation>Ein Fokus ist nicht gröber als seine Umgebung, also erhält er %1.</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Dis&amp;tance</source>
        <translation>&amp;Abstand</translation>
    </message>
    <message>
        <source>Value ran&amp;ge</source>
        <translation>&amp;Wertebereich</translation>
    </message>
    <message>
        <source>Where the mesh is more accurate than elsewhere. Choose a box or a sphere, then drag its handles in the picture; double-click a surface to move it there. Or let the error grow with the distance from the viewer or from the isovalues, or where little is visible.</source>
        <translation>Wo das Netz genauer ist als anderswo. Wählen Sie einen Quader oder eine Kugel und ziehen Sie an den Griffen im Bild; ein Doppelklick auf eine Fläche verschiebt den Bereich dorthin. Oder lassen Sie den Fehler mit dem Abstand vom Betrachter oder von den Isowerten wachsen, oder dort, wo wenig zu sehen ist.</translation>
    </message>
    <message>
        <source>Accuracy varies with</source>
        <translation>Genauigkeit hängt ab von</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>Betrachter</translation>
    </message>
    <message>
        <source>The error grows with the distance from the viewer. While you move the camera, the mesh stays as it is.</source>
        <translation>Der Fehler wächst mit dem Abstand vom Betrachter. Während Sie die Kamera bewegen, bleibt das Netz, wie es ist.</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isowerte</translation>
    </message>
    <message>
        <source>The error grows with the distance from the displayed isovalues</source>
        <translation>Der Fehler wächst mit dem Abstand von den gezeigten Isowerten</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>The error is smaller where the transfer function is more opaque</source>
        <translation>Der Fehler ist kleiner, wo die Transferfunktion deckender ist</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Selected region. All regions share one error and fall-off.</source>
        <translation>Der Bereich, zu dem Ort und Größe gehören; alle haben denselben Fehler und Übergang</translation>
    </message>
    <message>
        <source>Add another region of the same size</source>
        <translation>Einen weiteren Bereich derselben Größe hinzufügen</translation>
    </message>
    <message>
        <source>Remove this region</source>
        <translation>Diesen Bereich entfernen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>The distance over which the error grows from its value inside, at the part of the data nearest to the viewer, to that outside, in data units</source>
        <translation>Der Abstand, über den der Fehler von dem inneren, der an dem Teil der Daten gilt, der dem Betrachter am nächsten ist, auf den äußeren wächst, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>Range of values</source>
        <translation>Bereich der Werte</translation>
    </message>
    <message>
        <source>The difference from an isovalue over which the error grows from its value inside to that outside, in the units of the values</source>
        <translation>Der Unterschied zu einem Isowert, über den der Fehler vom inneren auf den äußeren wächst, in Einheiten der Werte</translation>
    </message>
    <message>
        <source>%1: sphere</source>
        <translation>%1: Kugel</translation>
    </message>
    <message>
        <source>%1: box</source>
        <translation>%1: Quader</translation>
    </message>
    <message>
        <source>There is no isovalue, so the error is %1 everywhere.</source>
        <translation>Es gibt keinen Isowert, daher ist der Fehler überall %1.</translation>
    </message>
    <message>
        <source>%1 tetrahedra; %2 without the focus and with its error everywhere %3.</source>
        <translation>%1 Tetraeder; ohne den Fokus %2, mit dessen Fehler überall %3.</translation>
    </message>
</context>
<context>
    <name>tetra::HelpTexts</name>
    <message>
        <source>More in the manual (F1)</source>
        <translation>Mehr im Handbuch (F1)</translation>
    </message>
</context>
<context>
    <name>tetra::HistogramView</name>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>How often the values of the displayed mesh occur, on a logarithmic scale; from the smallest to the largest value, in data units</source>
        <translation>Wie oft die Werte des gezeigten Netzes vorkommen, logarithmisch, vom kleinsten bis zum größten Wert, in den Einheiten der Daten</translation>
    </message>
</context>
<context>
    <name>tetra::ImportDialog</name>
    <message>
        <source>&amp;Read</source>
        <translation>&amp;Lesen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Reader</source>
        <translation>Leser</translation>
    </message>
    <message>
        <source>Reader used for this file</source>
        <translation>Leser für diese Datei</translation>
    </message>
    <message>
        <source>R&amp;eader</source>
        <translation>L&amp;eser</translation>
    </message>
    <message>
        <source>Import options</source>
        <translation>Importoptionen</translation>
    </message>
    <message>
        <source>Subset</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Matching layouts</source>
        <translation>Passende Anordnungen</translation>
    </message>
    <message>
        <source>Sizes and types that fit the file exactly, the most likely first</source>
        <translation>Größen und Typen, die die Datei genau füllen würden, die wahrscheinlichsten zuerst</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Fortschritt des Lesens</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>%1, %2 bytes</source>
        <translation>%1, %2 Bytes</translation>
    </message>
    <message>
        <source>None found</source>
        <translation>Keine bekannt</translation>
    </message>
    <message>
        <source>Enter the number of points along x, y and z, as in 64x64x32.</source>
        <translation>Geben Sie die Zahl der Punkte entlang x, y und z an, wie in 64x64x32.</translation>
    </message>
    <message>
        <source>Size check</source>
        <translation>Größenprüfung</translation>
    </message>
    <message>
        <source>&amp;Suggestion</source>
        <translation>&amp;Vorschlag</translation>
    </message>
    <message>
        <source>Open with these options</source>
        <translation>Öffnet den Datensatz mit diesen Optionen</translation>
    </message>
    <message>
        <source>Stops reading, or closes this window</source>
        <translation>Bricht das Lesen ab oder schließt dieses Fenster</translation>
    </message>
    <message>
        <source>An upper bound; a model with less detail takes less.</source>
        <translation>Eine obere Schranke; ein Modell mit geringerem Detailgrad braucht weniger.</translation>
    </message>
    <message>
        <source>What these options take from the file, and what else it states that is not used</source>
        <translation>Was mit diesen Optionen aus der Datei genommen würde, und was sie angibt und nicht benutzt wird</translation>
    </message>
</context>
<context>
    <name>tetra::ImportRegion</name>
    <message>
        <source>&amp;All Points</source>
        <translation>&amp;Alle Punkte</translation>
    </message>
    <message>
        <source>Only a &amp;box in space</source>
        <translation>Nur ein &amp;Quader im Raum</translation>
    </message>
    <message>
        <source>Takes every point of the dataset</source>
        <translation>Nimmt jeden Punkt des ganzen Datensatzes</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erster</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzter</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>First point along %1</source>
        <translation>Erster Punkt entlang %1</translation>
    </message>
    <message>
        <source>First point taken, counted from 0</source>
        <translation>Der erste Punkt, der genommen wird, von 0 an gezählt</translation>
    </message>
    <message>
        <source>Last point along %1</source>
        <translation>Letzter Punkt entlang %1</translation>
    </message>
    <message>
        <source>Last point taken, counted from 0</source>
        <translation>Der letzte Punkt, der genommen wird, von 0 an gezählt</translation>
    </message>
    <message>
        <source>Stride along %1</source>
        <translation>Schrittweite entlang %1</translation>
    </message>
    <message>
        <source>Keep every n-th point</source>
        <translation>Behält jeden n-ten Punkt</translation>
    </message>
    <message>
        <source>Takes only what lies in a box; for irregular meshes, whole tetrahedra</source>
        <translation>Nimmt nur, was in einem Quader liegt; von unregelmäßigen Netzen ganze Tetraeder</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Bis %1</translation>
    </message>
    <message>
        <source>A corner of the box, in the coordinates of the data</source>
        <translation>Eine Ecke des Quaders, in den Koordinaten der Daten</translation>
    </message>
</context>
<context>
    <name>tetra::IsovaluePanel</name>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>&amp;Isowert hinzufügen</translation>
    </message>
    <message>
        <source>No isovalue: there is nothing to draw but the outline.</source>
        <translation>Kein Isowert: Außer dem Umriss ist nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Add an isosurface at another value (Ctrl+I)</source>
        <translation>Fügt eine Isofläche bei einem weiteren Wert hinzu (Strg+I)</translation>
    </message>
</context>
<context>
    <name>tetra::IsovalueRow</name>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Isovalue, in the units of the data: %1 to %2</source>
        <translation>Isowert, in den Einheiten der Daten: %1 bis %2</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity in percent; below 100 % what lies behind it shows through</source>
        <translation>Deckkraft in Prozent; unter 100 % scheint durch, was dahinter liegt</translation>
    </message>
    <message>
        <source>Show this isosurface</source>
        <translation>Diese Isofläche zeigen</translation>
    </message>
    <message>
        <source>Remove this isovalue (Del)</source>
        <translation>Diesen Isowert entfernen (Entf)</translation>
    </message>
    <message>
        <source>Remove this isovalue</source>
        <translation>Diesen Isowert entfernen</translation>
    </message>
    <message>
        <source> sd</source>
        <translation> sd</translation>
    </message>
    <message>
        <source>Isovalue in standard deviations above the mean</source>
        <translation>Isowert in Standardabweichungen über dem Mittelwert</translation>
    </message>
    <message>
        <source>The isovalue in standard deviations above the mean. The mean of all samples is %1, their standard deviation %2. In the box above, 2.5sd can be typed, too.</source>
        <translation>Der Isowert in Standardabweichungen über dem Mittelwert. Der Mittelwert aller Abtastwerte ist %1, ihre Standardabweichung %2. Im Feld darüber kann man auch 2,5sd eingeben.</translation>
    </message>
    <message>
        <source>Above the mean</source>
        <translation>Über dem Mittel</translation>
    </message>
</context>
<context>
    <name>tetra::KeepSession</name>
    <message>
        <source>Save Session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sitzungen (*.tansession)</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Saved automatically on %1. Model: %2</source>
        <translation>Automatisch gesichert am %1. Modell: %2</translation>
    </message>
    <message>
        <source>%1 contains the session it was made with, which can be restored.</source>
        <translation>%1 enthält die Sitzung, mit der es entstanden ist; sie kann wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>%1 had unsaved changes when TAn was ended.</source>
        <translation>%1 hatte Änderungen, die nicht gespeichert waren, als TAn beendet wurde.</translation>
    </message>
    <message>
        <source>TAn ended unexpectedly while %1 was open.</source>
        <translation>TAn endete unerwartet, während %1 geöffnet war.</translation>
    </message>
    <message>
        <source>Its view can be restored.</source>
        <translation>Seine Ansicht kann wiederhergestellt werden.</translation>
    </message>
    <message>
        <source>The model %1 was not found where it was, in %2.</source>
        <translation>Das Modell %1 wurde nicht gefunden, wo es war, in %2.</translation>
    </message>
    <message>
        <source>The model %1 of %2 was not found where it was, in %3, nor near the session.</source>
        <translation>Das Modell %1 zu %2 wurde weder gefunden, wo es war, in %3, noch in der Nähe der Sitzung.</translation>
    </message>
    <message>
        <source>&amp;Locate Model…</source>
        <translation>Modell &amp;suchen …</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelle (*.tan)</translation>
    </message>
</context>
<context>
    <name>tetra::KeyFrameList</name>
    <message>
        <source>%1°, %2° at %3</source>
        <translation>%1°, %2° bei %3</translation>
    </message>
    <message>
        <source>%1, %2 tetrahedra</source>
        <translation>%1, %2 Tetraeder</translation>
    </message>
    <message>
        <source>%1, error %2</source>
        <translation>%1, Fehler %2</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Enter shows a key frame, Delete removes it, Alt with an arrow moves it</source>
        <translation>Eingabe zeigt ein Schlüsselbild, Entf entfernt es, Alt mit einem Pfeil verschiebt es</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>&amp;Add View</source>
        <translation>Ansicht hin&amp;zufügen</translation>
    </message>
    <message>
        <source>Add the current view as the next key frame</source>
        <translation>Die jetzige Ansicht als nächstes Schlüsselbild hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Replace this key frame with the current view</source>
        <translation>Dieses Schlüsselbild durch die jetzige Ansicht ersetzen</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>Zei&amp;gen</translation>
    </message>
    <message>
        <source>Show this key frame (Enter)</source>
        <translation>Dieses Schlüsselbild zeigen (Eingabe)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>E&amp;ntfernen</translation>
    </message>
    <message>
        <source>Remove this key frame (Delete)</source>
        <translation>Dieses Schlüsselbild entfernen (Entf)</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>&amp;Früher</translation>
    </message>
    <message>
        <source>Swap with the previous key frame (Alt+Up)</source>
        <translation>Mit dem vorigen Schlüsselbild tauschen (Alt+Pfeil auf)</translation>
    </message>
    <message>
        <source>La&amp;ter</source>
        <translation>S&amp;päter</translation>
    </message>
    <message>
        <source>Swap with the next key frame (Alt+Down)</source>
        <translation>Mit dem nächsten Schlüsselbild tauschen (Alt+Pfeil ab)</translation>
    </message>
    <message>
        <source>Show Key Frame</source>
        <translation>Schlüsselbild zeigen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Azimuth and elevation, distance in the units of the data, accuracy</source>
        <translation>Azimut und Höhe, Abstand in den Einheiten der Daten, Genauigkeit</translation>
    </message>
</context>
<context>
    <name>tetra::Leaving</name>
    <message>
        <source>It can continue in the background.</source>
        <translation>Das kann im Hintergrund weitergehen.</translation>
    </message>
    <message>
        <source>If you stop now, you can keep what is finished as %1, a model of lower accuracy.</source>
        <translation>Wenn Sie jetzt anhalten, können Sie das Fertige als %1 behalten, ein Modell geringerer Genauigkeit.</translation>
    </message>
    <message>
        <source>Nothing can be kept yet.</source>
        <translation>Behalten werden kann davon noch nichts.</translation>
    </message>
    <message>
        <source>Build in Progress</source>
        <translation>Modell im Bau</translation>
    </message>
    <message>
        <source>The model of %1 is still being built.</source>
        <translation>Das Modell von %1 wird noch gebaut.</translation>
    </message>
    <message>
        <source>&amp;Continue Building</source>
        <translation>&amp;Weiterbauen</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>Anhalten und behal&amp;ten</translation>
    </message>
    <message>
        <source>&amp;Discard Build</source>
        <translation>&amp;Bau verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>If you stop it, nothing is kept.</source>
        <translation>Wenn Sie ihn anhalten, bleibt nichts davon.</translation>
    </message>
    <message>
        <source>Film in Progress</source>
        <translation>Film in Arbeit</translation>
    </message>
    <message>
        <source>The film %1 is still being written.</source>
        <translation>Der Film %1 wird noch geschrieben.</translation>
    </message>
    <message>
        <source>&amp;Continue Writing</source>
        <translation>&amp;Weiterschreiben</translation>
    </message>
    <message>
        <source>&amp;Discard Film</source>
        <translation>&amp;Film verwerfen</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The session %1 has unsaved changes.</source>
        <translation>Die Sitzung %1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you do not save them.</source>
        <translation>Ihre Änderungen gehen verloren, wenn Sie sie nicht speichern.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Es wird gespeichert</translation>
    </message>
    <message>
        <source>A file is still being saved.</source>
        <translation>Eine Datei wird noch gespeichert.</translation>
    </message>
    <message>
        <source>TAn will quit when this is done.</source>
        <translation>TAn wird beendet, sobald das getan ist.</translation>
    </message>
    <message>
        <source>&amp;Do Not Quit</source>
        <translation>&amp;Nicht beenden</translation>
    </message>
    <message>
        <source>&amp;Quit Without Saving</source>
        <translation>Ohne Speichern &amp;beenden</translation>
    </message>
    <message>
        <source>%1 % done, about %2 left.</source>
        <translation>%1 % fertig, noch etwa %2.</translation>
    </message>
    <message>
        <source>%1 % done.</source>
        <translation>%1 % fertig.</translation>
    </message>
    <message>
        <source>TAn will continue when this is done.</source>
        <translation>TAn fährt fort, sobald das getan ist.</translation>
    </message>
    <message>
        <source>&amp;Continue Without Saving</source>
        <translation>Ohne Speichern &amp;fortfahren</translation>
    </message>
    <message>
        <source>You can resume it when you open these data again.</source>
        <translation>Sie können ihn fortsetzen, wenn Sie diese Daten wieder öffnen.</translation>
    </message>
    <message>
        <source>Quit and &amp;Resume Later</source>
        <translation>Beenden und &amp;später fortsetzen</translation>
    </message>
    <message>
        <source>Stop and Keep</source>
        <translation>Anhalten und behalten</translation>
    </message>
    <message>
        <source>Stop the build of %1 and keep what is finished?</source>
        <translation>Den Bau von %1 anhalten und das Fertige behalten?</translation>
    </message>
    <message>
        <source>If you stop now, you can keep what is finished as a separate model, named after its error. The finished model %1 is not changed.</source>
        <translation>Wenn Sie jetzt anhalten, können Sie behalten, was fertig ist: als eigenes Modell, das nach seinem Fehler benannt ist. Das fertige Modell %1 bleibt, wie es ist.</translation>
    </message>
</context>
<context>
    <name>tetra::LensInputs</name>
    <message>
        <source>Lens over the picture</source>
        <translation>Lupe über dem Bild</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>No lens</source>
        <translation>Keine Lupe</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>A round lens with its own error (L). Drag it; turn the wheel over it to change the magnification.</source>
        <translation>Eine runde Lupe mit eigenem Fehler (L). Zum Verschieben ziehen; das Mausrad über ihr ändert die Vergrößerung.</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>A square lens, with its own error</source>
        <translation>Eine quadratische Lupe mit eigenem Fehler</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>How much larger the lens shows what is under its centre</source>
        <translation>Wievielmal größer die Lupe zeigt, was unter ihrer Mitte liegt</translation>
    </message>
    <message>
        <source>Size of the lens</source>
        <translation>Größe der Lupe</translation>
    </message>
    <message>
        <source>Half the width of the lens, in percent of the picture&apos;s shorter side</source>
        <translation>Halbe Breite der Lupe, in Prozent der kürzeren Bildseite</translation>
    </message>
    <message>
        <source>Error in the lens</source>
        <translation>Fehler in der Lupe</translation>
    </message>
    <message>
        <source>Error of the mesh in the lens, in percent of the value range; it is never coarser than the mesh of the picture</source>
        <translation>Fehler des Netzes in der Lupe, in Prozent des Wertebereichs; es ist nie gröber als das Netz des Bildes</translation>
    </message>
    <message>
        <source>Magnificati&amp;on</source>
        <translation>&amp;Vergrößerung</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Gr&amp;öße</translation>
    </message>
    <message>
        <source>E&amp;rror inside</source>
        <translation>Fehler inne&amp;rhalb</translation>
    </message>
</context>
<context>
    <name>tetra::LensTool</name>
    <message>
        <source>Lens</source>
        <translation>Lupe</translation>
    </message>
    <message>
        <source>Enlarged %1 times</source>
        <translation>%1-fach vergrößert</translation>
    </message>
</context>
<context>
    <name>tetra::LostOffers</name>
    <message>
        <source>Sessions to restore</source>
        <translation>Sitzungen zum Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Open the model with its view restored. The saved view is kept until that has succeeded.</source>
        <translation>Öffnet das Modell in seiner letzten Ansicht. Die gesicherte Ansicht bleibt, bis das gelungen ist.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Discard the saved view (the model file is kept)</source>
        <translation>Verwirft die gesicherte Ansicht (die Modelldatei bleibt)</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>%1 verwerfen</translation>
    </message>
</context>
<context>
    <name>tetra::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Only one file can be open at a time; of the files dropped, %1 was opened.</source>
        <translation>Es kann nur eine Datei zugleich offen sein; von den abgelegten wurde %1 geöffnet.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>TAn</source>
        <translation>TAn</translation>
    </message>
    <message>
        <source>Dataset loaded. Choose options on the left and press Build to view it.</source>
        <translation>Der Datensatz ist geladen. Wählen Sie links die Optionen und drücken Sie „Bauen“, um ihn anzusehen.</translation>
    </message>
    <message>
        <source>About TAn</source>
        <translation>Über TAn</translation>
    </message>
    <message>
        <source>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: multiresolution volume data with a known error.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: Volumendaten in vielen Auflösungen mit bekanntem Fehler.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Wird gespeichert</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>Drawing the film</source>
        <translation>Der Film wird gezeichnet</translation>
    </message>
    <message>
        <source>Picture copied, %1 × %2 pixels</source>
        <translation>Bild kopiert, %1 × %2 Pixel</translation>
    </message>
    <message>
        <source>Drawing the picture, %1 more waiting</source>
        <translation>Das Bild wird gezeichnet, %1 weitere warten</translation>
    </message>
    <message>
        <source>Reset View</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>The model %1 has been built.</source>
        <translation>Das Modell %1 ist fertig gebaut.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>%1[*] – TAn</source>
        <translation>%1[*] – TAn</translation>
    </message>
    <message>
        <source>Its model is being built. The panel on the left shows the progress.</source>
        <translation>Sein Modell wird gebaut. Das Feld links zeigt den Fortschritt.</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Das Beispiel wird erzeugt</translation>
    </message>
    <message>
        <source>%1 has not been built yet. The picture still shows %2.</source>
        <translation>%1 ist noch nicht gebaut. Das Bild zeigt noch %2.</translation>
    </message>
    <message>
        <source>Save Mesh</source>
        <translation>Netz speichern</translation>
    </message>
    <message>
        <source>Save Surfaces</source>
        <translation>Flächen speichern</translation>
    </message>
    <message>
        <source>The picture does not show the current settings, which could not be drawn.</source>
        <translation>Das Bild zeigt nicht die jetzigen Einstellungen: Sie konnten nicht gezeichnet werden.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Showing %L1 of %L2 vertices, more are on the way</source>
        <translation>Zeigt %L1 von %L2 Knoten, weitere kommen</translation>
    </message>
    <message>
        <source>%1 is shown with %L2 of its %L3 vertices: %4 of %5 were downloaded.</source>
        <translation>%1 wird mit %L2 seiner %L3 Knoten gezeigt: %4 von %5 wurden geholt.</translation>
    </message>
    <message>
        <source>&amp;Fetch All</source>
        <translation>Alles &amp;holen</translation>
    </message>
    <message>
        <source>Saved %1: %2 instead of %3</source>
        <translation>%1 gespeichert: %2 statt %3</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Packen</translation>
    </message>
    <message>
        <source>Save Packed Model</source>
        <translation>Gepacktes Modell speichern</translation>
    </message>
    <message>
        <source>Packed models (*.tan)</source>
        <translation>Gepackte Modelle (*.tan)</translation>
    </message>
    <message>
        <source>Apply Look From</source>
        <translation>Aussehen übernehmen von</translation>
    </message>
    <message>
        <source>Sessions, and pictures saved by TAn (*.tansession *.png)</source>
        <translation>Sitzungen und Bilder mit ihren Sitzungen (*.tansession *.png)</translation>
    </message>
    <message>
        <source>What was finished has been kept as %1. The model %2 is unchanged.</source>
        <translation>Das Fertige ist als %1 behalten. Das Modell %2 ist, wie es war.</translation>
    </message>
    <message>
        <source>%1 % shown, more is on the way</source>
        <translation>%1 % gezeigt, mehr kommt</translation>
    </message>
    <message>
        <source>Saved %1. %2</source>
        <translation>%1 gespeichert. %2</translation>
    </message>
    <message>
        <source>Save Solids</source>
        <translation>Körper speichern</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>Added bookmark %1</source>
        <translation>Lesezeichen %1 hinzugefügt</translation>
    </message>
    <message>
        <source>The file does not say which way is up; Ctrl+U turns the model upside down</source>
        <translation>Die Datei sagt nicht, wo oben ist; Strg+U stellt das Modell auf den Kopf</translation>
    </message>
</context>
<context>
    <name>tetra::Message</name>
    <message>
        <source>The folder &apos;%1&apos; does not exist: create it or choose another.</source>
        <translation>Den Ordner „%1“ gibt es nicht: Legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a folder: choose another.</source>
        <translation>„%1“ ist kein Ordner: Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Name a file in it.</source>
        <translation>Nennen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>Choose another folder, or change the permissions of this one.</source>
        <translation>Wählen Sie einen anderen Ordner, oder ändern Sie die Rechte von diesem.</translation>
    </message>
    <message>
        <source>Choose a folder on a disk that can be written.</source>
        <translation>Wählen Sie einen Ordner auf einem beschreibbaren Datenträger.</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Wählen Sie einen kürzeren Namen.</translation>
    </message>
    <message>
        <source>Choose another folder or disk.</source>
        <translation>Wählen Sie einen anderen Ordner oder Datenträger.</translation>
    </message>
    <message>
        <source>Not valid JSON: %1 (%2).</source>
        <translation>Kein gültiges JSON: %1 (%2).</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>The runs of the blocks do not fit together. Start the build again.</source>
        <translation>Die Läufe der Blöcke passen nicht zusammen. Starten Sie den Bau noch einmal.</translation>
    </message>
    <message>
        <source>Extracting the mesh</source>
        <translation>Netz wird entnommen</translation>
    </message>
    <message>
        <source>Selecting tetrahedra from the mesh</source>
        <translation>Auswahl aus dem Netz</translation>
    </message>
    <message>
        <source>The mesh has too many tetrahedra for its boundary to be shown. Lower the accuracy of the mesh.</source>
        <translation>Das Netz hat zu viele Tetraeder, um seine Berandung zu zeigen. Verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>the text</source>
        <translation>der Text</translation>
    </message>
    <message>
        <source>The transfer function cannot be read: %1 (%2).</source>
        <translation>Die Transferfunktion kann nicht gelesen werden: %1 (%2).</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>normalised</source>
        <translation>normiert</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Aufsatz</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>For curvilinear data: &apos;normalised&apos; takes the point that is farthest off in error or warping; &apos;paper&apos; compares the two in the units of the data, as the paper did, for comparison with it. Both keep cells from turning inside out.</source>
        <translation>Bei krummlinigen Daten: „normiert“ nimmt den Punkt, der in Fehler oder Verwerfung am weitesten daneben liegt; „Aufsatz“ vergleicht beide in den Einheiten der Daten, wie der Aufsatz, zum Vergleich mit ihm. Beide bewahren Zellen vor dem Umklappen.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>loaded</source>
        <translation>geladen</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>abgeschaltet</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; %2.</source>
        <translation>Das Feld „%1“ %2.</translation>
    </message>
    <message>
        <source>&apos;%1: %2&apos; in its header %3</source>
        <translation>„%1: %2“ in ihrem Kopf %3</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, and its header requires %3. It is cut short: copy the file again.</source>
        <translation>%1 hat %2 Bytes, und ihr Kopf verlangt %3. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>has no %1 in line %2, but &apos;%3&apos;. It is damaged, or of another version of the format: export it again.</source>
        <translation>enthält in Zeile %2 nicht das Erwartete (%1), sondern „%3“. Sie ist beschädigt oder von einer anderen Version des Formats: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>has no %1 in line %2, but &apos;%3&apos;. It is damaged: export it again.</source>
        <translation>enthält in Zeile %2 nicht das Erwartete (%1), sondern „%3“. Sie ist beschädigt: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>has no %1. It is cut short or damaged.</source>
        <translation>enthält eine Angabe nicht (%1). Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>has a part without a number, in the line &apos;%1&apos;. It is damaged.</source>
        <translation>hat einen Teil ohne Nummer, in der Zeile „%1“. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>number of values</source>
        <translation>Anzahl der Werte</translation>
    </message>
    <message>
        <source>place of a value</source>
        <translation>Platz eines Wertes</translation>
    </message>
    <message>
        <source>It could not be read.</source>
        <translation>Die Datei konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The session cannot be read: %1</source>
        <translation>Die Sitzung kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2. %3</source>
        <translation>„%1“ kann nicht geschrieben werden: %2. %3</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>Es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>Die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Choose another name, or make it writable.</source>
        <translation>Wählen Sie einen anderen Namen, oder machen Sie sie beschreibbar.</translation>
    </message>
    <message>
        <source>it does not name a file</source>
        <translation>Das benennt keine Datei</translation>
    </message>
    <message>
        <source>Name a file.</source>
        <translation>Nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos;. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um „%1“ zu schreiben. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Not enough memory to build a model. Close other programs, or take fewer samples.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um ein Modell zu bauen. Schließen Sie andere Programme, oder nehmen Sie weniger Abtastwerte.</translation>
    </message>
    <message>
        <source>there is text after the end of the value</source>
        <translation>nach dem Ende des Wertes steht noch etwas</translation>
    </message>
    <message>
        <source>a byte that is not valid UTF-8</source>
        <translation>ein Byte, das nicht zu UTF-8-Text gehört</translation>
    </message>
    <message>
        <source>too many levels of nesting</source>
        <translation>zu viele Ebenen</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;]&apos;</source>
        <translation>„,“ oder „]“ erwartet</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; appears twice</source>
        <translation>das Element „%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>expected &apos;:&apos;</source>
        <translation>„:“ erwartet</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;}&apos;</source>
        <translation>„,“ oder „}“ erwartet</translation>
    </message>
    <message>
        <source>expected a value</source>
        <translation>ein Wert wird erwartet</translation>
    </message>
    <message>
        <source>expected four hexadecimal digits</source>
        <translation>vier hexadezimale Ziffern werden erwartet</translation>
    </message>
    <message>
        <source>unknown escape</source>
        <translation>unbekannte Escape-Folge</translation>
    </message>
    <message>
        <source>half of a surrogate pair</source>
        <translation>die Hälfte eines Ersatzzeichenpaars</translation>
    </message>
    <message>
        <source>expected a name in quotes</source>
        <translation>ein Name in Anführungszeichen wird erwartet</translation>
    </message>
    <message>
        <source>a control character inside quotes</source>
        <translation>ein Steuerzeichen in Anführungszeichen</translation>
    </message>
    <message>
        <source>the closing quote is missing</source>
        <translation>das schließende Anführungszeichen fehlt</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: %2</source>
        <translation>„%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. Check its name and folder.</source>
        <translation>%1. Prüfen Sie Name und Ordner.</translation>
    </message>
    <message>
        <source>%1. Ask its owner for permission to read it.</source>
        <translation>%1. Bitten Sie den Eigentümer um das Recht, sie zu lesen.</translation>
    </message>
    <message>
        <source>it is a folder. Name a file in it.</source>
        <translation>Das ist ein Ordner. Nennen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>it is not a regular file. Copy its content into one first.</source>
        <translation>Das ist keine gewöhnliche Datei. Kopieren Sie den Inhalt erst in eine.</translation>
    </message>
    <message>
        <source>Cannot open &apos;%1&apos;: too many files are open. Close some of them.</source>
        <translation>„%1“ kann nicht geöffnet werden: Zu viele Dateien sind offen. Schließen Sie einige.</translation>
    </message>
    <message>
        <source>Not enough memory: %1 MiB of address space for %2 were refused (%3). Close other programs, or raise the memory limit.</source>
        <translation>Der Arbeitsspeicher reicht nicht: %1 MiB Adressraum für %2 wurden verweigert (%3). Schließen Sie andere Programme, oder heben Sie die Speichergrenze an.</translation>
    </message>
    <message>
        <source>Cannot make a temporary file in &apos;%1&apos;: %2. %3</source>
        <translation>In „%1“ kann keine Zwischendatei angelegt werden: %2. %3</translation>
    </message>
    <message>
        <source>A temporary file in &apos;%1&apos; cannot be used: %2. %3</source>
        <translation>Eine Zwischendatei in „%1“ kann nicht benutzt werden: %2. %3</translation>
    </message>
    <message>
        <source>This machine cannot start any more threads now. Close other programs, or raise the limit (ulimit).</source>
        <translation>Dieser Rechner kann zurzeit keine weiteren Threads starten. Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>This machine does not have enough memory for this. Close other programs, or raise the limit (ulimit).</source>
        <translation>Der Speicher dieses Rechners reicht dafür nicht aus. Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Nicht erlaubt</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>Nicht genug Speicher</translation>
    </message>
    <message>
        <source>Resource temporarily unavailable</source>
        <translation>Im Augenblick nicht verfügbar</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät oder Datei in Benutzung</translation>
    </message>
    <message>
        <source>Invalid cross-device link</source>
        <translation>Auf einem anderen Datenträger</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Kein Ordner</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Das ist ein Ordner</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>Ungültiges Argument</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Too many open files in system</source>
        <translation>Zu viele offene Dateien im ganzen System</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>Zu viele symbolische Verweise hintereinander</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent überschritten</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Die Datei gibt es auf dem Server nicht mehr</translation>
    </message>
    <message>
        <source>system error %1</source>
        <translation>Systemfehler %1</translation>
    </message>
    <message>
        <source>Choose a disk that allows larger files, or raise the limit (ulimit -f).</source>
        <translation>Wählen Sie einen Datenträger, der größere Dateien erlaubt, oder heben Sie die Grenze an (ulimit -f).</translation>
    </message>
    <message>
        <source>Free some space or choose another disk.</source>
        <translation>Schaffen Sie Platz, oder wählen Sie einen anderen Datenträger.</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit (ulimit).</source>
        <translation>Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>Cannot work in &apos;%1&apos;: %2. %3</source>
        <translation>In „%1“ kann nicht gearbeitet werden: %2. %3</translation>
    </message>
    <message>
        <source>Choose another folder for the model.</source>
        <translation>Wählen Sie einen anderen Ordner für das Modell.</translation>
    </message>
    <message>
        <source>another program is building this model</source>
        <translation>Ein anderes Programm baut dieses Modell gerade</translation>
    </message>
    <message>
        <source>Wait for it, or give the model another name.</source>
        <translation>Warten Sie darauf, oder geben Sie dem Modell einen anderen Namen.</translation>
    </message>
    <message>
        <source>it is used for something else</source>
        <translation>er enthält etwas anderes</translation>
    </message>
    <message>
        <source>Give the model another name, or move that folder away.</source>
        <translation>Geben Sie dem Modell einen anderen Namen, oder schieben Sie jenen Ordner beiseite.</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>er ist ein Verweis</translation>
    </message>
    <message>
        <source>Give the model another name, or move that link away.</source>
        <translation>Geben Sie dem Modell einen anderen Namen, oder schieben Sie jenen Verweis beiseite.</translation>
    </message>
    <message>
        <source>A mesh of %1 points and %2 tetrahedra is too large to be decimated: the limits are %3 points and %4 tetrahedra. Take a region of it or fewer samples.</source>
        <translation>Ein Netz aus %1 Punkten und %2 Tetraedern ist zu groß, um vergröbert zu werden: Höchstens %3 Punkte und %4 Tetraeder sind möglich. Nehmen Sie einen Bereich davon oder weniger Abtastwerte.</translation>
    </message>
    <message>
        <source>Decimation of %1 points and %2 tetrahedra takes about %3 of memory, and this machine has %4. Take a region of it or fewer samples, or, if it is a lattice or grid, refine it instead.</source>
        <translation>Die Vergröberung von %1 Punkten und %2 Tetraedern braucht etwa %3 Arbeitsspeicher, und dieser Rechner hat %4. Nehmen Sie einen Bereich davon oder weniger Abtastwerte, oder verfeinern Sie stattdessen, wenn es ein Gitter ist.</translation>
    </message>
    <message>
        <source>Not enough memory to decimate &apos;%1&apos;. Take a region of it or fewer samples.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um „%1“ zu vergröbern. Nehmen Sie einen Bereich davon oder weniger Abtastwerte.</translation>
    </message>
    <message>
        <source>The finest error (%1 %) is larger than the error at which to stop (%2 %). Choose a smaller finest error, or 0 to keep everything.</source>
        <translation>Der feinste Fehler (%1 %) ist größer als der Fehler, bei dem aufgehört wird (%2 %). Wählen Sie einen kleineren feinsten Fehler, oder 0, um alles zu behalten.</translation>
    </message>
    <message>
        <source>A tetrahedral mesh needs a cell: two points or more along each axis.</source>
        <translation>Ein Tetraedernetz braucht eine Zelle: zwei Punkte oder mehr entlang jeder Achse.</translation>
    </message>
    <message>
        <source>model about %1, work files %2</source>
        <translation>Modell etwa %1, Arbeitsdateien %2</translation>
    </message>
    <message>
        <source>The build needs about %1 on the disk of &apos;%2&apos; (%3), and %4 are free. Free some space, choose another disk or a larger error.</source>
        <translation>Der Bau braucht etwa %1 auf dem Datenträger von „%2“ (%3), und %4 sind frei. Schaffen Sie Platz, wählen Sie einen anderen Datenträger oder einen größeren Fehler.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2.</source>
        <translation>„%1“ kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists and is not a TAn model, so it is not overwritten. Give the model another name, or remove that file first.</source>
        <translation>„%1“ gibt es und ist kein TAn-Modell, wird also nicht überschrieben. Geben Sie dem Modell einen anderen Namen, oder entfernen Sie die Datei zuerst.</translation>
    </message>
    <message>
        <source>%1 is not a percentage at which to stop. Give one from 0 to 100.</source>
        <translation>%1 ist kein Prozentsatz, bei dem aufgehört werden kann. Geben Sie einen von 0 bis 100 an.</translation>
    </message>
    <message>
        <source>The build</source>
        <translation>Der Bau</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>This target cannot be built in blocks. Set the block to &quot;none&quot;.</source>
        <translation>In dieses Ziel kann nicht in Blöcken gebaut werden. Setzen Sie den Block auf „keine“.</translation>
    </message>
    <message>
        <source>Point %1 of &apos;%2&apos; has a position or a value that is not a finite number. Leave it out.</source>
        <translation>Punkt %1 von „%2“ hat eine Position oder einen Wert, der keine endliche Zahl ist. Lassen Sie ihn weg.</translation>
    </message>
    <message>
        <source>A lattice of %1 points is too large: a model holds at most 4294967296. Crop or subsample it.</source>
        <translation>Ein regelmäßiges Gitter aus %1 Punkten ist zu groß: Ein Modell fasst höchstens 4294967296. Schneiden Sie es zu, oder nehmen Sie nur jeden n-ten Punkt.</translation>
    </message>
    <message>
        <source>A tetrahedral mesh needs four points or more.</source>
        <translation>Ein Tetraedernetz braucht vier Punkte oder mehr.</translation>
    </message>
    <message>
        <source>Blocks of %1 cells cut this dataset into %2 pieces; the limit is %3. Choose larger blocks.</source>
        <translation>Blöcke von %1 Zellen zerlegen diesen Datensatz in %2 Stücke; höchstens %3 sind möglich. Wählen Sie größere Blöcke.</translation>
    </message>
    <message>
        <source>The values belong to cells: each point got the mean of the cells around it.</source>
        <translation>Die Werte gehören zu Zellen: Jeder Punkt bekam das Mittel der Zellen um ihn.</translation>
    </message>
    <message>
        <source>1 cell is a vertex, line or polygon without volume and not part of the mesh.</source>
        <translation>1 Zelle ist ein Punkt, eine Linie oder ein Vieleck ohne Volumen und gehört nicht zum Netz.</translation>
    </message>
    <message>
        <source>%1 cells are vertices, lines or polygons without volume and not part of the mesh.</source>
        <translation>%1 Zellen sind Punkte, Linien oder Vielecke ohne Volumen und gehören nicht zum Netz.</translation>
    </message>
    <message>
        <source>1 cell is blanked out in the file: a hole.</source>
        <translation>1 Zelle ist in der Datei ausgeblendet: ein Loch.</translation>
    </message>
    <message>
        <source>%1 cells are blanked out in the file: holes.</source>
        <translation>%1 Zellen sind in der Datei ausgeblendet: Löcher.</translation>
    </message>
    <message>
        <source>1 cell has a value that is not finite and became a hole.</source>
        <translation>1 Zelle hat einen Wert, der nicht endlich ist, und wurde ein Loch.</translation>
    </message>
    <message>
        <source>%1 cells have a value that is not finite and became holes.</source>
        <translation>%1 Zellen haben einen Wert, der nicht endlich ist, und wurden zu Löchern.</translation>
    </message>
    <message>
        <source>1 cell uses a corner twice, has no volume and was left out.</source>
        <translation>1 Zelle nennt eine Ecke zweimal, hat kein Volumen und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 cells use a corner twice, have no volume and were left out.</source>
        <translation>%1 Zellen nennen eine Ecke zweimal, haben kein Volumen und wurden weggelassen.</translation>
    </message>
    <message>
        <source>1 cell without volume was left out.</source>
        <translation>1 Zelle ohne Volumen wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 cells without volume were left out.</source>
        <translation>%1 Zellen ohne Volumen wurden weggelassen.</translation>
    </message>
    <message>
        <source>All cells had inverted orientation and were corrected.</source>
        <translation>Alle Zellen hatten die umgekehrte Orientierung und wurden korrigiert.</translation>
    </message>
    <message>
        <source>1 cell had inverted orientation and was corrected.</source>
        <translation>1 Zelle hatte die umgekehrte Orientierung und wurde korrigiert.</translation>
    </message>
    <message>
        <source>%1 cells had inverted orientation and were corrected.</source>
        <translation>%1 Zellen hatten die umgekehrte Orientierung und wurden korrigiert.</translation>
    </message>
    <message>
        <source>1 point at the same place as another was merged with it.</source>
        <translation>1 Punkt am Ort eines anderen wurde mit ihm vereinigt.</translation>
    </message>
    <message>
        <source>%1 points at the same place as another were merged with it.</source>
        <translation>%1 Punkte am Ort eines anderen wurden mit ihm vereinigt.</translation>
    </message>
    <message>
        <source>1 place had several different values and got their mean.</source>
        <translation>1 Ort hatte verschiedene Werte und bekam ihr Mittel.</translation>
    </message>
    <message>
        <source>%1 places had several different values and got their mean.</source>
        <translation>%1 Orte hatten verschiedene Werte und bekamen ihr Mittel.</translation>
    </message>
    <message>
        <source>1 node in the middle of an edge or face was left out: not all cells there have it, or the cells bend too much.</source>
        <translation>1 Knoten in der Mitte einer Kante oder Seite wurde weggelassen: Nicht alle Zellen dort haben ihn, oder Zellen biegen sich zu sehr.</translation>
    </message>
    <message>
        <source>%1 nodes in the middle of edges and faces were left out: not all cells there have them, or the cells bend too much.</source>
        <translation>%1 Knoten in der Mitte von Kanten und Seiten wurden weggelassen: Nicht alle Zellen dort haben sie, oder Zellen biegen sich zu sehr.</translation>
    </message>
    <message>
        <source>1 cell was cut along other diagonals, because its faces are not flat.</source>
        <translation>1 Zelle wurde entlang anderer Diagonalen zerlegt, weil ihre Seiten nicht eben sind.</translation>
    </message>
    <message>
        <source>%1 cells were cut along other diagonals, because their faces are not flat.</source>
        <translation>%1 Zellen wurden entlang anderer Diagonalen zerlegt, weil ihre Seiten nicht eben sind.</translation>
    </message>
    <message>
        <source>1 cell was left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>1 Zelle wurde weggelassen: zu verzogen, um ohne neuen Punkt in Tetraeder zerlegt zu werden.</translation>
    </message>
    <message>
        <source>%1 cells were left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>%1 Zellen wurden weggelassen: zu verzogen, um ohne neuen Punkt in Tetraeder zerlegt zu werden.</translation>
    </message>
    <message>
        <source>1 tetrahedron appeared twice.</source>
        <translation>1 Tetraeder war doppelt da.</translation>
    </message>
    <message>
        <source>%1 tetrahedra appeared twice.</source>
        <translation>%1 Tetraeder waren doppelt da.</translation>
    </message>
    <message>
        <source>The mesh has no cells or no points.</source>
        <translation>Das Netz hat keine Zellen oder keine Punkte.</translation>
    </message>
    <message>
        <source>The mesh has %1 points; at most 4294967294 can be numbered. Take a part of it.</source>
        <translation>Das Netz hat %1 Punkte; höchstens 4294967294 können nummeriert werden. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>The cells&apos; lists of corners are inconsistent: their offsets do not rise from 0 to the number of corners.</source>
        <translation>Die Eckenlisten der Zellen passen nicht zusammen: Ihre Anfänge steigen nicht von 0 bis zur Anzahl der Ecken.</translation>
    </message>
    <message>
        <source>The mesh has %1 cells, but blanking flags for %2.</source>
        <translation>Das Netz hat %1 Zellen, sagt aber von %2, ob sie ausgeblendet sind.</translation>
    </message>
    <message>
        <source>The mesh has %1 cells, but %2 values.</source>
        <translation>Das Netz hat %1 Zellen, aber %2 Werte.</translation>
    </message>
    <message>
        <source>The mesh has %1 points, but %2 values.</source>
        <translation>Das Netz hat %1 Punkte, aber %2 Werte.</translation>
    </message>
    <message>
        <source>Cells refer to points that do not exist (%1 in all, the first is cell %2). The mesh has %3 points: the file is damaged.</source>
        <translation>Zellen nennen Punkte, die es nicht gibt (%1 insgesamt, die erste ist Zelle %2). Das Netz hat %3 Punkte: Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>Cells do not have the number of corners of their shape (%1 in all, the first is cell %2). The file is damaged.</source>
        <translation>Zellen haben eine andere Zahl von Ecken als ihre Form (%1 insgesamt, die erste ist Zelle %2). Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>No cell of the mesh has a volume and finite values: nothing is left.</source>
        <translation>Keine Zelle des Netzes hat ein Volumen und endliche Werte: Es bleibt nichts übrig.</translation>
    </message>
    <message>
        <source>Cutting the cells</source>
        <translation>Zerlegen der Zellen</translation>
    </message>
    <message>
        <source>The cells yield more than %1 tetrahedra. Take a part of the mesh.</source>
        <translation>Die Zellen ergeben mehr als %1 Tetraeder. Nehmen Sie einen Teil des Netzes.</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>Prüfen des Netzes</translation>
    </message>
    <message>
        <source>The mesh has %1. Repair the mesh in the program that made it.</source>
        <translation>Das Netz hat %1. Reparieren Sie das Netz in dem Programm, das es erzeugt hat.</translation>
    </message>
    <message>
        <source>1 tetrahedron that is flat or inverted, one at %1</source>
        <translation>1 flaches oder invertiertes Tetraeder, bei %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that are flat or inverted, one at %2</source>
        <translation>%1 flache oder invertierte Tetraeder, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 tetrahedron at a face that three or more share, one at %1</source>
        <translation>1 Tetraeder an einer Seite, die drei oder mehr gemeinsam haben, bei %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra at faces that three or more share, one at %2</source>
        <translation>%1 Tetraeder an Seiten, die drei oder mehr gemeinsam haben, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>1 tetrahedron that overlaps its neighbour, one at %1</source>
        <translation>1 Tetraeder, das seinen Nachbarn überlappt, bei %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that overlap a neighbour on the same side of a face, one at %2</source>
        <translation>%1 Tetraeder, die einen Nachbarn auf derselben Seite überlappen, zum Beispiel bei %2</translation>
    </message>
    <message>
        <source>The dataset is not an irregular mesh: it has no positions or no tetrahedra.</source>
        <translation>Der Datensatz ist kein unregelmäßiges Netz: Er hat keine Positionen oder keine Tetraeder.</translation>
    </message>
    <message>
        <source>A tetrahedron of the mesh refers to point %1 of %2.</source>
        <translation>Ein Tetraeder des Netzes nennt Punkt %1 von %2.</translation>
    </message>
    <message>
        <source>The mesh has %1 points that no tetrahedron uses.</source>
        <translation>Das Netz hat %1 Punkte, die kein Tetraeder benutzt.</translation>
    </message>
    <message>
        <source>The mesh has more than %1 tetrahedra. Take a part of it.</source>
        <translation>Das Netz hat mehr als %1 Tetraeder. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>No cell of the mesh has a volume: nothing is left.</source>
        <translation>Keine Zelle des Netzes hat ein Volumen: Es bleibt nichts übrig.</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh. Take a part of it.</source>
        <translation>Der Arbeitsspeicher reicht nicht für das Netz. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open, so that the result would be wrong. Open it again; if that fails, get or make the file again.</source>
        <translation>„%1“ wurde abgeschnitten oder geändert, während die Datei offen war, sodass falsch wäre, was daraus gemacht wurde. Öffnen Sie sie noch einmal; gelingt das nicht, holen oder erzeugen Sie sie neu.</translation>
    </message>
    <message>
        <source>it has %1 points. A volume needs at least 2 along each axis: stack several slices, or repeat the only one.</source>
        <translation>Sie hat %1 Punkte. Ein Volumen braucht mindestens 2 entlang jeder Achse: Fügen Sie mehrere Schichten zusammen, oder wiederholen Sie die eine.</translation>
    </message>
    <message>
        <source>it claims to have %1 points, more than any machine can hold. Its description is wrong: check the sizes.</source>
        <translation>Sie will %1 Punkte haben, mehr als irgendein Rechner fasst. Die Beschreibung ist falsch: Prüfen Sie die Größen.</translation>
    </message>
    <message>
        <source>its spacing is %1. The distance between neighbouring points must be a positive number along each axis.</source>
        <translation>Ihr Abstand ist %1. Der Abstand benachbarter Punkte muss entlang jeder Achse eine positive Zahl sein.</translation>
    </message>
    <message>
        <source>its origin %1 is so far away for the spacing %2 that neighbouring points coincide. Move the origin nearer to 0.</source>
        <translation>Ihr Ursprung %1 ist für den Abstand %2 so weit entfernt, dass benachbarte Punkte zusammenfallen. Rücken Sie den Ursprung näher an 0.</translation>
    </message>
    <message>
        <source>%1 of its %2 samples are NaN or infinite, the first at point (%3, %4, %5). Replace them with numbers first.</source>
        <translation>%1 der %2 Abtastwerte sind NaN oder unendlich, der erste bei Punkt (%3, %4, %5). Ersetzen Sie sie zuerst durch Zahlen.</translation>
    </message>
    <message>
        <source>point %1 has an invalid or extremely large position. Repair the file.</source>
        <translation>Die Position von Punkt %1 ist keine Zahl oder liegt weit jenseits dessen, womit gerechnet werden kann. Reparieren Sie die Datei.</translation>
    </message>
    <message>
        <source>%1 values are too large for single precision, or not numbers. Choose another array.</source>
        <translation>%1 Werte sind zu groß für einfache Genauigkeit oder keine Zahlen. Wählen Sie ein anderes Feld.</translation>
    </message>
    <message>
        <source>all its points lie in a plane, or so close to one that no cell has a volume. TAn needs volumes.</source>
        <translation>Alle Punkte liegen in einer Ebene oder enger, sodass keine Zelle ein Volumen hat. TAn nimmt Volumen.</translation>
    </message>
    <message>
        <source>Cannot use &apos;%1&apos;: %2</source>
        <translation>„%1“ kann nicht benutzt werden: %2</translation>
    </message>
    <message>
        <source>it has %1 values for %2 points. Give one value for each point.</source>
        <translation>Er hat %1 Werte für %2 Punkte. Geben Sie jedem Punkt einen.</translation>
    </message>
    <message>
        <source>it has no points.</source>
        <translation>Er hat keine Punkte.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than 4294967295 points. Take a part of them.</source>
        <translation>„%1“ hat mehr als 4294967295 Punkte. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>A stride is a whole number of at least 1.</source>
        <translation>Eine Schrittweite ist eine ganze Zahl ab 1.</translation>
    </message>
    <message>
        <source>The part has %1 points along %2, and a volume needs at least two along each axis. Choose a larger region or a smaller stride.</source>
        <translation>Der Teil hat %1 Punkte entlang %2, und ein Volumen braucht mindestens zwei entlang jeder Achse. Nehmen Sie einen größeren Bereich oder eine kleinere Schrittweite.</translation>
    </message>
    <message>
        <source>No cell of the part has a volume. Choose another region or a smaller stride.</source>
        <translation>Keine Zelle des Teils hat ein Volumen. Nehmen Sie einen anderen Bereich oder eine kleinere Schrittweite.</translation>
    </message>
    <message>
        <source>Part of the data: %1 of the %2 points.</source>
        <translation>Ein Teil von %1 der %2 Punkte.</translation>
    </message>
    <message>
        <source>The region holds %1. Choose a larger one; &apos;bounds&apos; of &apos;tan info&apos; tells where the points lie.</source>
        <translation>Der Bereich enthält %1. Nehmen Sie einen größeren; „bounds“ von „tan info“ sagt, wo die Punkte liegen.</translation>
    </message>
    <message>
        <source>no whole tetrahedron</source>
        <translation>kein ganzes Tetraeder</translation>
    </message>
    <message>
        <source>1 tetrahedron inside the region was left out: it touches the others only at a vertex or an edge.</source>
        <translation>1 Tetraeder im Bereich wurde weggelassen: Es berührt die anderen nur an einem Knoten oder einer Kante.</translation>
    </message>
    <message>
        <source>%1 tetrahedra inside the region were left out: they touch the others only at a vertex or an edge.</source>
        <translation>%1 Tetraeder im Bereich wurden weggelassen: Sie berühren die anderen nur an einem Knoten oder einer Kante.</translation>
    </message>
    <message>
        <source>%1 points, and a volume needs four</source>
        <translation>%1 Punkte, und ein Volumen braucht vier</translation>
    </message>
    <message>
        <source>A stride is for points of a grid only. Choose a region.</source>
        <translation>Nur Punkte eines Gitters können mit einer Schrittweite genommen werden. Nehmen Sie einen Bereich.</translation>
    </message>
    <message>
        <source>Not enough memory for this part. Choose a smaller one.</source>
        <translation>Der Arbeitsspeicher reicht nicht für diesen Teil. Nehmen Sie einen kleineren.</translation>
    </message>
    <message>
        <source>The region &apos;%1&apos; %2</source>
        <translation>Der Bereich „%1“ %2</translation>
    </message>
    <message>
        <source>is not understood. Give six numbers separated by commas: the first corner&apos;s and the last one&apos;s, as in 0,0,0,31,31,15.</source>
        <translation>ist nicht zu verstehen. Geben Sie sechs Zahlen an, durch Kommas getrennt: die der ersten und die der letzten Ecke, wie in 0,0,0,31,31,15.</translation>
    </message>
    <message>
        <source>holds &apos;%1&apos;, which is not a number.</source>
        <translation>enthält „%1“, was keine Zahl ist.</translation>
    </message>
    <message>
        <source>ends before it begins. Give the smaller numbers first.</source>
        <translation>endet, bevor er beginnt. Geben Sie die kleineren Zahlen zuerst an.</translation>
    </message>
    <message>
        <source>The stride &apos;%1&apos; is not understood. Give one whole number of at least 1, or three separated by commas, as in 2,2,1.</source>
        <translation>Die Schrittweite „%1“ ist nicht zu verstehen. Geben Sie eine ganze Zahl ab 1 an, oder drei, durch Kommas getrennt, wie in 2,2,1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>There is no layer %1 along this axis.</source>
        <translation>Eine Schicht %1 gibt es entlang dieser Achse nicht.</translation>
    </message>
    <message>
        <source>The preview</source>
        <translation>Die Vorschau</translation>
    </message>
    <message>
        <source>Not enough memory: %1 samples of type %2 do not fit into the %3 MiB of this machine. Use a smaller part or a coarser version of the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht: %1 Abtastwerte vom Typ %2 passen nicht in die %3 MiB dieses Rechners. Nehmen Sie einen kleineren Teil oder eine gröbere Fassung der Daten.</translation>
    </message>
    <message>
        <source>the samples</source>
        <translation>die Abtastwerte</translation>
    </message>
    <message>
        <source>Not enough memory for the weights of %1 points. Build without weights, or close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht für die Gewichte von %1 Punkten. Bauen Sie ohne Gewichte, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Weighting the points</source>
        <translation>Punkte werden gewichtet</translation>
    </message>
    <message>
        <source>The weight &apos;%1&apos; cannot be used: %2.</source>
        <translation>Das Gewicht „%1“ ist nicht brauchbar: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>it has %1 numbers, and the form is %2</source>
        <translation>Es hat %1 Zahlen, und die Form ist %2</translation>
    </message>
    <message>
        <source>its reach is %1 and must be at least 0</source>
        <translation>Seine Reichweite ist %1 und muss mindestens 0 sein</translation>
    </message>
    <message>
        <source>its reach is %1 and must be above 0</source>
        <translation>Seine Reichweite ist %1 und muss größer als 0 sein</translation>
    </message>
    <message>
        <source>its floor is %1 and must be from %2 to 1</source>
        <translation>Sein Mindestwert ist %1 und muss von %2 bis 1 sein</translation>
    </message>
    <message>
        <source>a weight begins with &apos;point:&apos;, &apos;box:&apos; or &apos;value:&apos;</source>
        <translation>Ein Gewicht beginnt mit „point:“, „box:“ oder „value:“</translation>
    </message>
    <message>
        <source>its first corner must be the smaller one along every axis</source>
        <translation>Seine erste Ecke muss entlang jeder Achse die kleinere sein</translation>
    </message>
    <message>
        <source>The history has more than 4 billion tetrahedra. Decimate a part of the mesh.</source>
        <translation>Die Geschichte hat mehr als 4 Milliarden Tetraeder. Vergröbern Sie einen Teil des Netzes.</translation>
    </message>
    <message>
        <source>The decimation</source>
        <translation>Die Vergröberung</translation>
    </message>
    <message>
        <source>Writing the history</source>
        <translation>Geschichte wird geschrieben</translation>
    </message>
    <message>
        <source>Evaluating vertices</source>
        <translation>Die Knoten werden bewertet</translation>
    </message>
    <message>
        <source>Collapsing</source>
        <translation>Kanten werden kontrahiert</translation>
    </message>
    <message>
        <source>Collapsing in rounds</source>
        <translation>Kanten werden in Runden kontrahiert</translation>
    </message>
    <message>
        <source>The mesh cannot be decimated: %1</source>
        <translation>Das Netz kann nicht vergröbert werden: %1</translation>
    </message>
    <message>
        <source>Meshes of more than 4294967294 points or 1073741823 tetrahedra cannot be decimated. Take a part.</source>
        <translation>Netze aus mehr als 4294967294 Punkten oder 1073741823 Tetraedern können nicht vergröbert werden. Nehmen Sie einen Teil.</translation>
    </message>
    <message>
        <source>it has no tetrahedra.</source>
        <translation>Es hat keine Tetraeder.</translation>
    </message>
    <message>
        <source>it does not have one value, weight and position for each of its %1 points.</source>
        <translation>Es hat nicht für jeden seiner %1 Punkte einen Wert, ein Gewicht und einen Ort.</translation>
    </message>
    <message>
        <source>point %1 has no finite position.</source>
        <translation>Punkt %1 hat keinen endlichen Ort.</translation>
    </message>
    <message>
        <source>point %1 has no finite value.</source>
        <translation>Punkt %1 hat keinen endlichen Wert.</translation>
    </message>
    <message>
        <source>weights must be above 0 and at most 1.</source>
        <translation>Gewichte müssen über 0 liegen und höchstens 1 sein.</translation>
    </message>
    <message>
        <source>a tetrahedron has vertex %1, which does not exist.</source>
        <translation>Ein Tetraeder hat den Knoten %1, den es nicht gibt.</translation>
    </message>
    <message>
        <source>point %1 is in no tetrahedron. Leave it out.</source>
        <translation>Punkt %1 liegt in keinem Tetraeder. Lassen Sie ihn weg.</translation>
    </message>
    <message>
        <source>The weight of the warping must be a positive number.</source>
        <translation>Das Gewicht der Verwerfung muss eine positive Zahl sein.</translation>
    </message>
    <message>
        <source>The error at which to stop must not be negative.</source>
        <translation>Der Fehler, bei dem aufgehört wird, darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>Not enough memory to decimate this mesh. Close other programs, use a machine with more memory, or take a part of the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses Netz zu vergröbern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher oder einen Teil der Daten.</translation>
    </message>
    <message>
        <source>point %1 is not in the dataset</source>
        <translation>Punkt %1 ist nicht im Datensatz</translation>
    </message>
    <message>
        <source>the error before it is not a number of at least 0</source>
        <translation>der Fehler davor ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>The history has more than 4294967295 tetrahedra. Choose a larger error, or build in blocks.</source>
        <translation>Die Geschichte hat mehr als 4294967295 Tetraeder. Verlangen Sie einen größeren Fehler, oder bauen Sie in Blöcken.</translation>
    </message>
    <message>
        <source>a tetrahedron of its star has a site that comes after it</source>
        <translation>ein Tetraeder ihres Sterns hat eine Stützstelle, die nach ihr kommt</translation>
    </message>
    <message>
        <source>a tetrahedron of its star has a site twice</source>
        <translation>ein Tetraeder ihres Sterns hat eine Stützstelle zweimal</translation>
    </message>
    <message>
        <source>a tetrahedron of its star has an error or a warping that is not a number of at least 0</source>
        <translation>ein Tetraeder ihres Sterns hat einen Fehler oder eine Verwerfung, die keine Zahl ab 0 ist</translation>
    </message>
    <message>
        <source>it destroys tetrahedron %1, which is not in the mesh</source>
        <translation>sie zerstört Tetraeder %1, das nicht im Netz ist</translation>
    </message>
    <message>
        <source>it destroys tetrahedron %1 twice</source>
        <translation>sie zerstört Tetraeder %1 zweimal</translation>
    </message>
    <message>
        <source>The finest mesh would have about %1 tetrahedra, and a model holds meshes of at most %2. Choose a larger error, or take a part of the dataset.</source>
        <translation>Das feinste Netz hätte etwa %1 Tetraeder, und ein Modell fasst Netze mit höchstens %2. Verlangen Sie einen größeren Fehler, oder nehmen Sie einen Teil des Datensatzes.</translation>
    </message>
    <message>
        <source>Refining the blocks</source>
        <translation>Blöcke werden verfeinert</translation>
    </message>
    <message>
        <source>Not enough memory to refine blocks of this size. Close other programs, use fewer threads or choose smaller blocks.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um Blöcke dieser Größe zu verfeinern. Schließen Sie andere Programme, nehmen Sie weniger Threads, oder wählen Sie kleinere Blöcke.</translation>
    </message>
    <message>
        <source>The model would have more than 4294967294 sites. Choose a larger error, or take a part of the dataset.</source>
        <translation>Das Modell hätte mehr als 4294967294 Stützstellen. Verlangen Sie einen größeren Fehler, oder nehmen Sie einen Teil des Datensatzes.</translation>
    </message>
    <message>
        <source>Merging the blocks</source>
        <translation>Blöcke werden vereinigt</translation>
    </message>
    <message>
        <source>Numbering the sites</source>
        <translation>Stützstellen werden nummeriert</translation>
    </message>
    <message>
        <source>Not enough memory to merge the blocks. Close other programs, or choose a larger error.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um die Blöcke zu vereinigen. Schließen Sie andere Programme, oder verlangen Sie einen größeren Fehler.</translation>
    </message>
    <message>
        <source>its star offsets do not match its mesh sizes</source>
        <translation>die Anfänge der Sterne passen nicht zu den Netzgrößen</translation>
    </message>
    <message>
        <source>the mesh of %1 sites has %2 tetrahedra instead of %3</source>
        <translation>das Netz von %1 Stützstellen hat %2 Tetraeder statt %3</translation>
    </message>
    <message>
        <source>a tetrahedron of site %1 or soon after has a site that comes after its creator</source>
        <translation>ein Tetraeder der Stützstelle %1 oder bald danach hat eine Stützstelle, die nach seinem Erzeuger kommt</translation>
    </message>
    <message>
        <source>a tetrahedron of site %1 has a site that comes after its creator</source>
        <translation>ein Tetraeder der Stützstelle %1 hat eine Stützstelle, die nach seinem Erzeuger kommt</translation>
    </message>
    <message>
        <source>the mesh of %1 sites has more than the %2 tetrahedra that it should have</source>
        <translation>das Netz von %1 Stützstellen hat mehr als die %2 Tetraeder, die es haben sollte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 sites, fewer than the %3 requested.</source>
        <translation>„%1“ hat %2 Stützstellen, weniger als die %3 verlangten.</translation>
    </message>
    <message>
        <source>The first %1 sites of &apos;%2&apos; have no mesh of their own: site %3 enters together with the one before it.</source>
        <translation>Die ersten %1 Stützstellen von „%2“ haben kein eigenes Netz: Stützstelle %3 tritt zusammen mit der davor ein.</translation>
    </message>
    <message>
        <source>Not enough memory for a mesh of %1 sites. Choose a larger error.</source>
        <translation>Der Arbeitsspeicher reicht nicht für ein Netz aus %1 Stützstellen. Wählen Sie einen größeren Fehler.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not end in .csv or .json, the formats of statistics. Choose one of these endings.</source>
        <translation>„%1“ endet weder auf .csv noch auf .json, in denen Statistiken geschrieben werden. Wählen Sie eine dieser Endungen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2. Copy the file again, or build it again.</source>
        <translation>„%1“ ist beschädigt: %2. Kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is cut short: it has %2 bytes and should have %3. Copy the file again, or build it again.</source>
        <translation>„%1“ ist abgeschnitten: Es hat %2 Bytes und sollte %3 haben. Kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. Models are made by &apos;tan build&apos;.</source>
        <translation>„%1“ ist leer. Modelle werden aus Datensätzen gebaut.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a TAn model: it does not begin like one. Models are made by &apos;tan build&apos;.</source>
        <translation>„%1“ ist kein TAn-Modell: Es beginnt nicht wie eines. Modelle werden aus Datensätzen gebaut.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was written with the other byte order. Build it again on this machine.</source>
        <translation>„%1“ wurde in der anderen Bytefolge geschrieben. Bauen Sie es auf diesem Rechner neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has format version %2.%3; this program reads up to version %4. Install a later version of TAn.</source>
        <translation>„%1“ hat die Formatversion %2.%3; dieses Programm liest bis Version %4. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>its header is invalid</source>
        <translation>Sein Kopf ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>the checksum of its header is wrong</source>
        <translation>Die Prüfsumme seines Kopfes ist falsch</translation>
    </message>
    <message>
        <source>it has %1 bytes and should have %2</source>
        <translation>Es hat %1 Bytes und sollte %2 haben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a model of domain class %2, which this version cannot read. Install a later version of TAn.</source>
        <translation>„%1“ ist ein Modell der Klasse %2, das diese Version nicht lesen kann. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has samples of type %2, which this version cannot read. Install a later version of TAn.</source>
        <translation>„%1“ hat Abtastwerte vom Typ %2, die diese Version nicht lesen kann. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>a lattice of %1 x %2 x %3 points is impossible</source>
        <translation>ein regelmäßiges Gitter aus %1 x %2 x %3 Punkten ist unmöglich</translation>
    </message>
    <message>
        <source>the spacing or the origin of its lattice is invalid</source>
        <translation>der Abstand oder der Ursprung seines regelmäßigen Gitters ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>%1 points cannot have %2 sites and %3 tetrahedra</source>
        <translation>%1 Punkte können nicht %2 Stützstellen und %3 Tetraeder haben</translation>
    </message>
    <message>
        <source>its value range or its final error is invalid</source>
        <translation>sein Wertebereich oder sein Endfehler ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>its bounding box is invalid</source>
        <translation>sein Begrenzungsquader ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>its warping weight or its handedness is invalid</source>
        <translation>sein Gewicht der Verwerfung oder seine Händigkeit ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; appears twice</source>
        <translation>Abschnitt „%1“ ist zweimal da</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; cannot begin at byte %2</source>
        <translation>Abschnitt „%1“ kann nicht bei Byte %2 beginnen</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; reaches beyond the end of the file</source>
        <translation>Abschnitt „%1“ reicht über das Ende der Datei hinaus</translation>
    </message>
    <message>
        <source>its last section ends at byte %1 of %2</source>
        <translation>sein letzter Abschnitt endet bei Byte %1 von %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs section %2, which this version does not know. Install a later version of TAn.</source>
        <translation>„%1“ braucht Abschnitt %2, den diese Version nicht kennt. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; packs its section &apos;%2&apos; with codec %3, which this version does not know. Install a later version of TAn.</source>
        <translation>„%1“ packt den Abschnitt „%2“ mit dem Codec %3, den diese Version nicht kennt. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>its text section is missing or too long</source>
        <translation>sein Textabschnitt fehlt oder ist zu lang</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is missing</source>
        <translation>Der Abschnitt „%1“ fehlt</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; has %2 bytes in elements of %3 instead of %4 elements of %5</source>
        <translation>Abschnitt „%1“ hat %2 Bytes in Elementen zu %3 statt %4 Elementen zu %5</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: the names and parameters of the model are longer than 1 MiB. Shorten them.</source>
        <translation>„%1“ kann nicht geschrieben werden: Die Namen und Parameter des Modells sind länger als 1 MiB. Kürzen Sie sie.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: the checksum of its history kind is wrong. Copy the file again, or build it again.</source>
        <translation>„%1“ ist beschädigt: Die Prüfsumme der Art seiner Geschichte ist falsch. Kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has a history of kind %2, which this version cannot read. Install a later version of TAn.</source>
        <translation>„%1“ hat eine Geschichte der Art %2, die diese Version nicht lesen kann. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: the checksum of its text is wrong. Copy the file again, or build it again.</source>
        <translation>„%1“ ist beschädigt: Die Prüfsumme seines Textes ist falsch. Kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>Checking the model&apos;s file</source>
        <translation>Datei des Modells wird geprüft</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open. Open it again; if that fails, copy the file again, or build it again.</source>
        <translation>„%1“ wurde abgeschnitten oder geändert, während es offen war. Öffnen Sie es noch einmal; gelingt das nicht, kopieren Sie die Datei noch einmal, oder bauen Sie das Modell neu.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; made a history that differs from the one it announced. Nothing was written; report this to its author.</source>
        <translation>Der Erbauer „%1“ hat eine andere Geschichte gemacht, als er angekündigt hatte. Es wurde nichts geschrieben; melden Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>its warping weight is %1</source>
        <translation>sein Gewicht der Verwerfung ist %1</translation>
    </message>
    <message>
        <source>meshes of irregular data are not Delaunay meshes</source>
        <translation>Netze unregelmäßiger Daten sind keine Delaunay-Netze</translation>
    </message>
    <message>
        <source>its blocks have %1 x %2 x %3 cells</source>
        <translation>seine Blöcke haben %1 x %2 x %3 Zellen</translation>
    </message>
    <message>
        <source>%1 data need a warping weight</source>
        <translation>diese Daten (%1) brauchen ein Gewicht der Verwerfung</translation>
    </message>
    <message>
        <source>a model needs at least the sites of its first mesh</source>
        <translation>ein Modell braucht mindestens die Stützstellen eines ersten Netzes</translation>
    </message>
    <message>
        <source>the final error is not a number of at least 0</source>
        <translation>der Endfehler ist keine Zahl ab 0</translation>
    </message>
    <message>
        <source>The build was stopped before there was a mesh of known error, so there is nothing to keep.</source>
        <translation>Der Bau wurde angehalten, ehe es ein Netz mit bekanntem Fehler gab; es gibt also nichts zu behalten.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; made a history that is wrong at site %2: %3. Nothing was written; report this to its author.</source>
        <translation>Der Erbauer „%1“ hat eine Geschichte gemacht, die bei Stützstelle %2 falsch ist: %3. Es wurde nichts geschrieben; melden Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos; after %2 sites. Choose a larger error, or close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nach %2 Stützstellen nicht mehr, um „%1“ zu schreiben. Verlangen Sie einen größeren Fehler, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>A model holds at most 4294967296 points, and &apos;%1&apos; has %2. Take a part of it.</source>
        <translation>Ein Modell fasst höchstens 4294967296 Punkte, und „%1“ hat %2. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>a tetrahedron is destroyed before it is created</source>
        <translation>ein Tetraeder wird zerstört, bevor es entsteht</translation>
    </message>
    <message>
        <source>Reading the history</source>
        <translation>Geschichte wird durchgesehen</translation>
    </message>
    <message>
        <source>its destroyers changed while they were read</source>
        <translation>seine Zerstörer haben sich geändert, während sie gelesen wurden</translation>
    </message>
    <message>
        <source>Selecting the sites</source>
        <translation>Stützstellen werden gewählt</translation>
    </message>
    <message>
        <source>The coarsest mesh of &apos;%1&apos; has %2 tetrahedra, more than the budget of %3. Allow at least that many.</source>
        <translation>Das gröbste Netz von „%1“ hat %2 Tetraeder, mehr als das Budget von %3. Erlauben Sie mindestens so viele.</translation>
    </message>
    <message>
        <source>its running errors do not bound the errors of its tetrahedra</source>
        <translation>seine laufenden Fehler begrenzen die eigenen der Tetraeder nicht</translation>
    </message>
    <message>
        <source>its tetrahedra do not match its mesh sizes</source>
        <translation>seine Tetraeder passen nicht zu seinen Netzgrößen</translation>
    </message>
    <message>
        <source>its mesh sizes are invalid</source>
        <translation>seine Netzgrößen ergeben keinen Sinn</translation>
    </message>
    <message>
        <source>a tetrahedron has a site that its creator does not need</source>
        <translation>ein Tetraeder hat eine Stützstelle, die sein Erzeuger nicht braucht</translation>
    </message>
    <message>
        <source>its coarse tetrahedra do not fit together</source>
        <translation>seine groben Tetraeder passen nicht zusammen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not made by inserting points into Delaunay meshes, so points cannot be inserted now. Use a closed set, or the automatic choice.</source>
        <translation>„%1“ ist nicht durch Einfügen von Punkten in Delaunay-Netze entstanden, also können jetzt keine eingefügt werden. Nehmen Sie eine abgeschlossene Menge oder die automatische Wahl.</translation>
    </message>
    <message>
        <source>Examining the mesh</source>
        <translation>Netz wird durchgesehen</translation>
    </message>
    <message>
        <source>The mesh of the focus became too large. Choose a larger error or a smaller focus.</source>
        <translation>Das Netz des Fokus wurde zu groß. Wählen Sie einen größeren Fehler oder einen kleineren Fokus.</translation>
    </message>
    <message>
        <source>a sample lies in no tetrahedron</source>
        <translation>ein Abtastwert liegt nirgends</translation>
    </message>
    <message>
        <source>a site is not a point of its grid</source>
        <translation>eine Stützstelle ist kein Punkt seines Gitters</translation>
    </message>
    <message>
        <source>Refining the focus</source>
        <translation>Fokus wird verfeinert</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh of the focus. Choose a larger error or a smaller focus.</source>
        <translation>Der Arbeitsspeicher reicht nicht für das Netz des Fokus. Wählen Sie einen größeren Fehler oder einen kleineren Fokus.</translation>
    </message>
    <message>
        <source>the end of the text</source>
        <translation>das Ende des Textes</translation>
    </message>
    <message>
        <source>fewer fields: at most %1, nested up to %2 levels deep</source>
        <translation>weniger Felder: höchstens %1, %2-fach verschachtelt</translation>
    </message>
    <message>
        <source>a number or one of %1</source>
        <translation>eine Zahl oder eines von %1</translation>
    </message>
    <message>
        <source>a half-space whose first three numbers are not all 0</source>
        <translation>ein Halbraum, dessen erste drei Zahlen nicht alle 0 sind</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a number, or the name of a field</source>
        <translation>eine Zahl oder der Name eines Feldes</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>eine Zahl, die nicht negativ ist</translation>
    </message>
    <message>
        <source>a number of fewer than 308 digits</source>
        <translation>eine Zahl mit weniger als 308 Ziffern</translation>
    </message>
    <message>
        <source>The error field cannot be read at character %1: expected %2, but the text ends.</source>
        <translation>Das Fehlerfeld kann bei Zeichen %1 nicht gelesen werden: Erwartet wird %2, aber der Text endet.</translation>
    </message>
    <message>
        <source>The error field cannot be read at character %1: expected %2, but found &apos;%3&apos;.</source>
        <translation>Das Fehlerfeld kann bei Zeichen %1 nicht gelesen werden: Erwartet wird %2, aber da steht „%3“.</translation>
    </message>
    <message>
        <source>Extracting a range of meshes</source>
        <translation>Netze eines Bereichs werden entnommen</translation>
    </message>
    <message>
        <source>the meshes of %1 and %2 sites do not have the expected %3 and %4 tetrahedra</source>
        <translation>die Netze von %1 und %2 Stützstellen haben nicht die %3 und %4 Tetraeder, die sie haben sollten</translation>
    </message>
    <message>
        <source>a tetrahedron of site %1 is destroyed by a site that does not come after it</source>
        <translation>ein Tetraeder der Stützstelle %1 wird von einer zerstört, die nicht nach ihr kommt</translation>
    </message>
    <message>
        <source>its first sites have an error</source>
        <translation>seine ersten Stützstellen haben einen Fehler</translation>
    </message>
    <message>
        <source>Clip exactly is not available for meshes of several accuracies. Choose the tetrahedra that intersect the crop box, or those it contains.</source>
        <translation>Netze mehrerer Genauigkeiten können nicht an einem Fenster geschnitten werden: Was geschnitten ist, hat kein eigenes Leben. Verlangen Sie die Tetraeder, die das Fenster schneiden, oder die es enthält.</translation>
    </message>
    <message>
        <source>The coarsest mesh has %1 tetrahedra, more than the budget of %2. Allow at least that many.</source>
        <translation>Das gröbste Netz hat %1 Tetraeder, mehr als das Budget von %2. Erlauben Sie mindestens so viele.</translation>
    </message>
    <message>
        <source>%1. Use a closed set, or the automatic choice.</source>
        <translation>%1. Nehmen Sie eine abgeschlossene Menge oder die automatische Wahl.</translation>
    </message>
    <message>
        <source>Insertion is for lattices and curvilinear grids, not for scattered points</source>
        <translation>Einfügen geht bei regelmäßigen und krummlinigen Gittern, nicht bei verstreuten Punkten</translation>
    </message>
    <message>
        <source>Insertion needs a model made by refinement, whose meshes are Delaunay meshes</source>
        <translation>Einfügen braucht ein durch Verfeinerung gemachtes Modell, dessen Netze Delaunay-Netze sind</translation>
    </message>
    <message>
        <source>Insertion needs all samples of the dataset, which the file of this model does not hold</source>
        <translation>Einfügen braucht alle Abtastwerte des Datensatzes, die in der Datei dieses Modells nicht stehen</translation>
    </message>
    <message>
        <source>Insertion into a lattice is for one box, sphere or half-space of smaller error</source>
        <translation>Einfügen in ein regelmäßiges Gitter geht für einen Quader, eine Kugel oder einen Halbraum mit kleinerem Fehler</translation>
    </message>
    <message>
        <source>Insertion within a budget needs a sharp border, or an error of at least %1 to fall off from</source>
        <translation>Einfügen mit einem Budget braucht eine scharfe Grenze oder einen Fehler von mindestens %1, von dem er abfällt</translation>
    </message>
    <message>
        <source>Insertion cannot tell how this model was built, or its grid is too large</source>
        <translation>Einfügen geht nicht, weil nicht bekannt ist, wie dieses Modell gebaut wurde, oder weil sein Gitter zu groß ist</translation>
    </message>
    <message>
        <source>Searching for the best mesh within the budget</source>
        <translation>Es wird versucht, was das Budget erlaubt</translation>
    </message>
    <message>
        <source>There is not enough memory for this mesh. Choose a larger error, a smaller focus or a budget.</source>
        <translation>Der Arbeitsspeicher reicht nicht für dieses Netz. Wählen Sie einen größeren Fehler, einen kleineren Fokus oder ein Budget.</translation>
    </message>
    <message>
        <source>The smallest %1 of the crop box, %2, is larger than its largest, %3. Swap them.</source>
        <translation>Das kleinste %1 des Fensters, %2, ist größer als sein größtes, %3. Vertauschen Sie die beiden.</translation>
    </message>
    <message>
        <source>The largest error is not a number everywhere. Give it in percent at every place.</source>
        <translation>Der größte Fehler ist irgendwo keine Zahl. Geben Sie ihn überall in Prozent an.</translation>
    </message>
    <message>
        <source>The largest warping is not a number everywhere. Give it in percent at every place.</source>
        <translation>Die größte Verwerfung ist irgendwo keine Zahl. Geben Sie sie überall in Prozent an.</translation>
    </message>
    <message>
        <source>A budget of zero tetrahedra allows no mesh of &apos;%1&apos;.</source>
        <translation>Ein Budget von null Tetraedern erlaubt kein Netz von „%1“.</translation>
    </message>
    <message>
        <source>A range of values goes from a smaller number to a larger one: %1 and %2 do not.</source>
        <translation>Ein Wertebereich geht von einer kleineren Zahl zu einer größeren: %1 und %2 tun das nicht.</translation>
    </message>
    <message>
        <source>a site is not a point of its lattice</source>
        <translation>eine Stützstelle ist kein Punkt seines regelmäßigen Gitters</translation>
    </message>
    <message>
        <source>The error in the focus is larger than that outside. Swap them.</source>
        <translation>Der Fehler im Fokus ist größer als der außerhalb. Vertauschen Sie die beiden.</translation>
    </message>
    <message>
        <source>Cutting at the crop box</source>
        <translation>Zuschnitt am Fenster</translation>
    </message>
    <message>
        <source>The mesh cut at the crop box has too many vertices: choose a larger error or a smaller box.</source>
        <translation>Das Netz, das am Fenster geschnitten wird, hat zu viele Knoten: Wählen Sie einen größeren Fehler oder ein kleineres Fenster.</translation>
    </message>
    <message>
        <source>Not enough memory to cut a mesh of %1 tetrahedra at a crop box. Choose a larger error or a smaller box.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um ein Netz aus %1 Tetraedern an einem Fenster zu schneiden. Wählen Sie einen größeren Fehler oder ein kleineres Fenster.</translation>
    </message>
    <message>
        <source>the checksum of section &apos;%1&apos; is wrong</source>
        <translation>Die Prüfsumme des Abschnitts „%1“ ist falsch</translation>
    </message>
    <message>
        <source>chunks of %1 bytes are impossible</source>
        <translation>Stücke von %1 Bytes sind unmöglich</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; has %2 bytes instead of %3 elements of 8</source>
        <translation>Abschnitt „%1“ hat %2 Bytes statt %3 Elementen zu 8</translation>
    </message>
    <message>
        <source>its star offsets do not match its tetrahedra</source>
        <translation>die Anfänge der Sterne passen nicht zu den Tetraedern</translation>
    </message>
    <message>
        <source>the star offsets of site %1 are invalid</source>
        <translation>die Anfänge der Sterne bei Stützstelle %1 ergeben keinen Sinn</translation>
    </message>
    <message>
        <source>%1 was cancelled.</source>
        <translation>Abgebrochen: %1.</translation>
    </message>
    <message>
        <source>regular</source>
        <translation>regelmäßig</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>krummlinig</translation>
    </message>
    <message>
        <source>irregular</source>
        <translation>unregelmäßig</translation>
    </message>
    <message>
        <source>scattered</source>
        <translation>verstreut</translation>
    </message>
    <message>
        <source>Ordering the mesh</source>
        <translation>Netz wird geordnet</translation>
    </message>
    <message>
        <source>A tetrahedron has a corner that does not exist.</source>
        <translation>Ein Tetraeder hat eine Ecke, die es nicht gibt.</translation>
    </message>
    <message>
        <source>The mesh and its values do not belong together.</source>
        <translation>Das Netz und seine Werte gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>Not enough memory to put the mesh in spatial order. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um das Netz räumlich zu ordnen. Schließen Sie andere Programme, oder verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>the state of the refinement&apos;s tetrahedra</source>
        <translation>den Zustand der Tetraeder bei der Verfeinerung</translation>
    </message>
    <message>
        <source>The mesh grew beyond what was reserved for it.</source>
        <translation>Das Netz ist über das hinausgewachsen, was dafür reserviert war.</translation>
    </message>
    <message>
        <source>The grid has too many points to be refined: its coordinates need more than 32 bits. Crop or subsample it.</source>
        <translation>Das Gitter hat zu viele Punkte, um verfeinert zu werden: Koordinaten brauchen mehr als 32 Bit. Schneiden Sie es zu, oder nehmen Sie nur jeden n-ten Punkt.</translation>
    </message>
    <message>
        <source>Distributing the points</source>
        <translation>Die Punkte werden verteilt</translation>
    </message>
    <message>
        <source>Not enough memory to refine this grid. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses Gitter zu verfeinern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher, oder nehmen Sie einen Teil der Daten.</translation>
    </message>
    <message>
        <source>%1 A tetrahedral mesh needs four points that do not lie in one plane.</source>
        <translation>%1 Ein Tetraedernetz braucht vier Punkte, die nicht in einer Ebene liegen.</translation>
    </message>
    <message>
        <source>There are only %1 points.</source>
        <translation>Es gibt nur %1 Punkte.</translation>
    </message>
    <message>
        <source>All points lie at one place.</source>
        <translation>Alle Punkte liegen an einem Ort.</translation>
    </message>
    <message>
        <source>All points lie on one line.</source>
        <translation>Alle Punkte liegen auf einer Geraden.</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>Alle Punkte liegen in einer Ebene.</translation>
    </message>
    <message>
        <source>Points %1 and %2 (counted from 0) lie at the same place. Merge such points first.</source>
        <translation>Die Punkte %1 und %2 (von 0 gezählt) liegen am selben Ort. Vereinigen Sie solche Punkte zuerst.</translation>
    </message>
    <message>
        <source>Finding the convex hull</source>
        <translation>Suche der konvexen Hülle</translation>
    </message>
    <message>
        <source>The refinement</source>
        <translation>Die Verfeinerung</translation>
    </message>
    <message>
        <source>Point %1 lies outside the computed convex hull. Coordinates of such different magnitudes cannot be used; scale them.</source>
        <translation>Punkt %1 liegt außerhalb der konvexen Hülle, die berechnet wurde. Koordinaten so verschiedener Größenordnung können nicht benutzt werden; skalieren Sie sie.</translation>
    </message>
    <message>
        <source>The history has more than 4 billion tetrahedra. Choose a larger error.</source>
        <translation>Die Geschichte hat mehr als 4 Milliarden Tetraeder. Verlangen Sie einen größeren Fehler.</translation>
    </message>
    <message>
        <source>At most 4294967294 scattered points can be refined. Take a part.</source>
        <translation>Höchstens 4294967294 verstreute Punkte können verfeinert werden. Nehmen Sie einen Teil.</translation>
    </message>
    <message>
        <source>Not enough memory to refine these points. Close other programs, use a machine with more memory, or take a part of the points.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um diese Punkte zu verfeinern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher oder einen Teil der Punkte.</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>the vertices of the mesh&apos;s tetrahedra</source>
        <translation>die Knoten der Tetraeder</translation>
    </message>
    <message>
        <source>the state of the mesh&apos;s tetrahedra</source>
        <translation>den Zustand der Tetraeder</translation>
    </message>
    <message>
        <source>the set of the mesh&apos;s points</source>
        <translation>die Menge der Punkte</translation>
    </message>
    <message>
        <source>The lattice has too many points to be refined as a whole. Crop or subsample it.</source>
        <translation>Das regelmäßige Gitter hat zu viele Punkte, um als Ganzes verfeinert zu werden. Schneiden Sie es zu, oder nehmen Sie nur jeden n-ten Punkt.</translation>
    </message>
    <message>
        <source>the tetrahedra of the refinement</source>
        <translation>die Tetraeder der Verfeinerung</translation>
    </message>
    <message>
        <source>A block of the lattice needs at least two points along each axis and must lie within it. Choose another block size.</source>
        <translation>Ein Block des regelmäßigen Gitters braucht zwei Punkte entlang jeder Achse und darf nicht überstehen. Wählen Sie eine andere Blockgröße.</translation>
    </message>
    <message>
        <source>A block of the lattice is too large to be refined with exact arithmetic. Choose a smaller block size.</source>
        <translation>Ein Block des regelmäßigen Gitters ist zu groß, um mit exakter Arithmetik verfeinert zu werden. Wählen Sie eine kleinere Blockgröße.</translation>
    </message>
    <message>
        <source>Not enough memory to refine this lattice. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses regelmäßige Gitter zu verfeinern. Schließen Sie andere Programme, nehmen Sie einen Rechner mit mehr Speicher, oder nehmen Sie einen Teil der Daten.</translation>
    </message>
    <message>
        <source>the lists of the refinement&apos;s points</source>
        <translation>die Listen der Punkte bei der Verfeinerung</translation>
    </message>
    <message>
        <source>A lattice of %1 x %2 x %3 points is too large to be refined as a whole with exact arithmetic (512 x 512 x 512 is about the limit). Crop or subsample it.</source>
        <translation>Ein regelmäßiges Gitter aus %1 x %2 x %3 Punkten ist zu groß, um als Ganzes mit exakter Arithmetik verfeinert zu werden (etwa 512 x 512 x 512 ist die Grenze). Schneiden Sie es zu, oder nehmen Sie nur jeden n-ten Punkt.</translation>
    </message>
    <message>
        <source>More than %1 points cannot be refined at once. Crop or subsample the data.</source>
        <translation>Mehr als %1 Punkte können nicht auf einmal verfeinert werden. Schneiden Sie die Daten zu, oder nehmen Sie nur jeden n-ten Punkt.</translation>
    </message>
    <message>
        <source>the points of the refinement</source>
        <translation>die Punkte der Verfeinerung</translation>
    </message>
    <message>
        <source>the marks of the refinement&apos;s points</source>
        <translation>die Markierungen der Punkte bei der Verfeinerung</translation>
    </message>
    <message>
        <source>Finding the boundary</source>
        <translation>Berandung wird gesucht</translation>
    </message>
    <message>
        <source>Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh.</source>
        <translation>Der Speicher reicht nicht für die Berandung des Netzes. Verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>The boundary&apos;s opacity must be above 0 and at most 1.</source>
        <translation>Die Deckkraft der Berandung muss über 0 liegen und höchstens 1 sein.</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not a number from %2 to %3 (%4).</source>
        <translation>Der Schlüssel „%1“ der Kamera ist keine Zahl von %2 bis %3 (%4).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is neither true nor false (%2).</source>
        <translation>Der Schlüssel „%1“ der Kamera ist weder true noch false (%2).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not one of x, -x, y, -y, z and -z (%2).</source>
        <translation>Der Schlüssel „%1“ der Kamera ist keines von x, -x, y, -y, z und -z (%2).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not known (%2).</source>
        <translation>Der Schlüssel „%1“ der Kamera ist nicht bekannt (%2).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not a list of three numbers (%2).</source>
        <translation>Der Schlüssel „%1“ der Kamera ist keine Liste aus drei Zahlen (%2).</translation>
    </message>
    <message>
        <source>This is not a camera. %1</source>
        <translation>Das ist keine Kamera. %1</translation>
    </message>
    <message>
        <source>This is not a camera: it holds no JSON object, in braces.</source>
        <translation>Das ist keine Kamera: Es enthält kein JSON-Objekt in geschweiften Klammern.</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>The scene has more than two billion vertices.</source>
        <translation>Die Szene hat mehr als zwei Milliarden Knoten.</translation>
    </message>
    <message>
        <source>OpenGL without a window needs EGL, and %1 cannot be loaded. Install it (Debian: libegl1), or use the CPU back end.</source>
        <translation>OpenGL ohne Fenster braucht EGL, und %1 kann nicht geladen werden. Installieren Sie es (Debian: libegl1), oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>%1 has no %2. Install EGL 1.4, or use the CPU back end.</source>
        <translation>%1 hat kein %2. Installieren Sie EGL 1.4, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>EGL provides no OpenGL 3.3 without a window on this machine. Install the driver of the graphics card or Mesa (Debian: libgl1-mesa-dri), or use the CPU back end.</source>
        <translation>EGL gibt auf diesem Rechner kein OpenGL 3.3 ohne Fenster. Installieren Sie den Treiber der Karte oder Mesa (Debian: libgl1-mesa-dri), oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The OpenGL context cannot be used, perhaps because the graphics card was reset. Use the CPU back end.</source>
        <translation>Der OpenGL-Kontext ist nicht benutzbar, vielleicht weil die Grafikkarte zurückgesetzt wurde. Lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>A surface has too many triangles for OpenGL. Use the CPU back end.</source>
        <translation>Eine Fläche hat zu viele Dreiecke für OpenGL. Lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for this surface. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für diese Fläche. Senken Sie die Genauigkeit des Netzes, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for this volume. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für dieses Volumen. Senken Sie die Genauigkeit des Netzes, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>This OpenGL driver draws volumes of at most %1 vertices. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>Dieser OpenGL-Treiber zeichnet Volumen mit höchstens %1 Knoten. Verringern Sie die Genauigkeit des Netzes, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The OpenGL driver of this machine rejects a shader of TAn. Use the CPU back end, or another driver. It reports: %1</source>
        <translation>Der OpenGL-Treiber dieses Rechners lehnt einen Shader von TAn ab. Lassen Sie den Prozessor zeichnen, oder nehmen Sie einen anderen Treiber. Er sagt: %1</translation>
    </message>
    <message>
        <source>OpenGL supports at most %1 clip planes. Use fewer, or use the CPU back end.</source>
        <translation>OpenGL schneidet Szenen an höchstens %1 Ebenen. Nehmen Sie weniger, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for a picture of this size. Make it smaller, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für ein Bild dieser Größe. Machen Sie es kleiner, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The OpenGL driver cannot draw into floating-point textures, which OpenGL 3.3 requires. Use the CPU back end.</source>
        <translation>Der OpenGL-Treiber kann nicht in Gleitkommatexturen zeichnen, was OpenGL 3.3 verlangt. Lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>This OpenGL driver draws at most %1 samples per side. Make the picture smaller, use fewer samples, or use the CPU back end.</source>
        <translation>Dieser OpenGL-Treiber zeichnet höchstens %1 Abtastwerte je Seite. Machen Sie das Bild kleiner, nehmen Sie weniger Abtastwerte, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>The OpenGL driver has no function %1, so it is older than OpenGL 3.3. Use the CPU back end, or another driver.</source>
        <translation>Der OpenGL-Treiber hat keine Funktion %1, ist also älter als OpenGL 3.3. Lassen Sie den Prozessor zeichnen, oder nehmen Sie einen anderen Treiber.</translation>
    </message>
    <message>
        <source>The OpenGL driver has version %1.%2; TAn needs 3.3. Use the CPU back end, or another driver.</source>
        <translation>Der OpenGL-Treiber hat Version %1.%2; TAn braucht 3.3. Lassen Sie den Prozessor zeichnen, oder nehmen Sie einen anderen Treiber.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for this picture. Make it smaller, or use the CPU back end.</source>
        <translation>Der Speicher der Grafikkarte reicht nicht für dieses Bild. Machen Sie es kleiner, oder lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>Not enough memory for a picture of this size and scene. Make the picture smaller or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht für ein Bild dieser Größe und Szene. Machen Sie das Bild kleiner, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>The scene has more than four billion triangles.</source>
        <translation>Die Szene hat mehr als vier Milliarden Dreiecke.</translation>
    </message>
    <message>
        <source>Drawing the volume</source>
        <translation>Volumen wird gezeichnet</translation>
    </message>
    <message>
        <source>A volume of the scene and its transfer function do not belong together.</source>
        <translation>Ein Volumen der Szene und seine Transferfunktion gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>Extracting the isosurface</source>
        <translation>Isofläche wird entnommen</translation>
    </message>
    <message>
        <source>The isovalue is not a number.</source>
        <translation>Der Isowert ist keine Zahl.</translation>
    </message>
    <message>
        <source>The mesh, its values, its gradients and its index do not belong together.</source>
        <translation>Das Netz, seine Werte, seine Gradienten und sein Index gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>The isosurface has more than four billion vertices. Lower the accuracy of the mesh.</source>
        <translation>Die Isofläche hat mehr als vier Milliarden Knoten. Verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht für die Isofläche. Schließen Sie andere Programme, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Extracting isosurfaces</source>
        <translation>Isoflächen werden entnommen</translation>
    </message>
    <message>
        <source>An isovalue must be a finite number, and its opacity between 0 and 1.</source>
        <translation>Ein Isowert muss eine endliche Zahl sein und seine Deckkraft zwischen 0 und 1.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurfaces. Show fewer of them or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht für die Isoflächen. Zeigen Sie weniger davon, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a clip plane: give four numbers nx,ny,nz,offset, the first three not all zero; points with nx x + ny y + nz z &gt;= offset are shown.</source>
        <translation>„%1“ ist keine Schnittebene: Geben Sie vier Zahlen nx,ny,nz,Abstand an, die ersten drei nicht alle null; gezeigt werden Punkte mit nx x + ny y + nz z &gt;= Abstand.</translation>
    </message>
    <message>
        <source>A surface of the scene does not have one normal for each vertex.</source>
        <translation>Eine Fläche der Szene hat nicht für jeden Knoten eine Normale.</translation>
    </message>
    <message>
        <source>A surface of the scene does not have one value or colour for each vertex.</source>
        <translation>Eine Fläche der Szene hat nicht für jeden Knoten einen Wert oder eine Farbe.</translation>
    </message>
    <message>
        <source>A triangle of the scene has a corner that does not exist.</source>
        <translation>Ein Dreieck der Szene hat eine Ecke, die es nicht gibt.</translation>
    </message>
    <message>
        <source>A line of the scene has an end that does not exist.</source>
        <translation>Eine Linie der Szene hat ein Ende, das es nicht gibt.</translation>
    </message>
    <message>
        <source>A picture cannot be %1 x %2 pixels. Each side must be 1 to %3.</source>
        <translation>Ein Bild kann nicht %1 x %2 Pixel haben. Jede Seite muss 1 bis %3 haben.</translation>
    </message>
    <message>
        <source>The samples per axis of a pixel must be 1 to 4.</source>
        <translation>Die Abtastwerte je Achse eines Pixels müssen 1 bis 4 sein.</translation>
    </message>
    <message>
        <source>The number of threads must not be negative; 0 means all.</source>
        <translation>Die Zahl der Threads darf nicht negativ sein; 0 heißt alle.</translation>
    </message>
    <message>
        <source>Not enough memory to draw this mesh as a volume. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um dieses Netz als Volumen zu zeichnen. Schließen Sie andere Programme, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>The mesh has more than a billion tetrahedra, too many to be drawn at once. Lower its accuracy.</source>
        <translation>Das Netz hat mehr als eine Milliarde Tetraeder, zu viele, um auf einmal gezeichnet zu werden. Verringern Sie seine Genauigkeit.</translation>
    </message>
    <message>
        <source>The transfer function has more than 65,000 points. Leave some out.</source>
        <translation>Die Transferfunktion hat mehr als 65 000 Punkte. Lassen Sie einige weg.</translation>
    </message>
    <message>
        <source>Preparing the volume</source>
        <translation>Volumen wird vorbereitet</translation>
    </message>
    <message>
        <source>Ordering the tetrahedra</source>
        <translation>Tetraeder werden geordnet</translation>
    </message>
    <message>
        <source>A picture must have 1 to %1 samples per side. Draw a larger one in parts.</source>
        <translation>Ein Bild muss 1 bis %1 Abtastwerte je Seite haben. Zeichnen Sie ein größeres in Teilen.</translation>
    </message>
    <message>
        <source>The mesh, its transfer function and its order do not belong together.</source>
        <translation>Das Netz, seine Transferfunktion und seine Ordnung gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be used: %2.</source>
        <translation>Die Vorlage „%1“ kann nicht benutzt werden: %2.</translation>
    </message>
    <message>
        <source>a value is not a finite number</source>
        <translation>ein Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>its values are not in ascending order: %1 comes after %2</source>
        <translation>seine Werte steigen nicht: %1 kommt nach %2</translation>
    </message>
    <message>
        <source>it has neither colours nor opacities</source>
        <translation>es hat weder Farben noch Deckkräfte</translation>
    </message>
    <message>
        <source>its colours follow the logarithm, and its values are not all positive</source>
        <translation>seine Farben gehen nach dem Logarithmus, und nicht alle seine Werte sind positiv</translation>
    </message>
    <message>
        <source>a channel of a colour lies outside 0 to 1</source>
        <translation>ein Kanal einer Farbe liegt außerhalb von 0 bis 1</translation>
    </message>
    <message>
        <source>an opacity, a midpoint or a sharpness lies outside 0 to 1</source>
        <translation>eine Deckkraft, ein Mittelpunkt oder eine Schärfe liegt außerhalb von 0 bis 1</translation>
    </message>
    <message>
        <source>The ParaView preset cannot be read: %1 (%2).</source>
        <translation>Die ParaView-Vorlage kann nicht gelesen werden: %1 (%2).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of numbers, %2 for each point</source>
        <translation>„%1“ muss eine Liste von Zahlen sein, %2 für jeden Punkt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds something that is not a number</source>
        <translation>„%1“ enthält etwas, das keine Zahl ist</translation>
    </message>
    <message>
        <source>the colour space &apos;%1&apos; is not known here; choose another one in ParaView&apos;s colour map editor</source>
        <translation>der Farbraum „%1“ ist hier nicht bekannt; wählen Sie in ParaViews Editor für Farbtabellen einen anderen</translation>
    </message>
    <message>
        <source>a preset must be an object, in braces</source>
        <translation>eine Vorlage muss ein Objekt sein, in geschweiften Klammern</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has colours for categories and none for values in between</source>
        <translation>„%1“ hat Farben für Kategorien und keine für Werte dazwischen</translation>
    </message>
    <message>
        <source>the list is empty</source>
        <translation>die Liste ist leer</translation>
    </message>
    <message>
        <source>The ParaView preset cannot be read: %1.</source>
        <translation>Die ParaView-Vorlage kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>a point&apos;s attribute &apos;%1&apos; is &apos;%2&apos;, which is not a number</source>
        <translation>das Attribut „%1“ eines Punktes ist „%2“ und keine Zahl</translation>
    </message>
    <message>
        <source>the name of a colour map is not UTF-8</source>
        <translation>der Name einer Farbtabelle ist nicht UTF-8</translation>
    </message>
    <message>
        <source>the colour space &apos;%1&apos; of &apos;%2&apos; is not known here</source>
        <translation>der Farbraum „%1“ von „%2“ ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>the XML is damaged at byte %1: %2</source>
        <translation>das XML ist bei Byte %1 beschädigt: %2</translation>
    </message>
    <message>
        <source>there is no ColorMap element in it</source>
        <translation>es enthält kein Element ColorMap</translation>
    </message>
    <message>
        <source>The transfer function cannot be read. %1</source>
        <translation>Die Transferfunktion kann nicht gelesen werden. %1</translation>
    </message>
    <message>
        <source>has no finite value.</source>
        <translation>hat keinen endlichen Wert.</translation>
    </message>
    <message>
        <source>has a group outside 0 to 9.</source>
        <translation>hat eine Gruppe außerhalb von 0 bis 9.</translation>
    </message>
    <message>
        <source>has a smaller value than the point before it. Put them in ascending order.</source>
        <translation>hat einen kleineren Wert als der Punkt davor. Ordnen Sie sie aufsteigend.</translation>
    </message>
    <message>
        <source>is the third at its value. Two make a step; leave out those between.</source>
        <translation>ist der dritte seines Wertes. Zwei bilden eine Stufe; lassen Sie die dazwischen weg.</translation>
    </message>
    <message>
        <source>Colour %1 of the transfer function %2</source>
        <translation>Farbe %1 der Transferfunktion %2</translation>
    </message>
    <message>
        <source>has a channel outside 0 to 1.</source>
        <translation>hat einen Kanal außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>Opacity %1 of the transfer function %2</source>
        <translation>Deckkraft %1 der Transferfunktion %2</translation>
    </message>
    <message>
        <source>is outside 0 to 1.</source>
        <translation>liegt außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>The mask of a transfer function must be a range of finite values.</source>
        <translation>Die Maske einer Transferfunktion muss ein Bereich endlicher Werte sein.</translation>
    </message>
    <message>
        <source>The unit distance of a transfer function must be a length above zero.</source>
        <translation>Die Einheitslänge einer Transferfunktion muss eine Länge über null sein.</translation>
    </message>
    <message>
        <source>%1 must be a number within range</source>
        <translation>%1 muss eine passende Zahl sein</translation>
    </message>
    <message>
        <source>%1 must be an object, in braces</source>
        <translation>%1 muss ein Objekt sein, in geschweiften Klammern</translation>
    </message>
    <message>
        <source>%1 has no &quot;%2&quot;</source>
        <translation>%1 hat kein „%2“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here</source>
        <translation>„%1“ ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>a colour must be three numbers in brackets</source>
        <translation>eine Farbe muss aus drei Zahlen in eckigen Klammern bestehen</translation>
    </message>
    <message>
        <source>a channel</source>
        <translation>ein Kanal</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>eine Farbe</translation>
    </message>
    <message>
        <source>an opacity</source>
        <translation>eine Deckkraft</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list, in brackets</source>
        <translation>„%1“ muss eine Liste sein, in eckigen Klammern</translation>
    </message>
    <message>
        <source>a mask</source>
        <translation>eine Maske</translation>
    </message>
    <message>
        <source>&quot;format&quot; is not &quot;%1&quot;</source>
        <translation>„format“ ist nicht „%1“</translation>
    </message>
    <message>
        <source>this program knows versions 1 to %1</source>
        <translation>dieses Programm kennt die Versionen 1 bis %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>translucent</source>
        <translation>durchscheinend</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Berandung</translation>
    </message>
    <message>
        <source>Shows where the mesh ends, holes and cavities included: &apos;translucent&apos; in a light colour, so that you can see inside, or in the colours that the transfer function gives the &apos;values&apos; there.</source>
        <translation>Zeigt, wo das Netz endet, mit Löchern und Hohlräumen: „durchscheinend“ in einer hellen Farbe, sodass man sieht, was darin ist; „Werte“ in den Farben, die die Transferfunktion den Werten dort gibt.</translation>
    </message>
    <message>
        <source>The opacity of a translucent boundary; 1 hides what is behind it.</source>
        <translation>Die Deckkraft einer durchscheinenden Berandung; 1 verdeckt, was dahinter liegt.</translation>
    </message>
    <message>
        <source>Back faces only</source>
        <translation>Nur Rückseiten</translation>
    </message>
    <message>
        <source>Shows only the far walls of the boundary, seen from inside, and leaves out those that face the camera.</source>
        <translation>Zeigt nur die hinteren Wände der Berandung, von innen, und lässt die der Kamera zugewandten weg.</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isowerte</translation>
    </message>
    <message>
        <source>The values whose surfaces are shown, each with its colour and opacity.</source>
        <translation>Die Werte, deren Flächen gezeigt werden, jeder mit Farbe und Deckkraft.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>The colour and the opacity of each value.</source>
        <translation>Farbe und Deckkraft jedes Wertes.</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Beleuchtet</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Begrenzungsquader</translation>
    </message>
    <message>
        <source>Draws the bounding box of the data.</source>
        <translation>Zeigt die Kanten des Quaders, den die Daten füllen.</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Schnittebenen</translation>
    </message>
    <message>
        <source>Clip planes as nx,ny,nz,offset; keeps the points with nx x + ny y + nz z &gt;= offset.</source>
        <translation>Schneidet weg, was vor einer Ebene liegt: nx,ny,nz,Abstand zeigt die Punkte mit nx x + ny y + nz z &gt;= Abstand.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>% of the value range</source>
        <translation>% des Wertebereichs</translation>
    </message>
    <message>
        <source>Warping</source>
        <translation>Verwerfung</translation>
    </message>
    <message>
        <source>% of the diagonal</source>
        <translation>% der Diagonale</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Where accuracy matters: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach or value:q,reach, several separated by &apos;;&apos;. Errors there count in full, and the weight falls linearly to a tenth (or to &apos;,floor&apos; at the end) at the distance &apos;reach&apos;; where several apply, the largest weight counts. Examples: &apos;point:16,16,8,10&apos;, &apos;value:120,15,0.05&apos;.</source>
        <translation>Wo Genauigkeit zählt: point:x,y,z,reichweite, box:x0,y0,z0,x1,y1,z1,reichweite oder value:q,reichweite, mehrere durch „;“ getrennt. Fehler zählen dort voll und fallen linear auf ein Zehntel (oder auf den Wert eines letzten „,boden“) in der Entfernung „reichweite“; es gilt das größte Gewicht. Beispiele: „point:16,16,8,10“, „value:120,15,0.05“.</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Which point is removed next: &apos;exact&apos; takes the one whose loss does the least harm, for the fewest points; &apos;paper&apos; estimates that by gradients and planes, as the paper did; &apos;rounds&apos; takes many points that are not neighbours at a time, so that a focus region needs the fewest additional points.</source>
        <translation>Welcher Punkt als nächster geht: „exakt“ nimmt den, dessen Verlust am wenigsten schadet, für die wenigsten Punkte; „Aufsatz“ schätzt das durch Gradienten und Ebenen, wie der Aufsatz; „Runden“ nimmt viele Punkte auf einmal, die einander nicht berühren, sodass ein Fokusbereich um sich herum am wenigsten braucht.</translation>
    </message>
    <message>
        <source>An irregular mesh: decimation keeps its shape and its cavities.</source>
        <translation>Ein unregelmäßiges Netz: Die Vergröberung erhält seine Form und seine Hohlräume.</translation>
    </message>
    <message>
        <source>A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.</source>
        <translation>Ein regelmäßiges Gitter: Die Vergröberung braucht für dieselbe Genauigkeit weniger Punkte, aber mehr Zeit und Speicher.</translation>
    </message>
    <message>
        <source>Decimation stops at this error; 0 continues to the coarsest mesh.</source>
        <translation>Die Vergröberung hält bei diesem Fehler an; 0 geht bis zum gröbsten Netz.</translation>
    </message>
    <message>
        <source>Finest error</source>
        <translation>Feinster Fehler</translation>
    </message>
    <message>
        <source>Leaves meshes of smaller errors out of the model, to make it smaller; 0 keeps everything.</source>
        <translation>Lässt Netze mit kleineren Fehlern aus dem Modell weg, sodass es kleiner wird; 0 behält alles.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>The block size &apos;%1&apos; is not &quot;automatic&quot;, &quot;none&quot; or a number of cells of at least 1.</source>
        <translation>Die Blockgröße „%1“ ist weder „automatisch“ noch „keine“ noch eine Zahl von Zellen ab 1.</translation>
    </message>
    <message>
        <source>A regular lattice: refinement keeps the exact domain and is the fastest method.</source>
        <translation>Ein regelmäßiges Gitter: Die Verfeinerung erhält das Gebiet genau und braucht die wenigste Zeit.</translation>
    </message>
    <message>
        <source>Scattered points: refinement fills their convex hull.</source>
        <translation>Verstreute Punkte: Die Verfeinerung füllt ihre konvexe Hülle.</translation>
    </message>
    <message>
        <source>Refinement stops at this error; 0 keeps everything, so that any accuracy can be shown later.</source>
        <translation>Die Verfeinerung hält bei diesem Fehler an; 0 behält alles, sodass später jede Genauigkeit gezeigt werden kann.</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be changed: %2. Check the permissions of its folder, and that there is space.</source>
        <translation>Die Vorlage „%1“ kann nicht geändert werden: %2. Prüfen Sie die Rechte des Ordners, und ob Platz ist.</translation>
    </message>
    <message>
        <source>The axis of values stays linear: a logarithmic one has no place for zero and negative values, and the data or the points begin at %1. Move the points above zero, or choose data with positive values.</source>
        <translation>Die Achse der Werte bleibt linear: Eine logarithmische hat keinen Platz für null und weniger, und die Daten oder die Punkte beginnen bei %1. Verschieben Sie die Punkte über null, oder wählen Sie Daten mit positiven Werten.</translation>
    </message>
    <message>
        <source>The clipboard holds no points of a transfer function. Copy some here or in another window. %1</source>
        <translation>Die Zwischenablage enthält keine Punkte einer Transferfunktion. Kopieren Sie welche, hier oder in einem anderen Fenster. %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a colour. Give #rrggbb in hexadecimal, or one of %2.</source>
        <translation>„%1“ ist keine Farbe. Geben Sie #rrggbb hexadezimal an, oder eine von %2.</translation>
    </message>
    <message>
        <source>It is written for plugin interface %1, and this program has %2. Install a newer version of TAn, or an older one of the plugin.</source>
        <translation>Es ist für die Plugin-Schnittstelle %1 geschrieben, und dieses Programm hat %2. Installieren Sie eine neuere Version von TAn oder eine ältere des Plugins.</translation>
    </message>
    <message>
        <source>Its metadata call it a %1, but it implements %2 instead of %3. Ask the plugin&apos;s author for a fixed version.</source>
        <translation>Seine Metadaten nennen es einen %1, aber es implementiert %2 statt %3. Bitten Sie den Autor des Plugins um eine berichtigte Version.</translation>
    </message>
    <message>
        <source>It was built with Qt %1, and this program runs with Qt %2. Install a build of the plugin for this Qt.</source>
        <translation>Es wurde mit Qt %1 gebaut, und dieses Programm läuft mit Qt %2. Installieren Sie das Plugin für dieses Qt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is an archive. Unpack it first, with &apos;%2&apos;, and open what is in it.</source>
        <translation>„%1“ ist gepackt. Entpacken Sie die Datei zuerst mit „%2“, und öffnen Sie, was darin ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has an unknown format. %2%3</source>
        <translation>„%1“ hat ein unbekanntes Format. %2%3</translation>
    </message>
    <message>
        <source>No reader is installed.</source>
        <translation>Es ist kein Leser installiert.</translation>
    </message>
    <message>
        <source>%1 (It was unpacked on its own. If it refers to other files, unpack it next to them: gunzip.)</source>
        <translation>%1 (Die Datei wurde für sich entpackt. Wenn sie andere Dateien nennt, entpacken Sie sie neben diesen: gunzip.)</translation>
    </message>
    <message>
        <source>reader &apos;%1&apos;</source>
        <translation>Leser „%1“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a TAn model, but a dataset is needed here: the file that the model was built from.</source>
        <translation>„%1“ ist ein TAn-Modell, und hier wird ein Datensatz verlangt: die Datei, aus der das Modell gebaut wurde.</translation>
    </message>
    <message>
        <source>No writer is installed.</source>
        <translation>Es ist kein Schreiber installiert.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which is missing or cannot be used. Install it.</source>
        <translation>Es braucht das Plugin „%1“, das fehlt oder nicht benutzbar ist. Installieren Sie es.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which cannot be used: %2</source>
        <translation>Es braucht das Plugin „%1“, das nicht benutzbar ist: %2</translation>
    </message>
    <message>
        <source>Plugins depend on each other in a circle: %1. Remove one of them.</source>
        <translation>Plugins brauchen einander im Kreis: %1. Entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not exist, or its folder may not be entered. Check the name.</source>
        <translation>„%1“ gibt es nicht, oder der Ordner ist nicht zugänglich. Prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder. Choose a file inside it.</source>
        <translation>„%1“ ist ein Ordner. Wählen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a device or a pipe. Give a file.</source>
        <translation>„%1“ ist ein Gerät oder eine Pipe. Wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. The copy may be incomplete: copy the file again.</source>
        <translation>„%1“ ist leer. Vielleicht ist die Kopie unvollständig: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The library %1 is missing. %2</source>
        <translation>Die Bibliothek %1 fehlt. %2</translation>
    </message>
    <message>
        <source>Install the package that contains it (on Debian, &apos;%1&apos; names it), or remove the plugin.</source>
        <translation>Installieren Sie das Paket, das sie enthält (auf Debian nennt es „%1“), oder entfernen Sie das Plugin.</translation>
    </message>
    <message>
        <source>It needs the function %1, which no library here provides: it was built for another version of TAn or of a library. %2</source>
        <translation>Es braucht die Funktion %1, die hier keine Bibliothek hat: Es wurde für eine andere Version von TAn oder einer Bibliothek gebaut. %2</translation>
    </message>
    <message>
        <source>Rebuild it, or install the version for this program.</source>
        <translation>Bauen Sie es neu, oder installieren Sie die Version für dieses Programm.</translation>
    </message>
    <message>
        <source>It could not be loaded: %1 %2</source>
        <translation>Es konnte nicht geladen werden: %1 %2</translation>
    </message>
    <message>
        <source>Install it again, or remove it.</source>
        <translation>Installieren Sie es noch einmal, oder entfernen Sie es.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; does not accept &apos;%2&apos;: %3</source>
        <translation>„%1“ nimmt „%2“ nicht an: %3</translation>
    </message>
    <message>
        <source>%1
%2: %3</source>
        <translation>%1
%2: %3</translation>
    </message>
    <message>
        <source>No builder accepts &apos;%1&apos;.%2%3</source>
        <translation>Kein Erbauer nimmt „%1“ an.%2%3</translation>
    </message>
    <message>
        <source>builder &apos;%1&apos;</source>
        <translation>Erbauer „%1“</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is the input &apos;%2&apos;. Give the output another name.</source>
        <translation>Das Ziel „%1“ ist die Quelle „%2“. Geben Sie dem Ziel einen anderen Namen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists and has the same name as the dataset that the model was built from, so it is not overwritten. Give the output another name, or remove that file first.</source>
        <translation>„%1“ gibt es und heißt wie der Datensatz, aus dem das Modell gebaut wurde, wird also nicht überschrieben. Geben Sie der Ausgabe einen anderen Namen, oder entfernen Sie die Datei zuerst.</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and damaged or cut short. The copy may be incomplete: copy the file again.</source>
        <translation>Sie ist mit gzip komprimiert und beschädigt oder abgeschnitten. Vielleicht ist die Kopie unvollständig: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>there is not enough memory to unpack it.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um sie zu entpacken.</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and cannot be unpacked into &apos;%1&apos;: %2. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>Sie ist mit gzip komprimiert und kann nicht nach „%1“ entpackt werden: %2. Schaffen Sie dort Platz, setzen Sie TMPDIR auf einen Ordner mit mehr, oder entpacken Sie sie selbst (gunzip).</translation>
    </message>
    <message>
        <source>Unpacking</source>
        <translation>Entpacken</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and unpacks to more than %1, half of the space in &apos;%2&apos;. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>Sie ist mit gzip komprimiert und entpackt größer als %1, die Hälfte des Platzes in „%2“. Schaffen Sie dort Platz, setzen Sie TMPDIR auf einen Ordner mit mehr, oder entpacken Sie sie selbst (gunzip).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not fit &apos;%2&apos;: it takes %3.</source>
        <translation>„%1“ passt nicht zu „%2“: Erwartet wird %3.</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>isovalues %1</source>
        <translation>Isowerte %1</translation>
    </message>
    <message>
        <source>a transfer function as JSON</source>
        <translation>eine Transferfunktion als JSON</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an isovalue. Give VALUE, VALUE:COLOUR or VALUE:COLOUR:OPACITY, the opacity above 0 and at most 1: 128:#ff8000:0.5</source>
        <translation>„%1“ ist kein Isowert. Geben Sie WERT, WERT:FARBE oder WERT:FARBE:DECKKRAFT an, die Deckkraft über 0 und höchstens 1: 128:#ff8000:0.5</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, in %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a regular lattice</source>
        <translation>„%1“ ist ein regelmäßiges Gitter</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a curvilinear grid</source>
        <translation>„%1“ ist ein krummliniges Gitter</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is an irregular mesh</source>
        <translation>„%1“ ist ein unregelmäßiges Netz</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has scattered points</source>
        <translation>„%1“ besteht aus verstreuten Punkten</translation>
    </message>
    <message>
        <source>The %1 has no parameter &apos;%2&apos;. %3</source>
        <translation>Der %1 kennt keinen Parameter „%2“. %3</translation>
    </message>
    <message>
        <source>It has none.</source>
        <translation>Es gibt keine.</translation>
    </message>
    <message>
        <source>Available: %1.</source>
        <translation>Verfügbar: %1.</translation>
    </message>
    <message>
        <source>The parameter &apos;%1&apos; of the %2 takes %3.</source>
        <translation>Der Parameter „%1“ von %2 erwartet %3.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is for %2 data only, and %3. Leave it out.</source>
        <translation>„%1“ gilt nur für diese Art von Daten: %2; doch %3. Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; applies only if &apos;%2&apos; is %3. Leave it out, or choose that.</source>
        <translation>„%1“ ist nur von Nutzen, wenn „%2“ %3 ist. Lassen Sie es weg, oder wählen Sie das.</translation>
    </message>
    <message>
        <source>This machine does not have enough memory for &apos;%1&apos; here. Close other programs, or give it smaller data.</source>
        <translation>Der Arbeitsspeicher dieses Rechners reicht hier nicht für „%1“. Schließen Sie andere Programme, oder nehmen Sie kleinere Daten.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed: %2. This is a fault of the plugin; tell its author.</source>
        <translation>Das Plugin „%1“ ist gescheitert: %2. Das ist ein Fehler des Plugins; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>It is not a plugin, or is damaged: %1 Install it again, or remove the file.</source>
        <translation>Es ist kein Plugin oder beschädigt: %1 Installieren Sie es noch einmal, oder entfernen Sie die Datei.</translation>
    </message>
    <message>
        <source>%1
The plugin %2 (%3) is not used. %4</source>
        <translation>%1
Das Plugin %2 (%3) wird nicht benutzt. %4</translation>
    </message>
    <message>
        <source>Not all plugins can be loaded now: %1 %2</source>
        <translation>Jetzt können nicht alle Plugins geladen werden: %1 %2</translation>
    </message>
    <message>
        <source>It is disabled by the settings or by %1.</source>
        <translation>Es ist durch die Einstellungen oder durch %1 abgeschaltet.</translation>
    </message>
    <message>
        <source>Another plugin has the same id and was found first: %1. Remove one of the two.</source>
        <translation>Ein anderes Plugin hat dieselbe Kennung und wurde zuerst gefunden: %1. Entfernen Sie eines der beiden.</translation>
    </message>
    <message>
        <source>The %1 &quot;%2&quot; cannot be used. %3</source>
        <translation>Der %1 „%2“ kann nicht benutzt werden. %3</translation>
    </message>
    <message>
        <source>There is no %1 &quot;%2&quot;. %3</source>
        <translation>Einen %1 „%2“ gibt es nicht. %3</translation>
    </message>
    <message>
        <source>None is installed.</source>
        <translation>Es ist keiner installiert.</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; cannot be used. %2</source>
        <translation>Das Plugin „%1“ kann nicht benutzt werden. %2</translation>
    </message>
    <message>
        <source>It failed to start: %1. Install it again.</source>
        <translation>Es ist beim Start gescheitert: %1. Installieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Its metadata call it a %1, but it does not implement %2. Ask the plugin&apos;s author for a fixed version.</source>
        <translation>Seine Metadaten nennen es einen %1, aber es implementiert %2 nicht. Bitten Sie den Autor des Plugins um eine berichtigte Version.</translation>
    </message>
    <message>
        <source>builder</source>
        <translation>Erbauer</translation>
    </message>
    <message>
        <source>renderer</source>
        <translation>Darsteller</translation>
    </message>
    <message>
        <source>reader</source>
        <translation>Leser</translation>
    </message>
    <message>
        <source>writer</source>
        <translation>Schreiber</translation>
    </message>
    <message>
        <source>editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <source>Its metadata are malformed: %1. Ask the plugin&apos;s author for a fixed version.</source>
        <translation>Seine Metadaten sind fehlerhaft: %1. Bitten Sie den Autor des Plugins um eine berichtigte Version.</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>der Schlüssel „%1“ fehlt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a string</source>
        <translation>„%1“ ist kein Text</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is &quot;%2&quot;, which is not a version like &quot;1.2.3&quot;</source>
        <translation>„%1“ ist „%2“, und das ist keine Version wie „1.2.3“</translation>
    </message>
    <message>
        <source>&quot;requires&quot; is not a list</source>
        <translation>„requires“ ist keine Liste</translation>
    </message>
    <message>
        <source>&quot;requires&quot; lists something that is not the id of a plugin</source>
        <translation>„requires“ nennt etwas, das keine Kennung eines Plugins ist</translation>
    </message>
    <message>
        <source>&quot;id&quot; is &quot;%1&quot;; it may contain only lower-case letters, digits, &apos;.&apos;, &apos;-&apos; and &apos;_&apos;</source>
        <translation>„id“ ist „%1“; nur Kleinbuchstaben, Ziffern, „.“, „-“ und „_“ dürfen darin stehen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a component of an array that has %2: give &apos;magnitude&apos;, or a number from 0 to %3.</source>
        <translation>„%1“ ist keine Komponente eines Feldes, das %2 hat: Geben Sie „magnitude“ an, oder eine Nummer von 0 bis %3.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. Available: %2.</source>
        <translation>Sie hat kein Feld „%1“. Es gibt: %2.</translation>
    </message>
    <message>
        <source>it changed while it was read. Read it again.</source>
        <translation>Sie hat sich beim Lesen verändert. Lesen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Not enough memory to read &apos;%1&apos;. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um „%1“ zu lesen. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>VTK unstructured grid (*.vtu)</source>
        <translation>Unstrukturiertes VTK-Gitter (*.vtu)</translation>
    </message>
    <message>
        <source>AVS UCD mesh (*.inp)</source>
        <translation>AVS-UCD-Netz (*.inp)</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>The array whose values to take, of points or of cells; by default the one the file calls active, else the first.</source>
        <translation>Das Feld, dessen Werte genommen werden, von Punkten oder Zellen; ohne Angabe das, das die Datei aktiv nennt, sonst das erste.</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>the first line is not five numbers: of points, of cells, of values per point, per cell and of the model</source>
        <translation>die erste Zeile besteht nicht aus fünf Zahlen: die der Punkte, der Zellen, der Werte je Punkt, je Zelle und des Modells</translation>
    </message>
    <message>
        <source>it is too short for %1 points and %2 cells</source>
        <translation>sie ist zu kurz für %1 Punkte und %2 Zellen</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>a point is not its number and three coordinates</source>
        <translation>ein Punkt besteht nicht aus seiner Nummer und drei Koordinaten</translation>
    </message>
    <message>
        <source>the number of a point appears twice</source>
        <translation>die Nummer eines Punktes kommt zweimal vor</translation>
    </message>
    <message>
        <source>a cell is not its number, its material and its shape: pt, line, tri, quad, tet, pyr, prism or hex</source>
        <translation>eine Zelle besteht nicht aus ihrer Nummer, ihrem Material und ihrer Form: pt, line, tri, quad, tet, pyr, prism oder hex</translation>
    </message>
    <message>
        <source>the list of values is missing</source>
        <translation>die Liste der Werte fehlt</translation>
    </message>
    <message>
        <source>the line before the values does not hold their number and how many components each has</source>
        <translation>die Zeile vor den Werten nennt nicht ihre Anzahl und wie viele Komponenten jeder hat</translation>
    </message>
    <message>
        <source>the components of the values do not add up to what the first line states</source>
        <translation>die Komponenten der Werte ergeben zusammen nicht, was die erste Zeile sagt</translation>
    </message>
    <message>
        <source>the name of a value is missing</source>
        <translation>der Name eines Wertes fehlt</translation>
    </message>
    <message>
        <source>a value belongs to a number that no point or cell has</source>
        <translation>ein Wert gehört zu einer Nummer, die kein Punkt und keine Zelle hat</translation>
    </message>
    <message>
        <source>a value is missing or not a number</source>
        <translation>ein Wert fehlt oder ist keine Zahl</translation>
    </message>
    <message>
        <source>the file ends early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>line %1: %2.</source>
        <translation>Zeile %1: %2.</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 %3</source>
        <translation>die Datei endet nach %1 von %2: %3</translation>
    </message>
    <message>
        <source>a corner of a cell is not the number of a point</source>
        <translation>eine Ecke einer Zelle ist nicht die Nummer eines Punktes</translation>
    </message>
    <message>
        <source>a cell has more corners than its shape</source>
        <translation>eine Zelle hat mehr Ecken als ihre Form</translation>
    </message>
    <message>
        <source>it is a binary UCD file, and only text is read. Write it as text, or as .vtu, for instance with ParaView.</source>
        <translation>Sie ist eine binäre UCD-Datei, und nur Text wird gelesen. Schreiben Sie sie als Text oder als .vtu, etwa mit ParaView.</translation>
    </message>
    <message>
        <source>is too short for %1 numbers, or cut short</source>
        <translation>ist zu kurz für %1 Zahlen, oder abgeschnitten</translation>
    </message>
    <message>
        <source>has %1 bytes, not the %2 of %3 numbers</source>
        <translation>hat %1 Bytes und nicht die %2 von %3 Zahlen</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>ist beschädigt: Es kann nicht entpackt werden</translation>
    </message>
    <message>
        <source>is too short for %1 numbers</source>
        <translation>ist zu kurz für %1 Zahlen</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; among its numbers</source>
        <translation>hat „%1“ zwischen seinen Zahlen</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>hat mehr als %1 Zahlen</translation>
    </message>
    <message>
        <source>has %1 numbers, not %2</source>
        <translation>hat %1 Zahlen und nicht %2</translation>
    </message>
    <message>
        <source>is of type &apos;%1&apos;, which is not a number</source>
        <translation>ist vom Typ „%1“, der keine Zahl ist</translation>
    </message>
    <message>
        <source>has the unknown format &apos;%1&apos;</source>
        <translation>hat das unbekannte Format „%1“</translation>
    </message>
    <message>
        <source>is of type &apos;%1&apos;, not of whole numbers</source>
        <translation>ist vom Typ „%1“ und nicht aus ganzen Zahlen</translation>
    </message>
    <message>
        <source>a piece claims to have more points than possible.</source>
        <translation>Ein Stück will mehr Punkte haben, als es geben kann.</translation>
    </message>
    <message>
        <source>its points do not have three coordinates each.</source>
        <translation>Ihre Punkte haben nicht je drei Koordinaten.</translation>
    </message>
    <message>
        <source>not every piece has the array &apos;%1&apos;.</source>
        <translation>Nicht jedes Stück hat das Feld „%1“.</translation>
    </message>
    <message>
        <source>a piece claims to have more values than possible.</source>
        <translation>Ein Stück will mehr Werte haben, als es geben kann.</translation>
    </message>
    <message>
        <source>the offsets of its cells do not rise.</source>
        <translation>Die Anfänge ihrer Zellen steigen nicht.</translation>
    </message>
    <message>
        <source>a cell has the corner %1 of %2 points.</source>
        <translation>Eine Zelle hat die Ecke %1 von %2 Punkten.</translation>
    </message>
    <message>
        <source>it does not begin with &lt;VTKFile&gt;, so it is not a VTK XML file.</source>
        <translation>Sie beginnt nicht mit &lt;VTKFile&gt;, ist also keine VTK-XML-Datei.</translation>
    </message>
    <message>
        <source>its XML is damaged or cut short.</source>
        <translation>Ihr XML ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>it holds a %1, not an UnstructuredGrid. The VTK plugin reads those.</source>
        <translation>Sie enthält ein %1, kein UnstructuredGrid. Das VTK-Plugin liest solche.</translation>
    </message>
    <message>
        <source>a piece does not say how many points and cells it has.</source>
        <translation>Ein Stück sagt nicht, wie viele Punkte und Zellen es hat.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; has %2 components.</source>
        <translation>Das Feld „%1“ hat %2 Komponenten.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; does not say where it is.</source>
        <translation>Das Feld „%1“ sagt nicht, wo es steht.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; does not end.</source>
        <translation>Das Feld „%1“ endet nicht.</translation>
    </message>
    <message>
        <source>its appended data do not begin.</source>
        <translation>Ihre angehängten Daten beginnen nicht.</translation>
    </message>
    <message>
        <source>it has no piece with points and cells.</source>
        <translation>Sie hat kein Stück mit Punkten und Zellen.</translation>
    </message>
    <message>
        <source>a piece has no array &apos;%1&apos;.</source>
        <translation>Ein Stück hat kein Feld „%1“.</translation>
    </message>
    <message>
        <source>A .vtu file holds a mesh of tetrahedra, and this dataset is not one. Write lattices as .nrrd, curvilinear grids as .xyz, points as .csv.</source>
        <translation>Eine .vtu-Datei enthält ein Tetraedernetz, und dieser Datensatz ist keines. Schreiben Sie regelmäßige Gitter als .nrrd, krummlinige Gitter als .xyz, Punkte als .csv.</translation>
    </message>
    <message>
        <source>its compressed data are damaged (%1). Copy the file again.</source>
        <translation>Ihre komprimierten Daten sind beschädigt (%1). Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Not enough memory to unpack gzip data. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um gzip-Daten zu entpacken. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>they are cut short</source>
        <translation>sie sind abgeschnitten</translation>
    </message>
    <message>
        <source>another part cannot be started</source>
        <translation>ein neuer Teil kann nicht begonnen werden</translation>
    </message>
    <message>
        <source>its compressed data hold more than %1 bytes where the description requires %2. The sizes or the type are wrong, or the data belong to another file.</source>
        <translation>Ihre komprimierten Daten enthalten mehr als %1 Bytes, wo die Beschreibung %2 verlangt. Die Größen oder der Typ sind falsch, oder die Daten gehören zu einer anderen Datei.</translation>
    </message>
    <message>
        <source>its compressed data hold only %1 bytes where the description requires %2. The sizes or the type are wrong, or the data belong to another file.</source>
        <translation>Ihre komprimierten Daten enthalten nur %1 Bytes, wo die Beschreibung %2 verlangt. Die Größen oder der Typ sind falsch, oder die Daten gehören zu einer anderen Datei.</translation>
    </message>
    <message>
        <source>Not enough memory to compress the data. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um die Daten zu komprimieren. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1 The header &apos;%2&apos; names it as its data file.</source>
        <translation>%1 Der Kopf „%2“ nennt sie als seine Datendatei.</translation>
    </message>
    <message>
        <source>it is empty. Get or make the file again.</source>
        <translation>Sie ist leer. Holen oder erzeugen Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>NRRD volume (*.nrrd *.nhdr)</source>
        <translation>NRRD-Volumen (*.nrrd *.nhdr)</translation>
    </message>
    <message>
        <source>Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)</source>
        <translation>Rohes Volumen (*.raw *.bin *.binary *.dat *.img *.vol)</translation>
    </message>
    <message>
        <source>must have one entry for each of the %1 axes.</source>
        <translation>muss einen Eintrag für jede der %1 Achsen haben.</translation>
    </message>
    <message>
        <source>its header has no field &apos;dimension&apos;.</source>
        <translation>Ihr Kopf hat kein Feld „dimension“.</translation>
    </message>
    <message>
        <source>must be a number from 1 to 16.</source>
        <translation>muss eine Zahl von 1 bis 16 sein.</translation>
    </message>
    <message>
        <source>its header has no field &apos;sizes&apos;.</source>
        <translation>Ihr Kopf hat kein Feld „sizes“.</translation>
    </message>
    <message>
        <source>must be whole numbers from 1.</source>
        <translation>muss aus ganzen Zahlen ab 1 bestehen.</translation>
    </message>
    <message>
        <source>must be numbers.</source>
        <translation>muss aus Zahlen bestehen.</translation>
    </message>
    <message>
        <source>must be &apos;none&apos; or three numbers in parentheses for each axis.</source>
        <translation>muss „none“ sein oder drei Zahlen in Klammern für jede Achse.</translation>
    </message>
    <message>
        <source>line %1 of its header %2</source>
        <translation>Zeile %1 ihres Kopfes %2</translation>
    </message>
    <message>
        <source>it is not an NRRD file: it does not begin with &apos;NRRD0001&apos; to &apos;NRRD0005&apos;.</source>
        <translation>Sie ist keine NRRD-Datei: Sie beginnt nicht mit „NRRD0001“ bis „NRRD0005“.</translation>
    </message>
    <message>
        <source>it has the unknown NRRD version &apos;%1&apos;. Save it as NRRD0005 or earlier.</source>
        <translation>Sie hat eine NRRD-Version, die nicht bekannt ist: „%1“. Speichern Sie sie als NRRD0005 oder früher.</translation>
    </message>
    <message>
        <source>is neither a field nor a comment: &apos;%1&apos;.</source>
        <translation>ist weder ein Feld noch ein Kommentar: „%1“.</translation>
    </message>
    <message>
        <source>has the unknown field &apos;%1&apos;. Correct its name, or write &apos;:=&apos; for a note of your own.</source>
        <translation>hat das unbekannte Feld „%1“. Berichtigen Sie seinen Namen, oder schreiben Sie „:=“ für eine eigene Notiz.</translation>
    </message>
    <message>
        <source>gives &apos;%1&apos; a second time. Remove one of them.</source>
        <translation>gibt „%1“ ein zweites Mal an. Entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>its header does not end: there is no empty line in the first MiB.</source>
        <translation>Ihr Kopf endet nicht: Im ersten MiB steht keine leere Zeile.</translation>
    </message>
    <message>
        <source>it has %1 dimensions, %2 of them with more than one point. A volume has three: take out a part that has, such as one component or one time step.</source>
        <translation>Sie hat %1 Dimensionen, davon %2 mit mehr als einem Punkt. Ein Volumen hat drei: Nehmen Sie einen Teil heraus, der so ist, etwa eine Komponente oder einen Zeitschritt.</translation>
    </message>
    <message>
        <source>one of its axes, of size %1, holds &apos;%2&apos; instead of points. Take out one component first.</source>
        <translation>Eine ihrer Achsen, der Größe %1, enthält „%2“ statt Punkten. Nehmen Sie zuerst eine Komponente heraus.</translation>
    </message>
    <message>
        <source>its header gives the spacing of some axes only. Give all three, or none.</source>
        <translation>Ihr Kopf gibt den Abstand nur für einige Achsen an. Geben Sie alle drei an oder keinen.</translation>
    </message>
    <message>
        <source>its space origin &apos;%1&apos; is not three numbers in parentheses.</source>
        <translation>Ihr „space origin“ „%1“ besteht nicht aus drei Zahlen in Klammern.</translation>
    </message>
    <message>
        <source>its space directions are given for some axes only. Give them for all three, or for none.</source>
        <translation>Ihre „space directions“ sind nur für einige Achsen angegeben. Geben Sie sie für alle drei an oder für keine.</translation>
    </message>
    <message>
        <source>its header has no field &apos;%1&apos;. Add it.</source>
        <translation>Ihr Kopf hat kein Feld „%1“. Fügen Sie es hinzu.</translation>
    </message>
    <message>
        <source>its &apos;line skip&apos; must be a whole number of at least 0.</source>
        <translation>Ihr „line skip“ muss eine ganze Zahl ab 0 sein.</translation>
    </message>
    <message>
        <source>its &apos;byte skip&apos; must be a whole number of at least 0, or -1 for raw data at the end of the file.</source>
        <translation>Ihr „byte skip“ muss eine ganze Zahl ab 0 sein, oder -1 für rohe Daten am Ende der Datei.</translation>
    </message>
    <message>
        <source>its data file is called &apos;%1&apos;, with characters that no name should contain. Correct it.</source>
        <translation>Ihre Datendatei heißt „%1“, mit Zeichen, die kein Name haben sollte. Berichtigen Sie ihn.</translation>
    </message>
    <message>
        <source>its type is &apos;block&apos;, which does not describe the samples. Convert them to a number type first.</source>
        <translation>Ihr Typ ist „block“, der nichts über die Abtastwerte sagt. Wandeln Sie sie zuerst in einen Zahlentyp um.</translation>
    </message>
    <message>
        <source>its byte order &apos;%1&apos; is not known. Use little or big.</source>
        <translation>Ihre Bytefolge „%1“ ist nicht bekannt. Es gibt little und big.</translation>
    </message>
    <message>
        <source>its encoding &apos;%1&apos; is not read. Save it with the encoding raw, gzip or ascii.</source>
        <translation>Ihre Kodierung „%1“ wird nicht gelesen. Speichern Sie sie mit der Kodierung raw, gzip oder ascii.</translation>
    </message>
    <message>
        <source>NRRD files are written with the encoding raw or gzip, not &apos;%1&apos;.</source>
        <translation>NRRD-Dateien werden mit der Kodierung raw oder gzip geschrieben, nicht „%1“.</translation>
    </message>
    <message>
        <source>NRRD files hold regular lattices, and &apos;%1&apos; is %2. Give the file another ending: .xyz for curvilinear grids, .csv for scattered points.</source>
        <translation>NRRD-Dateien enthalten regelmäßige Gitter, und „%1“ ist %2. Geben Sie der Datei eine andere Endung: .xyz für krummlinige Gitter, .csv für verstreute Punkte.</translation>
    </message>
    <message>
        <source>%1, or %2</source>
        <translation>%1, oder %2</translation>
    </message>
    <message>
        <source>it is raw data, whose %1 bytes do not say how they are laid out. Describe them: size and type at least, for example %2.</source>
        <translation>Sie enthält rohe Daten, deren %1 Bytes nicht sagen, wie sie angeordnet sind. Beschreiben Sie sie: mindestens Größe und Typ, zum Beispiel %2.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Raw files: the number of points along x (which runs fastest), y and z, as in 256x256x128.</source>
        <translation>Rohdateien: die Zahl der Punkte entlang x (läuft am schnellsten), y und z, etwa 256x256x128.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Raw files: the type of a sample.</source>
        <translation>Rohdateien: der Typ eines Abtastwerts.</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Bytefolge</translation>
    </message>
    <message>
        <source>Raw files: little (PC) or big endian, for types of more than one byte.</source>
        <translation>Rohdateien: little (PC) oder big endian, für Typen aus mehr als einem Byte.</translation>
    </message>
    <message>
        <source>little</source>
        <translation>Little-Endian (PC)</translation>
    </message>
    <message>
        <source>big</source>
        <translation>Big-Endian</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Raw files: the length of a header before the samples.</source>
        <translation>Rohdateien: die Länge eines Kopfes vor den Abtastwerten.</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>the number of bytes to skip cannot be negative.</source>
        <translation>Die Zahl der zu überspringenden Bytes darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 samples of type %4, %5 bytes</source>
        <translation>%1 × %2 × %3 Abtastwerte vom Typ %4, %5 Bytes</translation>
    </message>
    <message>
        <source>it should hold %1, but there are only %2. It is cut short, or its description (sizes, type, bytes to skip) is wrong.</source>
        <translation>Sie sollte %1 enthalten, es sind aber nur %2. Sie ist abgeschnitten, oder die Beschreibung (Größen, Typ, zu überspringende Bytes) ist falsch.</translation>
    </message>
    <message>
        <source>it has only %1 of the %2 lines to be skipped. Check &apos;line skip&apos;.</source>
        <translation>Sie hat nur %1 der %2 Zeilen, die übersprungen werden sollen. Prüfen Sie „line skip“.</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Bytes</translation>
    </message>
    <message>
        <source>it should hold %1, but there are %2, %3 too many. Its description is wrong: check the sizes, the type and the bytes to skip.</source>
        <translation>Sie sollte %1 enthalten, es sind aber %2, %3 zu viel. Die Beschreibung ist falsch: Prüfen Sie Größen, Typ und zu überspringende Bytes.</translation>
    </message>
    <message>
        <source>%1 bytes of compressed data</source>
        <translation>%1 Bytes komprimierter Daten</translation>
    </message>
    <message>
        <source>%1 bytes of text</source>
        <translation>%1 Bytes Text</translation>
    </message>
    <message>
        <source>its text holds more than the %1 numbers that the description requires. Check the sizes.</source>
        <translation>Ihr Text enthält mehr als die %1 Zahlen, die die Beschreibung verlangt. Prüfen Sie die Größen.</translation>
    </message>
    <message>
        <source>number %1 of its text, &apos;%2&apos;, is not a number of this type. Correct it, or the type.</source>
        <translation>Zahl %1 ihres Textes, „%2“, ist keine Zahl des Typs. Berichtigen Sie sie oder den Typ.</translation>
    </message>
    <message>
        <source>its text holds only %1 numbers where the description requires %2. It is cut short, or the sizes are wrong.</source>
        <translation>Ihr Text enthält nur %1 Zahlen, wo die Beschreibung %2 verlangt. Sie ist abgeschnitten, oder die Größen sind falsch.</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>velocity_magnitude</source>
        <translation>Geschwindigkeitsbetrag</translation>
    </message>
    <message>
        <source>momentum_magnitude</source>
        <translation>Impulsbetrag</translation>
    </message>
    <message>
        <source>momentum_x</source>
        <translation>Impuls entlang x</translation>
    </message>
    <message>
        <source>momentum_y</source>
        <translation>Impuls entlang y</translation>
    </message>
    <message>
        <source>momentum_z</source>
        <translation>Impuls entlang z</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>mach</source>
        <translation>Mach-Zahl</translation>
    </message>
    <message>
        <source>No array of this solution varies.</source>
        <translation>Kein Feld dieser Lösung ändert sich im Raum.</translation>
    </message>
    <message>
        <source>Available arrays: %1.</source>
        <translation>Diese können genommen werden: %1.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; has the same value everywhere. %2</source>
        <translation>Das Feld „%1“ hat überall denselben Wert. %2</translation>
    </message>
    <message>
        <source>none of its arrays varies, so there is nothing to see.</source>
        <translation>Keines ihrer Felder ändert sich im Raum, sodass es nichts zu sehen gibt.</translation>
    </message>
    <message>
        <source>the lengths of its Fortran records do not fit the sizes of its grids. Copy the file again.</source>
        <translation>Die Längen ihrer Fortran-Sätze passen nicht zu den Größen ihrer Gitter. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 bytes too many follow its data. Check that it is a PLOT3D file.</source>
        <translation>%1 Bytes zu viel stehen hinter ihren Daten. Prüfen Sie, ob sie eine PLOT3D-Datei ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no grid %2: it holds %3.</source>
        <translation>„%1“ hat kein Gitter %2: Es enthält %3.</translation>
    </message>
    <message>
        <source>its grid has %1 x %2 x %3 points. TAn takes volumes: at least two points along each of three axes.</source>
        <translation>Ihr Gitter hat %1 x %2 x %3 Punkte. TAn nimmt Volumen: mindestens zwei Punkte entlang jeder der drei Achsen.</translation>
    </message>
    <message>
        <source>it holds a two-dimensional grid. TAn takes volumes: grids with at least two points along each of three axes.</source>
        <translation>Sie enthält ein zweidimensionales Gitter. TAn nimmt Volumen: Gitter mit mindestens zwei Punkten entlang jeder der drei Achsen.</translation>
    </message>
    <message>
        <source>it begins like a grid of %1 points, which takes %2 bytes or more, and has %3</source>
        <translation>Sie beginnt wie ein Gitter aus %1 Punkten, das mindestens %2 Bytes braucht, und hat %3</translation>
    </message>
    <message>
        <source>%1: it is cut short. Copy the file again.</source>
        <translation>%1: Sie ist abgeschnitten. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1, which fits no kind of PLOT3D file.</source>
        <translation>%1, was zu keiner Art von PLOT3D-Datei passt.</translation>
    </message>
    <message>
        <source>it is a PLOT3D solution, and its grid is not next to it (%1). Open the grid, and give it the solution.</source>
        <translation>Sie ist eine PLOT3D-Lösung, und ihr Gitter ist nicht daneben (%1). Öffnen Sie das Gitter, und geben Sie ihm die Lösung.</translation>
    </message>
    <message>
        <source>it is a grid without values, and no solution is next to it (%1). Say where it is with &apos;solution&apos;, or give it one of these names.</source>
        <translation>Sie ist ein Gitter ohne Werte, und keine Lösung ist daneben (%1). Geben Sie mit „solution“ an, wo sie ist, oder benennen Sie sie entsprechend.</translation>
    </message>
    <message>
        <source>it is the solution of another grid: its sizes differ from those of &apos;%1&apos;. Choose another one with &apos;solution&apos;.</source>
        <translation>Sie ist die Lösung eines anderen Gitters: Ihre Größen sind nicht die von „%1“. Wählen Sie mit „solution“ eine andere.</translation>
    </message>
    <message>
        <source>PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</source>
        <translation>PLOT3D-Gitter und -Lösung (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Which scalar of the solution: automatic takes the density, or, if that is the same everywhere, the first that varies.</source>
        <translation>Welcher Skalar der Lösung: „automatisch“ nimmt die Dichte, oder wenn sie überall gleich ist, den ersten, der sich ändert.</translation>
    </message>
    <message>
        <source>Solution file</source>
        <translation>Lösungsdatei</translation>
    </message>
    <message>
        <source>The PLOT3D solution of the grid; by default the one next to it with a matching name.</source>
        <translation>Die PLOT3D-Lösung des Gitters; sonst die mit passendem Namen daneben.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>PLOT3D files hold points on a grid, and &apos;%1&apos; is not. Give the file another ending, such as .csv for scattered points.</source>
        <translation>PLOT3D-Dateien enthalten Punkte auf einem Gitter, und „%1“ nicht. Geben Sie der Datei eine andere Endung, etwa .csv für verstreute Punkte.</translation>
    </message>
    <message>
        <source>there is no column &apos;%1&apos;; there are %2, or give a number from 1 to %3.</source>
        <translation>Eine Spalte „%1“ gibt es nicht; es gibt %2, oder geben Sie eine Nummer von 1 bis %3 an.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not name the three columns of the positions. Give three names or numbers separated by commas, as in x,y,z or 1,2,3.</source>
        <translation>„%1“ nennt nicht die drei Spalten der Positionen. Geben Sie drei Namen oder Nummern an, durch Kommas getrennt, wie in x,y,z oder 1,2,3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names the same column twice.</source>
        <translation>„%1“ nennt dieselbe Spalte zweimal.</translation>
    </message>
    <message>
        <source>it has %1 columns, and points need at least four: x, y, z and a value.</source>
        <translation>Sie hat %1 Spalten, und Punkte brauchen mindestens vier: x, y, z und einen Wert.</translation>
    </message>
    <message>
        <source>1 incomplete row was skipped.</source>
        <translation>1 unvollständige Zeile wurde übergangen.</translation>
    </message>
    <message>
        <source>%1 incomplete rows were skipped.</source>
        <translation>%1 unvollständige Zeilen wurden übergangen.</translation>
    </message>
    <message>
        <source>Table of points (*.csv *.tsv *.xyz *.pts *.txt *.asc)</source>
        <translation>Tabelle von Punkten (*.csv *.tsv *.xyz *.pts *.txt *.asc)</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>The values to take, by name or number; &apos;automatic&apos; takes the first.</source>
        <translation>Welche Werte genommen werden, nach Name oder Nummer; „automatic“ nimmt die ersten.</translation>
    </message>
    <message>
        <source>Skip incomplete rows</source>
        <translation>Unvollständige Zeilen auslassen</translation>
    </message>
    <message>
        <source>Tables of points: leave out rows with a missing number, instead of refusing the file.</source>
        <translation>Tabellen von Punkten: Zeilen auslassen, denen eine Zahl fehlt, statt die Datei abzulehnen.</translation>
    </message>
    <message>
        <source>it has more than 4294967295 points. Take a part of them.</source>
        <translation>Sie hat mehr als 4294967295 Punkte. Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>%1 has a double quote that is not closed.</source>
        <translation>%1 hat ein Anführungszeichen, das nicht geschlossen wird.</translation>
    </message>
    <message>
        <source>it holds no points.</source>
        <translation>Sie enthält keine Punkte.</translation>
    </message>
    <message>
        <source>%1, %2: a number is missing. Add it, or have incomplete rows skipped.</source>
        <translation>%1, %2: Da ist keine Zahl. Fügen Sie sie hinzu, oder lassen Sie unvollständige Zeilen überspringen.</translation>
    </message>
    <message>
        <source>%1, %2: %3 is not a number. Numbers need a decimal point.</source>
        <translation>%1, %2: %3 ist keine Zahl. Zahlen brauchen einen Dezimalpunkt.</translation>
    </message>
    <message>
        <source>%1, %2: %3 is not a finite number.</source>
        <translation>%1, %2: %3 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>%1 has %2 columns, and the lines before have %3.</source>
        <translation>%1 hat %2 Spalten, und die davor haben %3.</translation>
    </message>
    <message>
        <source>%1, %2: %3 is too large for a position.</source>
        <translation>%1, %2: %3 ist zu groß für eine Position.</translation>
    </message>
    <message>
        <source>it is in UTF-16. Save it as UTF-8.</source>
        <translation>Sie ist in UTF-16. Speichern Sie sie als UTF-8.</translation>
    </message>
    <message>
        <source>it is not text.</source>
        <translation>Sie ist kein Text.</translation>
    </message>
    <message>
        <source>it is a chemical structure: elements and the positions of their atoms. A table of points is needed, with a value for each x, y and z.</source>
        <translation>Sie ist eine chemische Struktur: Elemente, und wo ihre Atome sind. Verlangt wird eine Tabelle von Punkten, mit einem Wert für jedes x, y und z.</translation>
    </message>
    <message>
        <source>%1 The file is damaged: copy or export it again.</source>
        <translation>%1 Die Datei ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it has %1 bytes of pixels of %2 (of %3 in all). It is damaged: copy the file again.</source>
        <translation>Sie hat %1 Bytes für Pixel statt %2 (von %3 insgesamt). Sie ist beschädigt: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it ends too early. Copy the file again.</source>
        <translation>Sie endet zu früh. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>ends in line %1, before the last %2. It is cut short: copy the file again.</source>
        <translation>endet in Zeile %1, ohne dass alles da ist (%2). Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; %2</source>
        <translation>Ihre Datei „%1“ %2</translation>
    </message>
    <message>
        <source>line &apos;FORMAT&apos;</source>
        <translation>Zeile „FORMAT“</translation>
    </message>
    <message>
        <source>does not begin with FORMAT. It is damaged, or not an EnSight case.</source>
        <translation>beginnt nicht mit FORMAT. Sie ist kein EnSight-Fall oder beschädigt.</translation>
    </message>
    <message>
        <source>line &apos;type:&apos;</source>
        <translation>Zeile „type:“</translation>
    </message>
    <message>
        <source>has a section &apos;%1&apos;, which VTK cannot skip. Remove it, or put it after the variables.</source>
        <translation>hat einen Abschnitt „%1“, den VTK nicht übergehen kann. Nehmen Sie ihn heraus, oder setzen Sie ihn hinter die Variablen.</translation>
    </message>
    <message>
        <source>names no geometry (&apos;model:&apos;). It is cut short or damaged.</source>
        <translation>nennt keine Geometrie („model:“). Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>number of a time set</source>
        <translation>Nummer eines Zeitsatzes</translation>
    </message>
    <message>
        <source>line &apos;number of steps:&apos;</source>
        <translation>Zeile „number of steps:“</translation>
    </message>
    <message>
        <source>number of time steps</source>
        <translation>Anzahl der Zeitschritte</translation>
    </message>
    <message>
        <source>states that there are %1 time steps.</source>
        <translation>will %1 Zeitschritte haben.</translation>
    </message>
    <message>
        <source>line &apos;time values:&apos;</source>
        <translation>Zeile „time values:“</translation>
    </message>
    <message>
        <source>first number of its files</source>
        <translation>erste Nummer ihrer Dateien</translation>
    </message>
    <message>
        <source>line &apos;filename increment:&apos;</source>
        <translation>Zeile „filename increment:“</translation>
    </message>
    <message>
        <source>increment of its files&apos; numbers</source>
        <translation>Schrittweite der Nummern ihrer Dateien</translation>
    </message>
    <message>
        <source>has %1 of %2 time values. It is cut short or damaged.</source>
        <translation>hat %1 von %2 Zeitwerten. Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>number of a file set</source>
        <translation>Nummer eines Dateisatzes</translation>
    </message>
    <message>
        <source>number of time steps in a file</source>
        <translation>Anzahl der Zeitschritte in einer Datei</translation>
    </message>
    <message>
        <source>number of a file</source>
        <translation>Nummer einer Datei</translation>
    </message>
    <message>
        <source>time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>line of its description</source>
        <translation>Zeile ihrer Beschreibung</translation>
    </message>
    <message>
        <source>line &apos;node id&apos;</source>
        <translation>Zeile „node id“</translation>
    </message>
    <message>
        <source>line &apos;element id&apos;</source>
        <translation>Zeile „element id“</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>line &apos;particle coordinates&apos;</source>
        <translation>Zeile „particle coordinates“</translation>
    </message>
    <message>
        <source>number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>does not state how many measured points it has. It is damaged.</source>
        <translation>sagt nicht, wie viele gemessene Punkte sie hat. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>measured point</source>
        <translation>gemessener Punkt</translation>
    </message>
    <message>
        <source>has no point in the line &apos;%1&apos;. It is cut short or damaged.</source>
        <translation>hat in der Zeile „%1“ keinen Punkt. Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>line &apos;coordinates&apos;</source>
        <translation>Zeile „coordinates“</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; where a part should begin; VTK skips this and all that follows. It is damaged, or of another version of the format: export it again.</source>
        <translation>hat „%1“, wo ein Teil beginnen sollte, was VTK mit allem Folgenden übergeht. Sie ist beschädigt oder von einer anderen Version des Formats: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>size of a block</source>
        <translation>Größe eines Blocks</translation>
    </message>
    <message>
        <source>has a block of the size &apos;%1&apos;. It is damaged.</source>
        <translation>hat einen Block der Größe „%1“. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>coordinate of a block</source>
        <translation>Koordinate eines Blocks</translation>
    </message>
    <message>
        <source>origin or spacing of a block</source>
        <translation>Ursprung oder Abstand eines Blocks</translation>
    </message>
    <message>
        <source>mark of a blanked point</source>
        <translation>Kennzeichen eines ausgeblendeten Punktes</translation>
    </message>
    <message>
        <source>number of a part</source>
        <translation>Nummer eines Teils</translation>
    </message>
    <message>
        <source>name of a part</source>
        <translation>Name eines Teils</translation>
    </message>
    <message>
        <source>kind of a part</source>
        <translation>Art eines Teils</translation>
    </message>
    <message>
        <source>element</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; where elements should begin. It is damaged, or of another version of the format: export it again.</source>
        <translation>hat „%1“, wo Elemente beginnen sollten. Sie ist beschädigt oder von einer anderen Version des Formats: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>number of elements</source>
        <translation>Anzahl der Elemente</translation>
    </message>
    <message>
        <source>number of faces</source>
        <translation>Anzahl der Seiten</translation>
    </message>
    <message>
        <source>number of corners</source>
        <translation>Anzahl der Ecken</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; where elements should begin, which VTK does not recognise. It is damaged, or of another version of the format: export it again.</source>
        <translation>hat „%1“, wo Elemente beginnen sollten, was VTK nicht kennt. Sie ist beschädigt oder von einer anderen Version des Formats: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>has an element with too few corners: &apos;%1&apos;. It is cut short or damaged.</source>
        <translation>hat ein Element mit zu wenigen Ecken: „%1“. Sie ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>has values of part &apos;%1&apos;, which the geometry does not have. One of the two is cut short, or they do not belong together.</source>
        <translation>hat Werte für Teil „%1“, den die Geometrie nicht hat. Eine der beiden ist abgeschnitten, oder sie gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>has values of &apos;%1&apos;, which the part does not have. It is damaged, or does not belong to the geometry.</source>
        <translation>hat Werte für „%1“, das der Teil nicht hat. Sie ist beschädigt oder gehört nicht zur Geometrie.</translation>
    </message>
    <message>
        <source>has no values of the elements &apos;%1&apos; of a part. It is cut short, or incomplete: export it again.</source>
        <translation>hat keine Werte für die Elemente „%1“ eines Teils. Sie ist abgeschnitten oder unvollständig: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>has vectors of a block in the text format of EnSight 6, which VTK reads wrongly. Write the case as EnSight Gold, or the data as .vts.</source>
        <translation>hat Vektoren eines Blocks im Textformat von EnSight 6, was VTK falsch liest. Schreiben Sie den Fall als EnSight Gold oder die Daten als .vts.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; is missing. Copy it into the same folder: they belong together.</source>
        <translation>Ihre Datei „%1“ fehlt. Kopieren Sie sie in den Ordner dieser Datei: Sie gehören zusammen.</translation>
    </message>
    <message>
        <source>%1 ends within a section. It is cut short: copy the file again.</source>
        <translation>%1 endet in einem Abschnitt. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its file %1, which holds the values, is missing. Copy it into the same folder.</source>
        <translation>Ihre Datei %1, die die Werte enthält, fehlt. Kopieren Sie sie in den Ordner dieser Datei.</translation>
    </message>
    <message>
        <source>%1 has no section. It is cut short, or of another format.</source>
        <translation>%1 hat keinen Abschnitt. Sie ist abgeschnitten oder von einem anderen Format.</translation>
    </message>
    <message>
        <source>it</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>its file %1</source>
        <translation>Ihre Datei %1</translation>
    </message>
    <message>
        <source>it is an HDF4 file, which is not read. Convert it to .vti or .vtu, for instance with h4toh5 and ParaView.</source>
        <translation>Sie ist eine HDF4-Datei, die nicht gelesen wird. Wandeln Sie sie um, etwa mit h4toh5 und ParaView, in .vti oder .vtu.</translation>
    </message>
    <message>
        <source>it does not begin like an HDF5 file. It is damaged, or of another format.</source>
        <translation>Sie beginnt nicht wie HDF5-Dateien. Sie ist beschädigt oder von einem anderen Format.</translation>
    </message>
    <message>
        <source>it is an HDF5 file of another program: it does not have the group VTKHDF, by which VTK recognises its own. Write it as .vti or .vtu.</source>
        <translation>Sie ist die HDF5-Datei eines anderen Programms: Sie hat keine Gruppe VTKHDF, an der VTK die seinen erkennt. Schreiben Sie sie als .vti oder .vtu.</translation>
    </message>
    <message>
        <source>it is a VTK HDF file with several time steps, which VTK 9.1 does not read. Write one time step as .vti or .vtu.</source>
        <translation>Sie ist eine VTK-HDF-Datei mit mehreren Zeitschritten, eine Art, die nach VTK 9.1 kam. Schreiben Sie einen Zeitschritt als .vti oder .vtu.</translation>
    </message>
    <message>
        <source>it is a VTK HDF file of the type %1, which VTK 9.1 does not read. Write it as .vti or .vtu.</source>
        <translation>Sie ist eine VTK-HDF-Datei vom Typ %1, der nach VTK 9.1 kam. Schreiben Sie sie als .vti oder .vtu.</translation>
    </message>
    <message>
        <source>it holds &apos;%1&apos;: values alone, without the points or the grid that they belong to. Write them with their grid.</source>
        <translation>Sie enthält „%1“: Werte allein, ohne Punkte oder ein Gitter, zu denen sie gehören. Schreiben Sie sie mit ihrem Gitter.</translation>
    </message>
    <message>
        <source>it has &apos;%1&apos; where DATASET and a type such as STRUCTURED_POINTS or UNSTRUCTURED_GRID should be. It is damaged, or was written by a faulty program.</source>
        <translation>Sie sagt „%1“, wo DATASET und ein Typ wie STRUCTURED_POINTS oder UNSTRUCTURED_GRID stehen sollte. Sie ist beschädigt oder von einem fehlerhaften Programm geschrieben.</translation>
    </message>
    <message>
        <source>The file ends without an end of line: if it was cut short there, its last number is wrong.</source>
        <translation>Die Datei endet ohne Zeilenende: Wenn sie dort abgeschnitten wurde, ist ihre letzte Zahl falsch.</translation>
    </message>
    <message>
        <source>its header does not state its ElementType. It is cut short: copy the file again.</source>
        <translation>Ihr Kopf nennt keinen ElementType. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its samples are of the type &apos;%1&apos;, which is not read. Write them as MET_INT, MET_FLOAT or MET_DOUBLE.</source>
        <translation>Ihre Abtastwerte sind vom Typ „%1“, der nicht gelesen wird. Schreiben Sie sie als MET_INT, MET_FLOAT oder MET_DOUBLE.</translation>
    </message>
    <message>
        <source>its header has no NDims.</source>
        <translation>Ihr Kopf hat kein NDims.</translation>
    </message>
    <message>
        <source>its DimSize is &apos;%1&apos; and not %2 numbers of points.</source>
        <translation>Ihre DimSize ist „%1“ und nicht %2 Anzahlen von Punkten.</translation>
    </message>
    <message>
        <source>its ElementNumberOfChannels is &apos;%1&apos;.</source>
        <translation>Ihre ElementNumberOfChannels ist „%1“.</translation>
    </message>
    <message>
        <source>its HeaderSize is &apos;%1&apos;.</source>
        <translation>Ihre HeaderSize ist „%1“.</translation>
    </message>
    <message>
        <source>its HeaderSize is -1, which has no meaning where samples are packed or text.</source>
        <translation>Ihre HeaderSize ist -1, was bei gepackten Abtastwerten oder Text nichts sagt.</translation>
    </message>
    <message>
        <source>its header has no line &apos;ElementDataFile = ...&apos;: it is cut short or not a MetaImage. Copy the file again.</source>
        <translation>Ihr Kopf hat keine Zeile „ElementDataFile = ...“, ist also abgeschnitten oder kein MetaImage. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its data file %1 is missing. Copy it into the same folder: the two belong together.</source>
        <translation>Ihre Datendatei %1 fehlt. Kopieren Sie sie in den Ordner dieser Datei: Die beiden gehören zusammen.</translation>
    </message>
    <message>
        <source>it should name %1 data files, each on a line of its own, and names %2. It is cut short: copy the file again.</source>
        <translation>Sie sollte %1 Datendateien nennen, jede in einer eigenen Zeile, die endet, und nennt %2. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its ElementDataFile is &apos;%1&apos;.</source>
        <translation>Ihr ElementDataFile ist „%1“.</translation>
    </message>
    <message>
        <source>its ElementDataFile &apos;%1&apos; does not name a file for each of its %2 layers. Write the numbers of the first, the last and the step after the name.</source>
        <translation>Ihr ElementDataFile „%1“ nennt nicht für jede der %2 Schichten eine Datei. Schreiben Sie die Nummern der ersten und der letzten und die Schrittweite hinter den Namen.</translation>
    </message>
    <message>
        <source>its ElementDataFile &apos;%1&apos; is not a name with a number such as &apos;%03d&apos;.</source>
        <translation>Ihr ElementDataFile „%1“ ist kein Name mit einer Nummer wie „%03d“.</translation>
    </message>
    <message>
        <source>it ends within its header. It is cut short: copy the file again.</source>
        <translation>Sie endet in ihrem Kopf. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its NetCDF header has lists that are longer than the file, or lacks required ones.</source>
        <translation>Ihr NetCDF-Kopf hat Listen, die länger sind als die Datei, oder keine, wo welche hingehören.</translation>
    </message>
    <message>
        <source>its dimension &apos;%1&apos; is %2 long, more than the file has bytes.</source>
        <translation>Ihre Dimension „%1“ ist %2 lang, mehr als die Datei Bytes hat.</translation>
    </message>
    <message>
        <source>its NetCDF header has an attribute of unknown type.</source>
        <translation>Ein Attribut in ihrem NetCDF-Kopf hat einen Typ, den es nicht gibt.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; has dimensions that do not exist.</source>
        <translation>Ihre Variable „%1“ hat Dimensionen, die nicht da sind.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; is of unknown type.</source>
        <translation>Ihre Variable „%1“ hat einen Typ, den es nicht gibt.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its variable &apos;%2&apos; is larger than any file. It is cut short, or was not written completely: copy the file again, or export it again.</source>
        <translation>Sie hat %1 Bytes, und ihre Variable „%2“ ist größer als jede Datei. Sie ist abgeschnitten oder wurde nicht zu Ende geschrieben: Kopieren Sie die Datei noch einmal, oder exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its variable &apos;%2&apos; extends to byte %3. It is cut short, or was not written completely: copy the file again, or export it again.</source>
        <translation>Sie hat %1 Byte, und ihre Variable „%2“ reicht bis Byte %3. Sie ist abgeschnitten oder wurde nicht zu Ende geschrieben: Kopieren Sie die Datei noch einmal, oder exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; begins within the header.</source>
        <translation>Ihre Variable „%1“ beginnt innerhalb des Kopfes.</translation>
    </message>
    <message>
        <source>page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>%1 lies beyond its end, at %2 bytes. It is cut short: copy the file again.</source>
        <translation>%1 liegt hinter ihrem Ende, bei %2 Bytes. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 has no size.</source>
        <translation>%1 hat keine Größe.</translation>
    </message>
    <message>
        <source>a piece of %1 has %2 bytes and should have %3.</source>
        <translation>Ein Stück (%1) hat %2 Bytes und sollte %3 haben.</translation>
    </message>
    <message>
        <source>a piece of %1</source>
        <translation>ein Stück (%1)</translation>
    </message>
    <message>
        <source>%1 It is damaged, or was written by a faulty program: export it again.</source>
        <translation>%1 Sie ist beschädigt oder von einem fehlerhaften Programm geschrieben: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it ends within its appended data. It is cut short: copy the file again.</source>
        <translation>Sie endet in ihren angehängten Daten. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it is a list of files, one for each time step or part. Open one of its files.</source>
        <translation>Sie ist eine Liste von Dateien, eine für jeden Zeitschritt oder Teil. Öffnen Sie eine davon.</translation>
    </message>
    <message>
        <source>it is a list of files, one for each time step or part. Open one of its files, such as &apos;%1&apos;.</source>
        <translation>Sie ist eine Liste von Dateien, eine für jeden Zeitschritt oder Teil. Öffnen Sie eine davon, etwa „%1“.</translation>
    </message>
    <message>
        <source>its element %1 is missing.</source>
        <translation>Ihr Element %1 fehlt.</translation>
    </message>
    <message>
        <source>the pieces in it do not fill the WholeExtent that it names.</source>
        <translation>Die Stücke darin füllen die WholeExtent nicht, die sie nennt.</translation>
    </message>
    <message>
        <source>it has more than %1 elements.</source>
        <translation>Sie hat mehr als %1 Elemente.</translation>
    </message>
    <message>
        <source>its elements are nested more than %1 levels deep.</source>
        <translation>Ihre Elemente sind mehr als %1-fach verschachtelt.</translation>
    </message>
    <message>
        <source>an element has more than %1 attributes.</source>
        <translation>Ein Element hat mehr als %1 Attribute.</translation>
    </message>
    <message>
        <source>its %1 is &apos;%2&apos; and not three numbers.</source>
        <translation>Ihr %1 ist „%2“ und nicht drei Zahlen.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has &apos;%2&apos; components.</source>
        <translation>Ihr Feld „%1“ hat „%2“ Komponenten.</translation>
    </message>
    <message>
        <source>it claims to have %1 points or cells, more than %2 bytes can hold.</source>
        <translation>Sie will %1 Punkte oder Zellen haben, mehr als %2 Bytes fassen.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos;: %2</source>
        <translation>Ihre Datei „%1“: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; (of cells)</source>
        <translation>„%1“ (von Zellen)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits.</source>
        <translation>Aus ganzen Zahlen von 64 Bit wurden Gleitkommazahlen von 53 Bit.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. Choose one of these: %2.</source>
        <translation>Sie hat kein Feld „%1“. Wählen Sie eines von diesen: %2.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has no component &apos;%2&apos;. Choose one from 0 to %3, or &apos;magnitude&apos;.</source>
        <translation>Ihr Feld „%1“ hat keine Komponente „%2“. Wählen Sie eine von 0 bis %3, oder „magnitude“.</translation>
    </message>
    <message>
        <source>it has cells of a shape that TAn does not support: %1. Divide them into simpler ones.</source>
        <translation>Sie hat Zellen einer Form, die TAn nicht kennt: %1. Zerlegen Sie sie in einfachere.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>the lists of its cells&apos; corners contradict each other. It is damaged.</source>
        <translation>Die Eckenlisten ihrer Zellen widersprechen einander. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>cell %1 (from 0) has the corner %2, and there are %3 points. It is damaged.</source>
        <translation>Zelle %1 (ab 0) hat die Ecke %2, und es gibt %3 Punkte. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>1 cell is declared linear and has the corners of a quadratic one: it was read as such.</source>
        <translation>1 Zelle heißt linear und hat die Ecken einer quadratischen: Sie wurde als solche genommen.</translation>
    </message>
    <message>
        <source>%1 cells are declared linear and have the corners of quadratic ones: they were read as such.</source>
        <translation>%1 Zellen heißen linear und haben die Ecken von quadratischen: Sie wurden als solche genommen.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has values for its polygons, not its points. Choose an array of points.</source>
        <translation>Ihr Feld „%1“ hat Werte für ihre Vielecke, nicht für ihre Punkte. Wählen Sie ein Feld der Punkte.</translation>
    </message>
    <message>
        <source>The lines and polygons that join its points were left out: they are scattered points.</source>
        <translation>Was ihre Punkte verbindet (Linien, Vielecke), wurde weggelassen: Es sind verstreute Punkte.</translation>
    </message>
    <message>
        <source>The values of the cells were transferred to the points, as the mean of the cells around each.</source>
        <translation>Die Werte der Zellen wurden zu den Punkten gebracht, als Mittel der Zellen ringsum.</translation>
    </message>
    <message>
        <source>it has no part &apos;%1&apos;. %2</source>
        <translation>Sie hat keinen Teil „%1“. %2</translation>
    </message>
    <message>
        <source>It has only one: leave &apos;part&apos; empty.</source>
        <translation>Sie ist ein Ganzes: Lassen Sie „part“ leer.</translation>
    </message>
    <message>
        <source>VTK says: %1</source>
        <translation>VTK meldet: %1</translation>
    </message>
    <message>
        <source>it claims to hold more than any machine can. It is damaged.</source>
        <translation>Sie will mehr enthalten, als irgendein Rechner fasst. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>it is not a VTK file: its beginning does not state a type of data. Write it again.</source>
        <translation>Sie ist keine VTK-Datei: Ihr Anfang nennt keine Art von Daten. Schreiben Sie sie neu.</translation>
    </message>
    <message>
        <source>it holds data of the type &apos;%1&apos;, which are not a volume. Write them as a grid, a mesh or points.</source>
        <translation>Sie enthält Daten vom Typ „%1“, die kein Volumen sind. Schreiben Sie sie als Gitter, Netz oder Punkte.</translation>
    </message>
    <message>
        <source>Install VTK with &apos;apt install libvtk9.1&apos; (other systems: VTK 9).</source>
        <translation>Installieren Sie VTK mit „apt install libvtk9.1“ (andere Systeme: VTK 9).</translation>
    </message>
    <message>
        <source>it has no zone. It is cut short, or not Tecplot text.</source>
        <translation>Sie hat keine Zone. Sie ist abgeschnitten oder kein Tecplot-Text.</translation>
    </message>
    <message>
        <source>its zone %1</source>
        <translation>Ihre Zone %1</translation>
    </message>
    <message>
        <source>its zone %1 (&apos;%2&apos;)</source>
        <translation>Ihre Zone %1 („%2“)</translation>
    </message>
    <message>
        <source>it holds &apos;%1&apos;, not a grid with its values. Write both into one file (FILETYPE = FULL).</source>
        <translation>Sie enthält „%1“, kein Gitter mit seinen Werten. Schreiben Sie beides in eine Datei (FILETYPE = FULL).</translation>
    </message>
    <message>
        <source>it has more numbers than its %1 zones require. Its sizes are wrong, or it is damaged.</source>
        <translation>Sie hat mehr Zahlen, als ihre %1 Zonen verlangen. Ihre Größen sind falsch, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>it has &apos;%1&apos; where a record such as ZONE should begin. It is damaged, or not Tecplot text.</source>
        <translation>Sie hat „%1“, wo ein Satz wie ZONE beginnen sollte. Sie ist beschädigt oder kein Tecplot-Text.</translation>
    </message>
    <message>
        <source>none of its variables is called %1, so that it has no position in space. Name the coordinates X, Y and Z.</source>
        <translation>Keine ihrer Variablen heißt %1, sodass sie keinen Ort im Raum hat. Nennen Sie die Koordinaten X, Y und Z.</translation>
    </message>
    <message>
        <source>it has a zone before its VARIABLES. It is damaged.</source>
        <translation>Sie hat eine Zone vor ihren VARIABLES. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 repeats variables with &apos;D&apos;, which is not read. Write it with VARSHARELIST, or all of its variables.</source>
        <translation>%1 wiederholt Variablen durch „D“, was nicht gelesen wird. Schreiben Sie sie mit VARSHARELIST oder mit allen Variablen.</translation>
    </message>
    <message>
        <source>%1 ends within its header. It is cut short: copy the file again.</source>
        <translation>%1 endet in ihrem Kopf. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 has a VARLOCATION &apos;%2&apos; that is not understood.</source>
        <translation>%1 hat eine VARLOCATION „%2“, die nicht zu verstehen ist.</translation>
    </message>
    <message>
        <source>%1 shares variables with zone &apos;%2&apos;, which does not come before it. The file is damaged or cut short.</source>
        <translation>%1 teilt Variablen mit Zone „%2“, die nicht davor kommt. Die Datei ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>%1 has &apos;%2&apos;. It is damaged or cut short.</source>
        <translation>%1 hat „%2“. Sie ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>%1 is of the type &apos;%2&apos;, which is not read. Divide its elements into bricks or tetrahedra.</source>
        <translation>%1 ist vom Typ „%2“, der nicht gelesen wird. Zerlegen Sie ihre Elemente in Hexaeder oder Tetraeder.</translation>
    </message>
    <message>
        <source>%1 does not state how many nodes (N) and elements (E) it has. It is damaged or cut short.</source>
        <translation>%1 sagt nicht, wie viele Knoten (N) und Elemente (E) sie hat. Sie ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>%1 does not state how many points it has (I, J, K). It is damaged or cut short.</source>
        <translation>%1 sagt nicht, wie viele Punkte sie hat (I, J, K). Sie ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>%1 ends before the last of its %2. It is cut short: copy the file again.</source>
        <translation>%1 endet, bevor alles da ist: %2. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 has something other than a number among its %2. Its sizes are wrong, or it is damaged.</source>
        <translation>%1 hat an einer Stelle keine Zahl, wo eine stehen sollte: %2. Ihre Größen sind falsch, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 ends directly after its last number, or within it. If the file is complete, add an end of line; otherwise copy the file again.</source>
        <translation>%1 endet gleich hinter ihrer letzten Zahl, oder mitten darin. Ist die Datei vollständig, setzen Sie ein Zeilenende dahinter; sonst kopieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 shares values with a zone of another size. The file is damaged.</source>
        <translation>%1 teilt Werte mit einer Zone anderer Größe. Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 has the unknown packing &apos;%2&apos;.</source>
        <translation>%1 ist gepackt als „%2“, was nicht bekannt ist.</translation>
    </message>
    <message>
        <source>%1 has values of elements, which must be packed by blocks. It is damaged.</source>
        <translation>%1 hat Werte von Elementen, die blockweise stehen müssen. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 values of &apos;%2&apos;</source>
        <translation>%1 Werte von „%2“</translation>
    </message>
    <message>
        <source>%1 has more numbers than it should. Its sizes are wrong, or it is damaged.</source>
        <translation>%1 hat mehr Zahlen, als sie sollte. Ihre Größen sind falsch, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 has no positions of its points. Write it with all coordinates.</source>
        <translation>%1 hat keine Positionen ihrer Punkte. Schreiben Sie sie mit allen Koordinaten.</translation>
    </message>
    <message>
        <source>%1 shares its elements with a zone that does not fit. The file is damaged.</source>
        <translation>%1 teilt ihre Elemente mit einer Zone, die nicht passt. Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>%1 has an element with node &apos;%2&apos;, and it has %3. It is damaged.</source>
        <translation>%1 hat ein Element am Knoten „%2“, und sie hat %3. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has %2 values for %3 points.</source>
        <translation>Ihr Feld „%1“ hat %2 Werte für %3 Punkte.</translation>
    </message>
    <message>
        <source>it has %1 positions for a grid of %2 points.</source>
        <translation>Sie hat %1 Positionen für ein Gitter aus %2 Punkten.</translation>
    </message>
    <message>
        <source>the position of point %1 (from 0) is not a number, or too large. Repair the file.</source>
        <translation>Die Position von Punkt %1 (ab 0) ist keine Zahl oder zu groß. Reparieren Sie die Datei.</translation>
    </message>
    <message>
        <source>VTK legacy (*.vtk)</source>
        <translation>VTK, altes Format (*.vtk)</translation>
    </message>
    <message>
        <source>VTK HDF (*.vtkhdf *.hdf)</source>
        <translation>VTK HDF (*.vtkhdf *.hdf)</translation>
    </message>
    <message>
        <source>Exodus II (*.ex2 *.exo *.exii *.e *.g)</source>
        <translation>Exodus II (*.ex2 *.exo *.exii *.e *.g)</translation>
    </message>
    <message>
        <source>EnSight (*.case *.encas)</source>
        <translation>EnSight (*.case *.encas)</translation>
    </message>
    <message>
        <source>CGNS (*.cgns)</source>
        <translation>CGNS (*.cgns)</translation>
    </message>
    <message>
        <source>MetaImage (*.mhd *.mha)</source>
        <translation>MetaImage (*.mhd *.mha)</translation>
    </message>
    <message>
        <source>TIFF stack (*.tif *.tiff)</source>
        <translation>TIFF-Stapel (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>DICOM series (*.dcm *.dicom)</source>
        <translation>DICOM-Serie (*.dcm *.dicom)</translation>
    </message>
    <message>
        <source>GAMBIT (*.neu)</source>
        <translation>GAMBIT (*.neu)</translation>
    </message>
    <message>
        <source>Fluent (*.cas)</source>
        <translation>Fluent (*.cas)</translation>
    </message>
    <message>
        <source>OpenFOAM (*.foam controlDict)</source>
        <translation>OpenFOAM (*.foam controlDict)</translation>
    </message>
    <message>
        <source>Tecplot text (*.tec *.tp)</source>
        <translation>Tecplot-Text (*.tec *.tp)</translation>
    </message>
    <message>
        <source>Give &apos;%1&apos;, or the number of a component from 0.</source>
        <translation>Geben Sie „%1“ an, oder die Nummer einer Komponente ab 0.</translation>
    </message>
    <message>
        <source>Arrays with several components: the number of one, from 0, or &apos;magnitude&apos;.</source>
        <translation>Bei Feldern mit mehreren Komponenten: die Nummer einer, ab 0, oder „magnitude“ für den Betrag.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Files with several time steps: which one, from 1.</source>
        <translation>Bei Dateien mit mehreren Zeitschritten: welcher, ab 1.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>with-cell</source>
        <translation>mit der Zelle</translation>
    </message>
    <message>
        <source>How surfaces and volume are put in order: &apos;exact&apos;, or, as the paper did, &apos;with-cell&apos;, where the part of a surface in a cell is drawn before the cell.</source>
        <translation>Wie Flächen und Volumen geordnet werden: „exakt“ oder wie im Aufsatz „mit der Zelle“, wo das Stück einer Fläche in einer Zelle vor der Zelle gezeichnet wird.</translation>
    </message>
    <message>
        <source>electron density of the C60 molecule, a hollow ball of smooth bumps</source>
        <translation>Elektronendichte des C60-Moleküls, eine hohle Kugel aus glatten Hügeln</translation>
    </message>
    <message>
        <source>probability density of the hydrogen atom&apos;s 3d electron: two lobes and a ring</source>
        <translation>Wahrscheinlichkeitsdichte des 3d-Elektrons im Wasserstoffatom: zwei Keulen und ein Ring</translation>
    </message>
    <message>
        <source>the test signal of Marschner and Lobb: ripples that are hard to reproduce</source>
        <translation>das Testsignal von Marschner und Lobb: Wellen, die schwer wiederzugeben sind</translation>
    </message>
    <message>
        <source>white noise, the worst case: no sample predicts its neighbour</source>
        <translation>weißes Rauschen, der schlimmste Fall: Kein Abtastwert sagt etwas über seinen Nachbarn</translation>
    </message>
    <message>
        <source>flow in front of a hemisphere: a curvilinear grid whose axis is collapsed</source>
        <translation>Strömung vor einer Halbkugel: ein krummliniges Gitter mit zusammengefallener Achse</translation>
    </message>
    <message>
        <source>flow around a cylinder: a curvilinear grid that closes on itself</source>
        <translation>Strömung um einen Zylinder: ein krummliniges Gitter, das sich in sich schließt</translation>
    </message>
    <message>
        <source>flow through a bent duct: a curvilinear grid</source>
        <translation>Strömung durch einen gebogenen Kanal: ein krummliniges Gitter</translation>
    </message>
    <message>
        <source>a layer at a wall: a rectilinear grid with growing spacing</source>
        <translation>eine Schicht an einer Wand: ein rechtwinkliges Gitter mit wachsenden Abständen</translation>
    </message>
    <message>
        <source>random points in a ball, with waves that become finer outwards</source>
        <translation>zufällige Punkte in einer Kugel, mit Wellen, die nach außen feiner werden</translation>
    </message>
    <message>
        <source>stress in a plate with five holes and a closed cavity: an irregular mesh</source>
        <translation>Spannung in einer Platte mit fünf Löchern und einem geschlossenen Hohlraum: ein unregelmäßiges Netz</translation>
    </message>
    <message>
        <source>There is no sample called &apos;%1&apos;. Available:%2.</source>
        <translation>Ein Beispiel „%1“ gibt es nicht. Es gibt:%2.</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Beispiel wird erzeugt</translation>
    </message>
    <message>
        <source>The sample &apos;%1&apos; has from %2 to %3 points along each axis, not %4.</source>
        <translation>Das Beispiel „%1“ hat %2 bis %3 Punkte entlang jeder Achse, nicht %4.</translation>
    </message>
    <message>
        <source>Not enough memory to make the sample. Choose a smaller size.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um das Beispiel zu erzeugen. Verlangen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>The array &apos;%1&apos; has %2 values for %3 %4: an array needs a name, and one value for each.</source>
        <translation>Das Feld „%1“ hat %2 Werte für %3 %4: Ein Feld braucht einen Namen und für jeden einen Wert.</translation>
    </message>
    <message>
        <source>The surface &apos;%1&apos; has %2, so it cannot be written.</source>
        <translation>Die Fläche „%1“ hat %2 und kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>not one normal for each vertex</source>
        <translation>nicht für jeden Knoten eine Normale</translation>
    </message>
    <message>
        <source>not one value for each vertex</source>
        <translation>nicht für jeden Knoten einen Wert</translation>
    </message>
    <message>
        <source>triangles with vertices that it does not have</source>
        <translation>Dreiecke von Knoten, die sie nicht hat</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be the boundary of more than 1073741824 tetrahedra, too many to find it. Write a .vtu file.</source>
        <translation>„%1“ wäre die Berandung von mehr als 1073741824 Tetraedern, zu vielen, um sie zu finden. Schreiben Sie eine .vtu-Datei.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than a legacy VTK file can number. Write a .vtu file.</source>
        <translation>„%1“ hätte mehr, als eine Legacy-VTK-Datei nummerieren kann. Schreiben Sie eine .vtu-Datei.</translation>
    </message>
    <message>
        <source>The film</source>
        <translation>Der Film</translation>
    </message>
    <message>
        <source>three numbers in brackets</source>
        <translation>drei Zahlen in eckigen Klammern</translation>
    </message>
    <message>
        <source>an object, in braces</source>
        <translation>ein Objekt, in geschweiften Klammern</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be %2.</source>
        <translation>„%1“ muss so sein: %2.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be written to, so that the view cannot be kept. Free some space there, or save the session.</source>
        <translation>In den Ordner „%1“ kann nicht geschrieben werden, sodass die Ansicht nicht erhalten bleibt. Schaffen Sie dort Platz, oder speichern Sie die Sitzung.</translation>
    </message>
    <message>
        <source>There is no surface to save: add an isovalue, or show one.</source>
        <translation>Es gibt keine Fläche zu speichern: Fügen Sie einen Isowert hinzu, oder zeigen Sie einen.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>Der Arbeitsspeicher reicht nicht für ein Bild dieser Größe.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; for samples cannot be made: %2. Make it writable, or free some space.</source>
        <translation>Der Ordner „%1“ für Beispiele kann nicht angelegt werden: %2. Machen Sie ihn beschreibbar, oder schaffen Sie Platz.</translation>
    </message>
    <message>
        <source>There is no sample called &apos;%1&apos;.</source>
        <translation>Ein Beispiel „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>There is not enough memory for the mesh at this accuracy. Choose a coarser one, or close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht für das Netz dieser Genauigkeit. Wählen Sie eine gröbere, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>its &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>„format“ ist nicht „%1“.</translation>
    </message>
    <message>
        <source>this program reads version %1 of sessions only.</source>
        <translation>Dieses Programm kennt nur Version %1 von Sitzungen.</translation>
    </message>
    <message>
        <source>it names no model in &quot;model.path&quot;.</source>
        <translation>Sie nennt kein Modell in „model.path“.</translation>
    </message>
    <message>
        <source>The video could not be made: %1 says &quot;%2&quot;. Choose another format, or PNG pictures.</source>
        <translation>Das Video konnte nicht erzeugt werden: %1 meldet „%2“. Wählen Sie ein anderes Format oder PNG-Bilder.</translation>
    </message>
    <message>
        <source>The video</source>
        <translation>Das Video</translation>
    </message>
    <message>
        <source>In &apos;%1&apos;: %2</source>
        <translation>In „%1“: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The model of the session cannot be opened. %1</source>
        <translation>Das Modell der Sitzung kann nicht geöffnet werden. %1</translation>
    </message>
    <message>
        <source>Install VTK with &apos;apt install libvtk9.1&apos;.</source>
        <translation>Installieren Sie VTK mit „apt install libvtk9.1“.</translation>
    </message>
    <message>
        <source>A dataset cannot be written as &apos;%1&apos;. %2</source>
        <translation>Ein Datensatz kann nicht als „%1“ geschrieben werden. %2</translation>
    </message>
    <message>
        <source>A mesh cannot be written as &apos;%1&apos;. %2</source>
        <translation>Ein Netz kann nicht als „%1“ geschrieben werden. %2</translation>
    </message>
    <message>
        <source>Surfaces cannot be written as &apos;%1&apos;. %2</source>
        <translation>Flächen können nicht als „%1“ geschrieben werden. %2</translation>
    </message>
    <message>
        <source>Choose one of these endings: %1; or, for the mesh&apos;s boundary alone, %2.</source>
        <translation>Wählen Sie eine dieser Endungen: %1; oder, für die Berandung des Netzes allein, %2.</translation>
    </message>
    <message>
        <source>Choose one of these endings: %1.</source>
        <translation>Wählen Sie eine dieser Endungen: %1.</translation>
    </message>
    <message>
        <source>It was built with %1, and this program with %2. Rebuild the plugin with that compiler and the headers of this TAn, or install a build of it for this TAn.</source>
        <translation>Es wurde mit %1 gebaut und dieses Programm mit %2. Bauen Sie das Plugin mit diesem Compiler und den Headern dieses TAn neu, oder installieren Sie eine Fassung für dieses TAn.</translation>
    </message>
    <message>
        <source>The plugin that writes &apos;%1&apos; announces something that it cannot write. Tell its author.</source>
        <translation>Das Plugin, das „%1“ schreibt, verspricht, was es nicht schreiben kann. Sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>It does not state what it was built with, and this program was built with %1. Rebuild the plugin with tan_plugin_module().</source>
        <translation>Es sagt nicht, womit es gebaut wurde, und dieses Programm wurde mit %1 gebaut. Bauen Sie das Plugin neu, mit tan_plugin_module().</translation>
    </message>
    <message>
        <source>%1%2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>a colour, #rrggbb or a name</source>
        <translation>eine Farbe, #rrggbb oder ein Name</translation>
    </message>
    <message>
        <source>three numbers x,y,z</source>
        <translation>drei Zahlen x,y,z</translation>
    </message>
    <message>
        <source>text that describes %1</source>
        <translation>ein Text, der ein %1 ergibt</translation>
    </message>
    <message>
        <source>&quot;edits&quot; does not state which type of parameters the editor is for</source>
        <translation>„edits“ sagt nicht, für welchen Typ von Parametern der Editor ist</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than the 4 GiB that a .glb file can. Write a .vtp file, or a surface of a larger error.</source>
        <translation>„%1“ hätte mehr als die 4 GiB, die eine .glb-Datei fasst. Schreiben Sie eine .vtp-Datei oder eine Fläche mit größerem Fehler.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than the 2147483647 vertices that a PLY file can number. Write a .vtp file, or a surface of a larger error.</source>
        <translation>„%1“ hätte mehr als die 2147483647 Knoten, die eine PLY-Datei nummerieren kann. Schreiben Sie eine .vtp-Datei oder eine Fläche mit größerem Fehler.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than the 4294967295 triangles that an STL file can count. Write a .vtp file, or a surface of a larger error.</source>
        <translation>„%1“ hätte mehr als die 4294967295 Dreiecke, die eine STL-Datei zählen kann. Schreiben Sie eine .vtp-Datei oder eine Fläche mit größerem Fehler.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than a legacy VTK file can number. Write a .vtp file, or a surface of a larger error.</source>
        <translation>„%1“ hätte mehr, als eine Legacy-VTK-Datei nummerieren kann. Schreiben Sie eine .vtp-Datei oder eine Fläche mit größerem Fehler.</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>Tabellen von Punkten</translation>
    </message>
    <message>
        <source>NRRD volumes</source>
        <translation>NRRD-Volumen</translation>
    </message>
    <message>
        <source>PLOT3D grids with a solution file</source>
        <translation>PLOT3D-Gitter mit Lösungsdatei</translation>
    </message>
    <message>
        <source>VTK XML unstructured grids</source>
        <translation>Unstrukturierte Gitter, VTK-XML</translation>
    </message>
    <message>
        <source>VTK XML polydata</source>
        <translation>Polydata, VTK-XML</translation>
    </message>
    <message>
        <source>VTK legacy files</source>
        <translation>Ältere VTK-Dateien</translation>
    </message>
    <message>
        <source>PLY files</source>
        <translation>PLY-Dateien</translation>
    </message>
    <message>
        <source>STL files</source>
        <translation>STL-Dateien</translation>
    </message>
    <message>
        <source>Wavefront OBJ files</source>
        <translation>Wavefront-OBJ-Dateien</translation>
    </message>
    <message>
        <source>Binary glTF files</source>
        <translation>Binäre glTF-Dateien</translation>
    </message>
    <message>
        <source>Writing the dataset</source>
        <translation>Schreiben des Datensatzes</translation>
    </message>
    <message>
        <source>Writing the mesh</source>
        <translation>Netz wird geschrieben</translation>
    </message>
    <message>
        <source>Writing the surfaces</source>
        <translation>Flächen werden geschrieben</translation>
    </message>
    <message>
        <source>writer &apos;%1&apos;</source>
        <translation>Schreiber „%1“</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation>Kodierung</translation>
    </message>
    <message>
        <source>raw is quick to write and read, gzip is smaller.</source>
        <translation>raw ist schnell geschrieben und gelesen, gzip ist kleiner.</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>raw</translation>
    </message>
    <message>
        <source>gzip</source>
        <translation>gzip</translation>
    </message>
    <message>
        <source>Drawing the scene failed: %1. This is a fault of the plugin that made it; tell its author.</source>
        <translation>Was die Szene zeichnet, ist gescheitert: %1. Das ist ein Fehler des Plugins, das sie gemacht hat; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>An optical model of the scene lacks its function or its shader. This is a fault of the plugin that made it; tell its author.</source>
        <translation>Einem optischen Modell der Szene fehlt seine Funktion oder sein Shader. Das ist ein Fehler des Plugins, das sie gemacht hat; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>A blend of two volumes supports only emission and absorption. Remove the optical model, or show one of the two.</source>
        <translation>Eine Überblendung zweier Volumen ist nur mit Emission und Absorption zu sehen. Nehmen Sie das optische Modell weg, oder zeigen Sie nur eines der beiden.</translation>
    </message>
    <message>
        <source>A scene can have one volume, or one blend of two, and this one has %1. Show the others as surfaces, or in separate pictures.</source>
        <translation>Eine Szene kann ein Volumen haben oder eine Überblendung von zweien, und diese hat %1. Zeigen Sie die anderen als Flächen oder in einem eigenen Bild.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed without giving a reason. This is a fault of the plugin; tell its author.</source>
        <translation>Das Plugin „%1“ ist gescheitert, ohne zu sagen, warum. Das ist ein Fehler des Plugins; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a choice for &apos;%2&apos;. Available: %3.</source>
        <translation>„%1“ ist für „%2“ keine Wahl. Es gibt: %3.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; made a scene that cannot be shown: %2 This is a fault of the plugin; tell its author.</source>
        <translation>Das Plugin „%1“ hat eine Szene gemacht, die nicht gezeigt werden kann: %2 Das ist ein Fehler des Plugins; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>there is none.</source>
        <translation>es gibt keine.</translation>
    </message>
    <message>
        <source>a drawable has no name.</source>
        <translation>etwas darin hat keinen Namen.</translation>
    </message>
    <message>
        <source>two drawables are called &apos;%1&apos;.</source>
        <translation>zweierlei darin heißt „%1“.</translation>
    </message>
    <message>
        <source>It failed to start, without giving a reason. Install it again.</source>
        <translation>Es ist beim Start gescheitert, ohne zu sagen, warum. Installieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>it is compressed with %1, and only zlib is supported. Save it with zlib, or as .vtk, for instance with ParaView.</source>
        <translation>Sie ist mit %1 gepackt, und nur zlib wird gelesen. Speichern Sie sie mit zlib oder als .vtk, etwa mit ParaView.</translation>
    </message>
    <message>
        <source>it holds several time steps. Save each as a file of its own, for instance with ParaView.</source>
        <translation>Sie enthält mehrere Zeitschritte. Speichern Sie jeden als eigene Datei, etwa mit ParaView.</translation>
    </message>
    <message>
        <source>it begins like a grid of %1 points, which takes %2 numbers or more, and has %3</source>
        <translation>Sie beginnt wie ein Gitter aus %1 Punkten, das mindestens %2 Zahlen braucht, und hat %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in line %2 is not a number, or is too large. The file is damaged, or of another format.</source>
        <translation>„%1“ in Zeile %2 ist keine Zahl oder eine zu große. Die Datei ist beschädigt oder von einem anderen Format.</translation>
    </message>
    <message>
        <source>it ends directly after its last number, or within it. If the file is complete, add an end of line; otherwise copy the file again.</source>
        <translation>Sie endet gleich hinter ihrer letzten Zahl, oder mitten darin. Ist die Datei vollständig, setzen Sie ein Zeilenende dahinter; sonst kopieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>with &apos;%1&apos; it repeats numbers more often than is plausible for a file of its size. Write them one by one.</source>
        <translation>Mit „%1“ wiederholt sie Zahlen öfter, als TAn einer Datei ihrer Größe glaubt. Schreiben Sie sie einzeln.</translation>
    </message>
    <message>
        <source>VTK XML (*.vti *.vtr *.vts *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</source>
        <translation>VTK XML (*.vti *.vtr *.vts *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</translation>
    </message>
    <message>
        <source>its format is not one that TAn leaves to VTK. Let TAn choose the reader.</source>
        <translation>Sie hat kein Format, das TAn VTK überlässt. Lassen Sie TAn den Leser wählen.</translation>
    </message>
    <message>
        <source>It returned no widget. Please tell its author.</source>
        <translation>Er hat nichts geliefert, das angezeigt werden kann. Bitte sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; is larger than 64 MiB. Choose a session, camera or transfer function.</source>
        <translation>Die Datei „%1“ ist größer als 64 MiB. Wählen Sie eine Sitzung, eine Kamera oder eine Transferfunktion.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; does not say how it was made. Choose a model or a session.</source>
        <translation>Das Bild „%1“ sagt nicht, wie es entstanden ist. Wählen Sie ein Modell oder eine Sitzung.</translation>
    </message>
    <message>
        <source>text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>one of the known names</source>
        <translation>einer der bekannten Namen</translation>
    </message>
    <message>
        <source>A film needs at least two key frames. Add another view.</source>
        <translation>Ein Film braucht mindestens zwei Schlüsselbilder. Fügen Sie noch eine Ansicht hinzu.</translation>
    </message>
    <message>
        <source>The shader of an optical model cannot be used. The compiler says: %1</source>
        <translation>Der Shader eines optischen Modells ist nicht verwendbar. Der Compiler meldet: %1</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; has an optical model whose shader cannot be used. This is a fault of the plugin; tell its author. The compiler says: %2</source>
        <translation>Das Plugin „%1“ hat ein optisches Modell, dessen Shader nicht verwendbar ist. Das ist ein Fehler im Plugin; melden Sie ihn dessen Autor. Der Compiler meldet: %2</translation>
    </message>
    <message>
        <source>A plane needs a normal of three finite numbers, not all zero, and a finite offset.</source>
        <translation>Eine Ebene braucht eine Normale aus drei endlichen Zahlen, die nicht alle null sind, und einen endlichen Abstand.</translation>
    </message>
    <message>
        <source>Not enough memory to cut the mesh. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Speicher reicht nicht, um das Netz zu schneiden. Schließen Sie andere Programme, oder senken Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>not one colour for each vertex</source>
        <translation>nicht für jeden Knoten eine Farbe</translation>
    </message>
    <message>
        <source>&apos;--%1&apos; describes raw files, but the header of &apos;%2&apos; states it. Leave it out.</source>
        <translation>„--%1“ beschreibt rohe Dateien, und der Kopf von „%2“ sagt es selbst. Lassen Sie es weg.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; applies only without &apos;%2&apos;. Leave one of them out.</source>
        <translation>„%1“ ist nur ohne „%2“ von Nutzen. Lassen Sie eines davon weg.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; applies only with &apos;%2&apos;. Leave it out, or give both.</source>
        <translation>„%1“ ist nur mit „%2“ von Nutzen. Lassen Sie es weg, oder geben Sie beide an.</translation>
    </message>
    <message>
        <source>one-sided</source>
        <translation>einseitig</translation>
    </message>
    <message>
        <source>physical</source>
        <translation>im physikalischen Raum</translation>
    </message>
    <message>
        <source>computational</source>
        <translation>im Rechenraum</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a regular lattice, which has no warping. Leave out the options about it.</source>
        <translation>„%1“ ist ein regelmäßiges Gitter, das keine Verwerfung hat. Lassen Sie weg, was von ihr verlangt wird.</translation>
    </message>
    <message>
        <source>Decimation needs the mesh of scattered points, and these are the points alone.</source>
        <translation>Die Vergröberung nimmt das Netz verstreuter Punkte, und dies sind nur die Punkte.</translation>
    </message>
    <message>
        <source>Only irregular data have a boundary that moves, and so a distance from both sides to limit. Leave that out.</source>
        <translation>Nur unregelmäßige Daten haben eine Berandung, die sich bewegt, sodass es einen Abstand von beiden Seiten zu begrenzen gibt. Lassen Sie das weg.</translation>
    </message>
    <message>
        <source>The paper&apos;s selection of points cannot be used with blocks: blocks that are refined independently could not agree about their faces. Set the block to &quot;none&quot;.</source>
        <translation>Die Auswahl der Punkte wie im Aufsatz ist mit Blöcken nicht möglich: Unabhängig verfeinerte Blöcke könnten sich über ihre Seitenflächen nicht einigen. Setzen Sie den Block auf „keine“.</translation>
    </message>
    <message>
        <source>Examining the cells</source>
        <translation>Zellen werden untersucht</translation>
    </message>
    <message>
        <source>The paper&apos;s selection compares error and warping, so a build cannot be ordered by one of them alone. Choose the normalised selection, or order by both.</source>
        <translation>Die Auswahl des Aufsatzes vergleicht Fehler und Verwerfung, ein Bau kann daher nicht nach einem von beiden allein geordnet sein. Nehmen Sie die normierte Auswahl, oder ordnen Sie nach beiden.</translation>
    </message>
    <message>
        <source>The domain of this mesh is not convex, and refinement would fill what its boundary leaves out. Decimation keeps it.</source>
        <translation>Das Gebiet dieses Netzes ist nicht konvex, und die Verfeinerung würde füllen, was seine Berandung auslässt. Die Vergröberung erhält es.</translation>
    </message>
    <message>
        <source>Refining a rectilinear grid of %1 points in physical space takes about %2 of memory, and this machine has %3. Refine it in computational space, as a curvilinear grid, or take a region of it or fewer samples.</source>
        <translation>Ein rechtwinkliges Gitter aus %1 Punkten im physikalischen Raum zu verfeinern braucht etwa %2 Speicher, und dieser Rechner hat %3. Verfeinern Sie es im Rechenraum, als krummliniges Gitter, oder nehmen Sie einen Ausschnitt oder weniger Abtastwerte.</translation>
    </message>
    <message>
        <source>Only rectilinear grids can be refined in one space or the other, and &apos;%1&apos; is not one.</source>
        <translation>Nur rechtwinklige Gitter können im einen oder im anderen Raum verfeinert werden, und „%1“ ist keines.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a rectilinear grid, which is refined in physical space: there it has no warping and no blocks. Leave these out, or refine it in computational space.</source>
        <translation>„%1“ ist ein rechtwinkliges Gitter, das im physikalischen Raum verfeinert wird: Dort hat es keine Verwerfung und keine Blöcke. Lassen Sie diese weg, oder verfeinern Sie es im Rechenraum.</translation>
    </message>
    <message>
        <source>When refined, &apos;%1&apos; has no warping. Leave out the options about it.</source>
        <translation>Verfeinert hat „%1“ keine Verwerfung. Lassen Sie weg, was von ihr verlangt wird.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a grid, so it has no blocks. Leave them out.</source>
        <translation>„%1“ ist kein Gitter und hat deshalb keine Blöcke. Lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>Refinement uses the points of a convex mesh, and this is the mesh itself.</source>
        <translation>Die Verfeinerung nimmt die Punkte eines konvexen Netzes, und dies ist das Netz selbst.</translation>
    </message>
    <message>
        <source>A build ordered by the error alone has no threshold of warping. Leave that out, or order by both.</source>
        <translation>Nach dem Fehler allein geordnet, hat ein Bau keine Schwelle der Verwerfung. Lassen Sie diese weg, oder ordnen Sie nach beiden.</translation>
    </message>
    <message>
        <source>A build ordered by the warping alone has no threshold of error. Leave that out, or order by both.</source>
        <translation>Nach der Verwerfung allein geordnet, hat ein Bau keine Schwelle des Fehlers. Lassen Sie diese weg, oder ordnen Sie nach beiden.</translation>
    </message>
    <message>
        <source>it has a value that is not finite</source>
        <translation>sie hat einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>it has no volume</source>
        <translation>sie hat kein Volumen</translation>
    </message>
    <message>
        <source>it is too warped to be cut into tetrahedra</source>
        <translation>sie ist zu verzogen, um in Tetraeder zerlegt zu werden</translation>
    </message>
    <message>
        <source>it appears twice</source>
        <translation>sie ist doppelt vorhanden</translation>
    </message>
    <message>
        <source>more than two cells share one of its faces</source>
        <translation>mehr als zwei Zellen haben eine ihrer Seiten gemeinsam</translation>
    </message>
    <message>
        <source>it is inverted and overlaps its neighbours</source>
        <translation>sie ist umgestülpt und überlappt ihre Nachbarn</translation>
    </message>
    <message>
        <source>it overlaps others</source>
        <translation>sie überlappt andere</translation>
    </message>
    <message>
        <source>1 cell was left out: more than two cells share one of its faces.</source>
        <translation>1 Zelle wurde weggelassen: Mehr als zwei Zellen haben eine ihrer Seiten gemeinsam.</translation>
    </message>
    <message>
        <source>%1 cells were left out: more than two cells share one of their faces.</source>
        <translation>%1 Zellen wurden weggelassen: Mehr als zwei Zellen haben eine ihrer Seiten gemeinsam.</translation>
    </message>
    <message>
        <source>1 cell was left out: it is inverted and overlaps its neighbours.</source>
        <translation>1 Zelle wurde weggelassen: Sie ist umgestülpt und überlappt ihre Nachbarn.</translation>
    </message>
    <message>
        <source>%1 cells were left out: they are inverted and overlap their neighbours.</source>
        <translation>%1 Zellen wurden weggelassen: Sie sind umgestülpt und überlappen ihre Nachbarn.</translation>
    </message>
    <message>
        <source>1 cell was left out: it overlaps others.</source>
        <translation>1 Zelle wurde weggelassen: Sie überlappt andere.</translation>
    </message>
    <message>
        <source>%1 cells were left out: they overlap others.</source>
        <translation>%1 Zellen wurden weggelassen: Sie überlappen andere.</translation>
    </message>
    <message>
        <source>It has holes, points that are blanked out or without a finite value, which make it an irregular mesh: up to %1 tetrahedra, which take %2 of memory, of %3. Take a region or every n-th point of it, or replace those values with numbers.</source>
        <translation>Es hat Löcher, Punkte, die ausgeblendet sind oder keinen endlichen Wert haben, und ist deshalb ein unregelmäßiges Netz: bis zu %1 Tetraeder, die %2 Speicher brauchen, von %3. Nehmen Sie einen Bereich oder jeden n-ten Punkt davon, oder ersetzen Sie diese Werte durch Zahlen.</translation>
    </message>
    <message>
        <source>No cell of the grid has a finite value at each of its corners, or all are blanked out: nothing is left.</source>
        <translation>Keine Zelle des Gitters hat an jeder Ecke einen endlichen Wert, oder alle sind ausgeblendet: Es bleibt nichts übrig.</translation>
    </message>
    <message>
        <source>The grid has become an irregular mesh with holes.</source>
        <translation>Das Gitter ist zu einem unregelmäßigen Netz mit Löchern geworden.</translation>
    </message>
    <message>
        <source>%1 Left out with the cells around them: %2 of its %3 points, blanked out or without a finite value.</source>
        <translation>%1 Weggelassen wurden mit den Zellen um sie herum %2 seiner %3 Punkte, ausgeblendet oder ohne endlichen Wert.</translation>
    </message>
    <message>
        <source>It has blanking flags for %1 cells, but %2 cells. It is damaged.</source>
        <translation>Es sagt von %1 Zellen, ob sie ausgeblendet sind, und hat %2. Es ist beschädigt.</translation>
    </message>
    <message>
        <source>1 pair of tetrahedra that overlap, one at %1</source>
        <translation>1 Paar sich überlappender Tetraeder, eines bei %1</translation>
    </message>
    <message>
        <source>%1 pairs of tetrahedra that overlap, one at %2</source>
        <translation>%1 Paare sich überlappender Tetraeder, eines bei %2</translation>
    </message>
    <message>
        <source>the position of point %1 is not a finite number, or too large. Leave it out.</source>
        <translation>Die Position von Punkt %1 ist keine endliche Zahl oder zu groß. Lassen Sie ihn weg.</translation>
    </message>
    <message>
        <source>none of its values is a finite number.</source>
        <translation>Keiner seiner Werte ist eine endliche Zahl.</translation>
    </message>
    <message>
        <source>1 point without a finite value was left out.</source>
        <translation>1 Punkt ohne endlichen Wert wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 points without a finite value were left out.</source>
        <translation>%1 Punkte ohne endlichen Wert wurden weggelassen.</translation>
    </message>
    <message>
        <source>The tetrahedralization</source>
        <translation>Die Zerlegung in Tetraeder</translation>
    </message>
    <message>
        <source>Tetrahedralizing the points</source>
        <translation>Die Punkte werden zu Tetraedern verbunden</translation>
    </message>
    <message>
        <source>Testing the boundary</source>
        <translation>Berandung wird geprüft</translation>
    </message>
    <message>
        <source>the camera&apos;s position</source>
        <translation>der Ort der Kamera</translation>
    </message>
    <message>
        <source>the isovalues</source>
        <translation>die Isowerte</translation>
    </message>
    <message>
        <source>the opacities</source>
        <translation>die Deckkräfte</translation>
    </message>
    <message>
        <source>Not enough memory for all meshes of up to %1 sites. Choose a larger error.</source>
        <translation>Nicht genug Speicher für alle Netze mit bis zu %1 Stützstellen. Wählen Sie einen größeren Fehler.</translation>
    </message>
    <message>
        <source>Selecting tetrahedra by when they appear and disappear</source>
        <translation>Tetraeder werden nach ihrem Leben ausgewählt</translation>
    </message>
    <message>
        <source>An end of the range of accuracies is not a number. Give both in percent.</source>
        <translation>Ein Ende des Bereichs von Genauigkeiten ist keine Zahl. Geben Sie beide in Prozent an.</translation>
    </message>
    <message>
        <source>A range of errors at which tetrahedra appear or disappear goes from a smaller error to a larger one: %1 and %2 do not.</source>
        <translation>Ein Bereich von Entstehung oder Ersetzung geht von einem kleineren Fehler zu einem größeren: %1 und %2 nicht.</translation>
    </message>
    <message>
        <source>A budget is for one mesh, and a range of accuracies has many. Leave one of the two out.</source>
        <translation>Ein Budget gilt für ein Netz, und ein Bereich von Genauigkeiten hat viele. Lassen Sie eines von beiden weg.</translation>
    </message>
    <message>
        <source>OpenGL draws at most %1 focus regions. Take fewer, or use the CPU back end.</source>
        <translation>OpenGL zeichnet höchstens %1 Fokusbereiche. Nehmen Sie weniger, oder zeichnen Sie mit dem Prozessor.</translation>
    </message>
    <message>
        <source>rectilinear</source>
        <translation>rechtwinklig</translation>
    </message>
    <message>
        <source>For data whose domain can warp: the warping at which to stop. Its ratio to the error sets how much the shape counts against the values. If one of the two is 0, it is the same number as the other.</source>
        <translation>Für Daten, deren Gebiet sich verwerfen kann: die Verwerfung, bei der aufgehört wird. Ihr Verhältnis zum Fehler sagt, wie viel die Form gegenüber den Werten zählt. Ist eines von beiden 0, ist es dieselbe Zahl wie das andere.</translation>
    </message>
    <message>
        <source>Ordered by</source>
        <translation>Geordnet nach</translation>
    </message>
    <message>
        <source>For data whose domain can warp: &apos;both&apos; orders the model by the larger of error and warping, in the ratio of their thresholds; &apos;error&apos; or &apos;warping&apos; by that alone, for the fewest points where the other one does not matter.</source>
        <translation>Für Daten, deren Gebiet sich verwerfen kann: „beide“ ordnet das Modell nach dem größeren von Fehler und Verwerfung im Verhältnis ihrer Schwellen; „Fehler“ oder „Verwerfung“ nach diesem allein, für die wenigsten Punkte, wo das andere keine Rolle spielt.</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>warping</source>
        <translation>Verwerfung</translation>
    </message>
    <message>
        <source>two-sided</source>
        <translation>beidseitig</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>What the warping of irregular data measures: &apos;one-sided&apos;, as the paper did, how far the points of the data&apos;s boundary are from that of a mesh; &apos;two-sided&apos; also how far any place on a mesh&apos;s boundary is from that of the data.</source>
        <translation>Was die Verwerfung unregelmäßiger Daten misst: „einseitig“, wie im Aufsatz, wie weit die Punkte der Berandung der Daten von der eines Netzes entfernt sind; „beidseitig“ auch, wie weit irgendeine Stelle der Berandung eines Netzes von der der Daten entfernt ist.</translation>
    </message>
    <message>
        <source>Scattered points: decimation begins with the Delaunay mesh of all of them, and needs fewer of them for the same accuracy, but more time and memory.</source>
        <translation>Verstreute Punkte: Die Vergröberung beginnt mit dem Delaunay-Netz aller Punkte und braucht weniger von ihnen für dieselbe Genauigkeit, aber mehr Zeit und Speicher.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>The edge length, in cells, of the blocks that are refined independently, a few of them in memory at a time; &apos;none&apos; refines the dataset as a whole; &apos;automatic&apos; uses blocks where a lattice or grid is large.</source>
        <translation>Die Zellen entlang einer Kante der Blöcke, die unabhängig voneinander verfeinert werden, im Arbeitsspeicher für wenige davon; „keine“ verfeinert den Datensatz als Ganzes; „automatisch“ nimmt Blöcke, wenn ein regelmäßiges oder krummliniges Gitter groß ist.</translation>
    </message>
    <message>
        <source>A rectilinear grid: refinement in physical space keeps the exact domain.</source>
        <translation>Ein rechtwinkliges Gitter: Die Verfeinerung im physikalischen Raum erhält das genaue Gebiet.</translation>
    </message>
    <message>
        <source>A mesh of convex domain: refinement keeps the exact domain, with tetrahedra of its own.</source>
        <translation>Ein Netz mit konvexem Gebiet: Die Verfeinerung erhält das genaue Gebiet, mit eigenen Tetraedern.</translation>
    </message>
    <message>
        <source>The mesh is too large to be shown.</source>
        <translation>Das Netz ist zu groß, um es anzusehen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a rectilinear grid</source>
        <translation>„%1“ ist ein rechtwinkliges Gitter</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is for %2 data only, and %3. Leave it out, or choose &apos;%4 %5&apos;.</source>
        <translation>„%1“ gilt nur für diese Art von Daten: %2; doch %3. Lassen Sie es weg, oder wählen Sie „%4 %5“.</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Zeigt</translation>
    </message>
    <message>
        <source>What is shown, inside and outside the focus: the volume, isosurfaces, or both.</source>
        <translation>Was innerhalb und außerhalb des Fokus gezeigt wird: das Volumen, Isoflächen oder beides.</translation>
    </message>
    <message>
        <source>A range of accuracies has overlapping tetrahedra, so their volume cannot be drawn. Choose isosurfaces, or limits of appearance and disappearance that leave one mesh.</source>
        <translation>Ein Bereich von Genauigkeiten hat Tetraeder, die übereinander liegen, daher kann ihr Volumen nicht gezeichnet werden. Wählen Sie Isoflächen, oder Grenzen, die ein Netz übrig lassen.</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lesen des Modells</translation>
    </message>
    <message>
        <source>Set XDG_CACHE_HOME to a folder that can be written to.</source>
        <translation>Setzen Sie XDG_CACHE_HOME auf einen beschreibbaren Ordner.</translation>
    </message>
    <message>
        <source>Cannot use the cache folder &apos;%1&apos;: %2. %3</source>
        <translation>Der Zwischenspeicher „%1“ ist nicht benutzbar: %2. %3</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>im Gitter</translation>
    </message>
    <message>
        <source>space</source>
        <translation>im Raum</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was read. Copy the file again.</source>
        <translation>„%1“ wurde abgeschnitten oder geändert, während es gelesen wurde. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The error in space is kept in whole grids only, as a point may lie in a tetrahedron of another block. Set the block to &quot;none&quot;.</source>
        <translation>Der Fehler im Raum wird nur in ganzen Gittern eingehalten, da ein Punkt in einem Tetraeder eines anderen Blocks liegen kann. Setzen Sie den Block auf „keine“.</translation>
    </message>
    <message>
        <source>To keep the error in space, a build must be ordered by error and warping, with the normalised selection. Leave out the other choice.</source>
        <translation>Um den Fehler im Raum einzuhalten, wird ein Bau nach Fehler und Verwerfung geordnet, mit der normierten Auswahl. Lassen Sie die andere Wahl weg.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is refined in the space where its points lie, so its error is the error in space. Leave this choice out.</source>
        <translation>„%1“ wird in dem Raum verfeinert, in dem die Punkte liegen; der Fehler ist also der Fehler im Raum. Lassen Sie diese Wahl weg.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a packed model. Unpack it first, with &apos;tan unpack&apos;.</source>
        <translation>„%1“ ist ein gepacktes Modell. Entpacken Sie es zuerst mit „tan unpack“.</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is invalid</source>
        <translation>der Abschnitt „%1“ ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>Not enough memory to open &apos;%1&apos;. Close other programs.</source>
        <translation>Der Speicher reicht nicht, um „%1“ zu öffnen. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2. Copy the file again, or pack the model again.</source>
        <translation>„%1“ ist beschädigt: %2. Kopieren Sie die Datei erneut, oder packen Sie das Modell erneut.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is packed by method %2, which this version does not know. Install a later version of TAn.</source>
        <translation>„%1“ ist nach Verfahren %2 gepackt, das diese Version nicht kennt. Installieren Sie eine neuere Version von TAn.</translation>
    </message>
    <message>
        <source>its levels are invalid</source>
        <translation>seine Stufen ergeben keinen Sinn</translation>
    </message>
    <message>
        <source>Reading a packed model</source>
        <translation>Ein gepacktes Modell wird gelesen</translation>
    </message>
    <message>
        <source>a chunk is cut short</source>
        <translation>ein Stück ist abgeschnitten</translation>
    </message>
    <message>
        <source>the checksum of a chunk is wrong</source>
        <translation>die Prüfsumme eines Stücks ist falsch</translation>
    </message>
    <message>
        <source>This packed mesh is damaged.</source>
        <translation>Dieses gepackte Netz ist beschädigt.</translation>
    </message>
    <message>
        <source>This mesh cannot be packed: its arrays do not belong together, or it has more than %1 tetrahedra.</source>
        <translation>Dieses Netz kann nicht gepackt werden: Seine Felder gehören nicht zusammen, oder es hat mehr als %1 Tetraeder.</translation>
    </message>
    <message>
        <source>What was received is not a packed mesh of this version, or is damaged.</source>
        <translation>Was empfangen wurde, ist kein gepacktes Netz dieser Version oder ist beschädigt.</translation>
    </message>
    <message>
        <source>The mesh has %1 tetrahedra, and at most %2 are taken.</source>
        <translation>Das Netz hat %1 Tetraeder; höchstens %2 werden angenommen.</translation>
    </message>
    <message>
        <source>Not enough memory for a packed mesh. Choose a larger error or a part of it.</source>
        <translation>Nicht genug Speicher für ein gepacktes Netz. Verlangen Sie einen größeren Fehler oder einen Teil davon.</translation>
    </message>
    <message>
        <source>Not enough memory to unpack &apos;%1&apos;. Close other programs, or unpack it on a larger machine.</source>
        <translation>Nicht genug Speicher, um „%1“ zu entpacken. Schließen Sie andere Programme, oder entpacken Sie es auf einem größeren Rechner.</translation>
    </message>
    <message>
        <source>Not enough memory to pack &apos;%1&apos;. Close other programs, or pack it on a larger machine.</source>
        <translation>Nicht genug Speicher, um „%1“ zu packen. Schließen Sie andere Programme, oder packen Sie es auf einem größeren Rechner.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 levels, and level %3 is none of them.</source>
        <translation>„%1“ hat %2 Stufen; Stufe %3 ist keine davon.</translation>
    </message>
    <message>
        <source>Packing the model</source>
        <translation>Das Modell wird gepackt</translation>
    </message>
    <message>
        <source>Unpacking the model</source>
        <translation>Das Modell wird entpackt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be packed: most of it is in sections that this version does not know.</source>
        <translation>„%1“ kann nicht gepackt werden: Das meiste liegt in Abschnitten, die diese Version nicht kennt.</translation>
    </message>
    <message>
        <source>its content is not a history</source>
        <translation>was es enthält, ist keine Geschichte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be packed: its history is not that of a mesh. &apos;tan verify&apos; gives details.</source>
        <translation>„%1“ kann nicht gepackt werden: Die Geschichte ist nicht die eines Netzes. „tan verify“ sagt mehr.</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Packen</translation>
    </message>
    <message>
        <source>its sites are invalid</source>
        <translation>seine Stützstellen ergeben keinen Sinn</translation>
    </message>
    <message>
        <source>a lattice of %1 points cannot be replayed</source>
        <translation>ein regelmäßiges Gitter aus %1 Punkten kann nicht wiederholt werden</translation>
    </message>
    <message>
        <source>its text does not tell how it was built</source>
        <translation>sein Text sagt nicht, wie es gebaut wird</translation>
    </message>
    <message>
        <source>its samples are not those that it was packed with</source>
        <translation>seine Abtastwerte sind nicht die, mit denen es gepackt wurde</translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation>Das Modell wird geschrieben</translation>
    </message>
    <message>
        <source>Replaying the insertions</source>
        <translation>Die Einfügungen werden wiederholt</translation>
    </message>
    <message>
        <source>The lattice is too large to be packed as a whole.</source>
        <translation>Das regelmäßige Gitter ist zu groß, um als Ganzes gepackt zu werden.</translation>
    </message>
    <message>
        <source>A point lies in no tetrahedron of the mesh.</source>
        <translation>Ein Punkt liegt in keinem Tetraeder des Netzes.</translation>
    </message>
    <message>
        <source>TAN_CACHE_MB is &apos;%1&apos;. Give the maximum size of the cache folder in megabytes.</source>
        <translation>TAN_CACHE_MB ist „%1“. Geben Sie an, wie viele Megabyte der Zwischenspeicher höchstens belegen darf.</translation>
    </message>
    <message>
        <source>There is no cache folder, because this user has no home folder. Set XDG_CACHE_HOME to a folder.</source>
        <translation>Es gibt keinen Zwischenspeicher, da dieser Benutzer kein Benutzerverzeichnis hat. Setzen Sie XDG_CACHE_HOME auf einen Ordner.</translation>
    </message>
    <message>
        <source>Waiting for a file of the cache folder</source>
        <translation>Warten auf eine Datei des Zwischenspeichers</translation>
    </message>
    <message>
        <source>The cache folder &apos;%1&apos; has no room for %2 more: its limit is %3, and files in use are kept. Set TAN_CACHE_MB to more megabytes.</source>
        <translation>Im Zwischenspeicher „%1“ ist kein Platz für weitere %2: Seine Grenze ist %3, und was in Gebrauch ist, bleibt. Setzen Sie TAN_CACHE_MB auf mehr Megabyte.</translation>
    </message>
    <message>
        <source>Not enough memory to read the cache folder &apos;%1&apos;. Close other programs.</source>
        <translation>Nicht genug Speicher, um den Zwischenspeicher „%1“ durchzusehen. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; sends more than %2, the most that is accepted.</source>
        <translation>„%1“ sendet mehr als %2; mehr wird nicht angenommen.</translation>
    </message>
    <message>
        <source>Not enough memory for the server&apos;s answer. Request less.</source>
        <translation>Nicht genug Speicher für das, was der Server sendet. Verlangen Sie weniger.</translation>
    </message>
    <message>
        <source>the file on the server was changed while it was read. Open it again.</source>
        <translation>Die Datei auf dem Server wurde geändert, während sie gelesen wurde. Öffnen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>the server or a proxy compresses what it sends (%1), so that parts of the file cannot be located. Download the file and open the copy.</source>
        <translation>Der Server oder ein Proxy packt, was er sendet (%1), sodass Teile der Datei nicht zu erkennen sind. Laden Sie die Datei herunter und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>the server does not state the length of the file. Download the file and open the copy.</source>
        <translation>Der Server sagt nicht, wie lang die Datei ist. Laden Sie die Datei herunter und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>its server delivers files only as a whole, not in parts (range requests). Download the file and open the copy, or put it on a server that supports ranges.</source>
        <translation>Ihr Server liefert Dateien nur als Ganzes, nicht in Teilen (Bereichsanfragen). Laden Sie die Datei herunter und öffnen Sie die Kopie, oder legen Sie sie auf einen Server, der Bereiche kennt.</translation>
    </message>
    <message>
        <source>the server sends a different part of the file from the one requested. Download the file and open the copy.</source>
        <translation>Der Server liefert einen anderen Teil der Datei als den verlangten. Laden Sie die Datei herunter und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>the program that answers there is not a web server. Check the address and its port.</source>
        <translation>Was dort antwortet, ist kein Webserver. Prüfen Sie die Adresse und ihren Port.</translation>
    </message>
    <message>
        <source>the connection was lost again and again, because of the server or a proxy on the way. Try again later, or download the file and open the copy.</source>
        <translation>Die Verbindung wurde immer wieder getrennt, vom Server oder von einem Proxy auf dem Weg. Versuchen Sie es später, oder laden Sie die Datei herunter und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>the server requires a name and a password. Give them in the address, https://NAME:PASSWORD@..., or download the file.</source>
        <translation>Der Server verlangt Namen und Passwort. Geben Sie sie in der Adresse an, https://NAME:PASSWORT@..., oder laden Sie die Datei herunter.</translation>
    </message>
    <message>
        <source>the proxy requires a name and a password. Set https_proxy to an address with both.</source>
        <translation>Der Proxy verlangt Namen und Passwort. Setzen Sie https_proxy auf eine Adresse mit beiden.</translation>
    </message>
    <message>
        <source>there is no such file on the server (%1). Check the address.</source>
        <translation>Diese Datei gibt es auf dem Server nicht (%1). Prüfen Sie die Adresse.</translation>
    </message>
    <message>
        <source>the server is busy (%1). Try again later.</source>
        <translation>Der Server ist ausgelastet (%1). Versuchen Sie es später.</translation>
    </message>
    <message>
        <source>the server failed (%1). Try again later, or tell its operator.</source>
        <translation>Der Server hat einen Fehler (%1). Versuchen Sie es später, oder sagen Sie es seinem Betreiber.</translation>
    </message>
    <message>
        <source>the server answers with status %1 instead of data. Check the address.</source>
        <translation>Der Server antwortet mit Status %1 statt mit Daten. Prüfen Sie die Adresse.</translation>
    </message>
    <message>
        <source>its host was not found. Check the address and the network.</source>
        <translation>Ihr Rechner wurde nicht gefunden. Prüfen Sie die Adresse und das Netz.</translation>
    </message>
    <message>
        <source>the proxy was not found. Check http_proxy and https_proxy.</source>
        <translation>Der Proxy wurde nicht gefunden. Prüfen Sie http_proxy und https_proxy.</translation>
    </message>
    <message>
        <source>nothing answers at that host and port. Check the address and the network.</source>
        <translation>Unter diesem Rechner und Port antwortet nichts. Prüfen Sie die Adresse und das Netz.</translation>
    </message>
    <message>
        <source>the server redirects from one address to another and never to a file. Check the address.</source>
        <translation>Der Server führt von einer Adresse zur nächsten und zu keiner Datei. Prüfen Sie die Adresse.</translation>
    </message>
    <message>
        <source>the certificate of its host cannot be trusted (%1). Check the address and this machine&apos;s clock; read nothing from it if you do not know why.</source>
        <translation>Dem Zertifikat des Rechners ist nicht zu trauen (%1). Prüfen Sie die Adresse und die Uhr dieses Rechners; lesen Sie nichts von dort, wenn Sie den Grund nicht kennen.</translation>
    </message>
    <message>
        <source>a secure connection to its host cannot be made (%1). Check whether the address begins with http:// or https://.</source>
        <translation>Zu diesem Rechner gibt es keine sichere Verbindung (%1). Prüfen Sie, ob die Adresse mit http:// oder https:// beginnt.</translation>
    </message>
    <message>
        <source>the server redirects to an address that is not safe to follow. Give the address of the file itself.</source>
        <translation>Der Server führt zu einer Adresse, der zu folgen nicht sicher ist. Geben Sie die Adresse der Datei selbst an.</translation>
    </message>
    <message>
        <source>the file is empty. Check the address.</source>
        <translation>Die Datei ist leer. Prüfen Sie die Adresse.</translation>
    </message>
    <message>
        <source>The cache folder returns other bytes than were written to it. Check its disk, or set XDG_CACHE_HOME to a folder on another one.</source>
        <translation>Der Zwischenspeicher liefert andere Bytes, als in ihn geschrieben wurden. Prüfen Sie seine Platte, oder setzen Sie XDG_CACHE_HOME auf einen Ordner auf einer anderen.</translation>
    </message>
    <message>
        <source>Reading &apos;%1&apos;</source>
        <translation>Lesen von „%1“</translation>
    </message>
    <message>
        <source>it ends too early. It is not a complete model: ask the person who put it there.</source>
        <translation>Sie endet vor dem, was gesucht wurde. Das ist kein ganzes Modell: Fragen Sie, wer es dort abgelegt hat.</translation>
    </message>
    <message>
        <source>Reading from the network</source>
        <translation>Lesen aus dem Netz</translation>
    </message>
    <message>
        <source>nothing arrived from the server for %1 seconds, or too slowly. Check the network, or try again later.</source>
        <translation>Vom Server kam %1 Sekunden lang nichts, oder zu langsam. Prüfen Sie das Netz, oder versuchen Sie es später.</translation>
    </message>
    <message>
        <source>The part of a picture to be drawn must lie within it.</source>
        <translation>Der Teil eines Bildes, der gezeichnet werden soll, muss in ihm liegen.</translation>
    </message>
    <message>
        <source>Error in</source>
        <translation>Fehler gilt</translation>
    </message>
    <message>
        <source>What an interrupted build left in &apos;%1&apos; is damaged. Build from the beginning.</source>
        <translation>Was ein unterbrochener Bau in „%1“ hinterlassen hat, ist beschädigt. Beginnen Sie den Bau von vorn.</translation>
    </message>
    <message>
        <source>What an interrupted build left in &apos;%1&apos; belongs to other data, other options, or another version of TAn. Give the same ones, or build from the beginning.</source>
        <translation>Was ein unterbrochener Bau in „%1“ hinterlassen hat, gehört zu anderen Daten, anderen Optionen oder einer anderen Version von TAn. Geben Sie dieselben an, oder beginnen Sie den Bau von vorn.</translation>
    </message>
    <message>
        <source>Refining all blocks coarsely</source>
        <translation>Alle Blöcke werden grob verfeinert</translation>
    </message>
    <message>
        <source>Restoring the interrupted build</source>
        <translation>Bereits Getanes wird übernommen</translation>
    </message>
    <message>
        <source>it lists a faulty cell that its grid does not have</source>
        <translation>sie führt eine fehlerhafte Zelle auf, die ihr Gitter nicht hat</translation>
    </message>
    <message>
        <source>it lists a faulty cell that is not faulty</source>
        <translation>sie führt eine fehlerhafte Zelle auf, die keine ist</translation>
    </message>
    <message>
        <source>There is no file &apos;%1&apos;. An address on a server begins with http:// or https://.</source>
        <translation>Eine Datei „%1“ gibt es nicht. Eine Adresse auf einem Server beginnt mit http:// oder https://.</translation>
    </message>
    <message>
        <source>The file of &apos;%1&apos; was made by a version of TAn that did not record where its coarse meshes end, so it cannot be left at the server. Build it again, or copy it there with &apos;tan pack&apos; and &apos;tan unpack&apos;.</source>
        <translation>Die Datei von „%1“ ist von einer Version von TAn, die nicht schrieb, wo ihre groben Netze enden; sie kann also nicht auf dem Server bleiben. Bauen Sie sie neu, oder schreiben Sie sie dort mit „tan pack“ und „tan unpack“ neu.</translation>
    </message>
    <message>
        <source>A server cannot extract a range of accuracies whose two ends have different warpings. Give both the same.</source>
        <translation>Einen Server kann man nicht nach einem Bereich von Genauigkeiten fragen, dessen Enden eigene Verwerfungen haben. Geben Sie beiden dieselbe.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not extract meshes (status %2): only a TAn server (&apos;tan serve&apos;) of this version does. Download the model from there instead.</source>
        <translation>„%1“ bestimmt keine Netze (Status %2): Das tut nur ein Server von TAn („tan serve“) dieser Version. Lassen Sie das Modell von dort holen.</translation>
    </message>
    <message>
        <source>The server of &apos;%1&apos; says: %2</source>
        <translation>Der Server von „%1“ meldet: %2</translation>
    </message>
    <message>
        <source>What &apos;%1&apos; says of its model cannot be read. The server may run another version of TAn.</source>
        <translation>Was „%1“ über sein Modell sagt, ist nicht lesbar. Vielleicht ist es ein Server einer anderen Version von TAn.</translation>
    </message>
    <message>
        <source>The error field is too long for a server request: %1 of at most %2 characters. Use fewer regions, isovalues or points of the transfer function.</source>
        <translation>Was sagt, wo welcher Fehler erlaubt ist, ist zu lang für eine Frage an einen Server: %1 von höchstens %2 Zeichen. Nehmen Sie weniger Bereiche, Isowerte oder Punkte der Transferfunktion.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; was changed on its server. Open it again.</source>
        <translation>Das Modell „%1“ wurde auf seinem Server geändert. Öffnen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The sites yield more than they should.</source>
        <translation>Die Stützstellen ergeben mehr, als sie sollten.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has positions or values that are not finite.</source>
        <translation>„%1“ hat Positionen oder Werte, die nicht endlich sind.</translation>
    </message>
    <message>
        <source>Unpacking the mesh</source>
        <translation>Das Netz wird entpackt</translation>
    </message>
    <message>
        <source>Unpacking the whole model: %1</source>
        <translation>Das ganze Modell wird entpackt: %1</translation>
    </message>
    <message>
        <source>The server of &apos;%1&apos; requires a token. Give the one issued by its operator; on the command line with &apos;--token-file&apos;.</source>
        <translation>Der Server von „%1“ antwortet nur dem, der sein Token hat. Geben Sie das an, das sein Betreiber festgelegt hat; auf der Befehlszeile mit „--token-file“.</translation>
    </message>
    <message>
        <source>Packing the mesh</source>
        <translation>Das Netz wird gepackt</translation>
    </message>
    <message>
        <source>Waiting for the server</source>
        <translation>Warten auf den Server</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Empfangen</translation>
    </message>
    <message>
        <source>Asking the server</source>
        <translation>Anfrage an den Server</translation>
    </message>
    <message>
        <source>the server sends a web page or a list instead of data. Open the address in a browser: you may have to log in, or to choose a file there and give its address.</source>
        <translation>Der Server liefert eine Webseite oder eine Liste statt Daten. Öffnen Sie die Adresse in einem Browser: Vielleicht müssen Sie sich anmelden, oder dort eine Datei wählen und deren Adresse angeben.</translation>
    </message>
    <message>
        <source>the server requires a token. Give the one issued by its operator; on the command line with &apos;--token-file&apos;.</source>
        <translation>Der Server antwortet nur dem, der sein Token hat. Geben Sie das an, das sein Betreiber festgelegt hat; auf der Befehlszeile mit „--token-file“.</translation>
    </message>
    <message>
        <source>the server does not allow it (403). Ask its operator, or check whether the address has expired.</source>
        <translation>Der Server erlaubt es nicht (403). Fragen Sie seinen Betreiber, oder prüfen Sie, ob die Adresse abgelaufen ist.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is an address, and datasets are read from this computer only. Download it and give the file.</source>
        <translation>„%1“ ist eine Adresse, und Datensätze werden nur von diesem Rechner gelesen. Laden Sie die Datei herunter und geben Sie diese an.</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: it has more than %2 bytes, too many for such a file.</source>
        <translation>„%1“ kann nicht gelesen werden: Die Datei hat mehr als %2 Bytes, zu viele für eine solche Datei.</translation>
    </message>
    <message>
        <source>This TAn cannot make a mesh of the points of &apos;%1&apos;: it was built without CGAL (TAN_CGAL). Use one that has it, or data with a grid or with cells.</source>
        <translation>Dieses TAn macht kein Netz aus den Punkten von „%1“: Es wurde ohne CGAL (TAN_CGAL) gebaut. Nehmen Sie eines, das es hat, oder Daten mit einem Gitter oder mit Zellen.</translation>
    </message>
    <message>
        <source>The history has more than %1 sites. Choose a larger error, or build in blocks.</source>
        <translation>Die Geschichte hat mehr als %1 Stützstellen. Verlangen Sie einen größeren Fehler, oder bauen Sie in Blöcken.</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; holds impossible numbers</source>
        <translation>Abschnitt „%1“ enthält unmögliche Zahlen</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: section &apos;%2&apos; was planned with %3 bytes, which does not match its content. This is a fault of TAn: please report it.</source>
        <translation>„%1“ kann nicht geschrieben werden: Abschnitt „%2“ war mit %3 Bytes geplant, was nicht zu seinem Inhalt passt. Das ist ein Fehler von TAn: Bitte melden Sie ihn.</translation>
    </message>
    <message>
        <source>There is no folder for temporary files: %1.</source>
        <translation>Es gibt keinen Ordner für Zwischendateien: %1.</translation>
    </message>
    <message>
        <source>The model cannot be packed into &apos;%1&apos;: the errors that it claims are invalid. &apos;tan verify&apos; gives details.</source>
        <translation>Das Modell kann nicht in „%1“ gepackt werden: Die Fehler, die es angibt, ergeben keinen Sinn. „tan verify“ sagt mehr.</translation>
    </message>
    <message>
        <source>The mesh has %1 tetrahedra, too many for the memory of this machine. Choose a larger error or a part of it.</source>
        <translation>Das Netz hat %1 Tetraeder, zu viele für den Arbeitsspeicher dieses Rechners. Verlangen Sie einen größeren Fehler oder einen Teil davon.</translation>
    </message>
    <message>
        <source>something precedes section &apos;%1&apos;</source>
        <translation>vor Abschnitt „%1“ liegt etwas</translation>
    </message>
    <message>
        <source>This TAn cannot make a mesh of scattered points: it was built without CGAL (TAN_CGAL). Use one that has it, or data with a grid or with cells.</source>
        <translation>Dieses TAn macht kein Netz aus verstreuten Punkten: Es wurde ohne CGAL (TAN_CGAL) gebaut. Nehmen Sie eines, das es hat, oder Daten mit einem Gitter oder mit Zellen.</translation>
    </message>
    <message>
        <source>Cannot use the cache folder &apos;%1&apos;: %2. Set XDG_CACHE_HOME to a folder that only you can use.</source>
        <translation>Der Zwischenspeicher „%1“ ist nicht benutzbar: %2. Setzen Sie XDG_CACHE_HOME auf einen Ordner, der Ihnen allein gehört.</translation>
    </message>
    <message>
        <source>it belongs to another user</source>
        <translation>Er gehört einem anderen Benutzer</translation>
    </message>
    <message>
        <source>others can write to it</source>
        <translation>Andere können darin schreiben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another user</source>
        <translation>„%1“ gehört einem anderen Benutzer</translation>
    </message>
    <message>
        <source>everybody can write to &apos;%1&apos;</source>
        <translation>In „%1“ können alle schreiben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not answer: %2</source>
        <translation>„%1“ antwortet nicht: %2</translation>
    </message>
    <message>
        <source>nothing arrived for %1 seconds, or too slowly. Check the network, and whether the server is running.</source>
        <translation>%1 Sekunden lang kam nichts, oder es kam zu langsam. Prüfen Sie das Netz, und ob der Server läuft.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the address of a server. Write it as http://HOST:PORT/NAME.tan.</source>
        <translation>„%1“ ist keine Adresse eines Servers. Schreiben Sie sie als http://HOST:PORT/NAME.tan.</translation>
    </message>
    <message>
        <source>the server says that the file has %1, more than any model has. Check the address.</source>
        <translation>Der Server sagt, dass die Datei %1 hat, mehr als jedes Modell. Prüfen Sie die Adresse.</translation>
    </message>
    <message>
        <source>it is not the address of a file. Write it as https://HOST/PATH, with spaces as %1.</source>
        <translation>Das ist keine Adresse einer Datei. Schreiben Sie sie als https://RECHNER/PFAD, und Leerzeichen darin als %1.</translation>
    </message>
    <message>
        <source>This TAn was built without OpenGL (TAN_GL). Use the CPU back end.</source>
        <translation>Dieses TAn wurde ohne OpenGL (TAN_GL) gebaut. Lassen Sie den Prozessor zeichnen.</translation>
    </message>
    <message>
        <source>Cannot listen on port %1 of &apos;%2&apos;: %3. Choose another port with &apos;--port&apos;, or an address of this machine.</source>
        <translation>Port %1 von „%2“ kann nicht benutzt werden: %3. Wählen Sie mit „--port“ einen anderen Port, oder eine Adresse dieses Rechners.</translation>
    </message>
    <message>
        <source>The system cannot start a thread for the server: %1. %2</source>
        <translation>Das System kann keinen Thread für den Server starten: %1. %2</translation>
    </message>
    <message>
        <source>The system accepts no more connections: %1. %2</source>
        <translation>Das System nimmt keine Verbindungen mehr an: %1. %2</translation>
    </message>
    <message>
        <source>The file is being changed. Ask again.</source>
        <translation>Die Datei wird gerade geändert. Fragen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The server cannot read its models now: %1. Ask again.</source>
        <translation>Der Server kann jetzt nicht nach seinen Modellen suchen: %1. Fragen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be served: %2. Check its name.</source>
        <translation>Der Ordner „%1“ kann nicht bereitgestellt werden: %2. Prüfen Sie seinen Namen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another user, who could put any program there. Copy what you trust into a folder of your own.</source>
        <translation>„%1“ gehört einem anderen Benutzer, der jedes Programm dorthin legen könnte. Kopieren Sie, wem Sie trauen, in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>Every user of this machine can write to &apos;%1&apos;, and could put any program there. Remove that permission (chmod o-w), and check its content.</source>
        <translation>Jeder Benutzer dieses Rechners kann in „%1“ schreiben und könnte jedes Programm dorthin legen. Entziehen Sie dieses Recht (chmod o-w), und sehen Sie nach, was darin ist.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; is not a number anywhere: it cannot be computed from this solution. %2</source>
        <translation>Das Feld „%1“ hat nirgends eine Zahl: Es kann aus dieser Lösung nicht berechnet werden. %2</translation>
    </message>
    <message>
        <source>The domain is different, so the camera keeps its direction and shows all of the model.</source>
        <translation>Das Gebiet ist ein anderes, daher behält die Kamera ihre Richtung und zeigt das ganze Modell.</translation>
    </message>
    <message>
        <source>The focus is off: it is not within the domain.</source>
        <translation>Der Fokus ist ausgeschaltet: Er liegt nicht im Gebiet.</translation>
    </message>
    <message>
        <source>The crop box is off: it is not within the domain.</source>
        <translation>Das Fenster ist ausgeschaltet: Es liegt nicht im Gebiet.</translation>
    </message>
    <message>
        <source>Nothing is clipped: the clip planes are for another domain.</source>
        <translation>Nichts wird abgeschnitten: Die Schnittebenen gelten für ein anderes Gebiet.</translation>
    </message>
    <message>
        <source>The film has no key frames: their cameras are for another domain.</source>
        <translation>Der Film hat keine Schlüsselbilder: Ihre Kameras gelten für ein anderes Gebiet.</translation>
    </message>
    <message>
        <source>None of the isovalues lies within the model&apos;s values, %1 to %2, so the default ones are shown.</source>
        <translation>Keiner der Isowerte liegt innerhalb der Werte des Modells, %1 bis %2, daher werden die üblichen gezeigt.</translation>
    </message>
    <message>
        <source>%1 of %2 isovalues are left out: they are not within the model&apos;s values, %3 to %4.</source>
        <translation>%1 von %2 Isowerten sind weggelassen: Sie liegen nicht innerhalb der Werte des Modells, %3 bis %4.</translation>
    </message>
    <message>
        <source>The transfer function has no point within the model&apos;s values, so the default one is shown.</source>
        <translation>Die Transferfunktion hat keinen Punkt innerhalb der Werte des Modells, daher wird die übliche gezeigt.</translation>
    </message>
    <message>
        <source>All values are shown: the model has none of the selected ones.</source>
        <translation>Alle Werte werden gezeigt: Das Modell hat keinen der gewählten.</translation>
    </message>
    <message>
        <source>There is no rendering mode &apos;%1&apos; here, so the model is shown as &apos;%2&apos;. It may belong to a plugin that is not installed.</source>
        <translation>Es gibt hier keine Darstellungsart „%1“, daher wird als „%2“ gezeigt. Vielleicht gehört sie zu einem Plugin, das nicht installiert ist.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; has changed since the session was saved: it was rebuilt or replaced.</source>
        <translation>Das Modell „%1“ hat sich seit dem Speichern der Sitzung geändert: Es wurde neu gebaut oder ersetzt.</translation>
    </message>
    <message>
        <source>This file cannot be read as a transfer function. TAn reads its own and ParaView&apos;s presets in JSON, and ParaView&apos;s colour maps in XML, but not tables of colours.</source>
        <translation>Diese Datei kann nicht als Transferfunktion gelesen werden. TAn liest seine eigenen und die Vorlagen von ParaView in JSON sowie die Farbtabellen von ParaView in XML, aber keine Listen von Farben.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a surface. TAn reads volumes: values throughout a body, not only on its surface.</source>
        <translation>„%1“ enthält eine Fläche. TAn liest Volumen: Werte überall in einem Körper, nicht nur auf seiner Haut.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a picture. TAn reads volumes, including stacks of TIFF pictures, and opens pictures that it has saved with their session.</source>
        <translation>„%1“ ist ein Bild. TAn liest Volumen, darunter Stapel von TIFF-Bildern, und öffnet Bilder, die es mit ihrer Sitzung gespeichert hat.</translation>
    </message>
    <message>
        <source>TAn reads files such as %1; the manual lists all of them. Samples alone, without a header, are read as a raw file.</source>
        <translation>TAn liest Dateien wie %1; das Handbuch nennt alle. Abtastwerte allein, ohne Kopf, werden als Rohdatei gelesen.</translation>
    </message>
    <message>
        <source>What &apos;%1&apos; says of its model is impossible: %2. Tell its operator, or download the model and check it with &apos;tan verify&apos;.</source>
        <translation>Was „%1“ von seinem Modell sagt, ist unmöglich: %2. Sagen Sie es dem Betreiber des Servers, oder holen Sie das Modell und prüfen Sie es mit „tan verify“.</translation>
    </message>
    <message>
        <source>it has %1 sites</source>
        <translation>es hat %1 Stützstellen</translation>
    </message>
    <message>
        <source>it has %1 tetrahedra</source>
        <translation>es hat %1 Tetraeder</translation>
    </message>
    <message>
        <source>it has %1 bytes</source>
        <translation>es hat %1 Bytes</translation>
    </message>
    <message>
        <source>a mesh has %1 of its %2 sites</source>
        <translation>ein Netz hat %1 seiner %2 Stützstellen</translation>
    </message>
    <message>
        <source>a mesh has %1 of its %2 tetrahedra</source>
        <translation>ein Netz hat %1 seiner %2 Tetraeder</translation>
    </message>
    <message>
        <source>a mesh has the error %1 % and the warping %2 %</source>
        <translation>ein Netz hat den Fehler %1 % und die Verwerfung %2 %</translation>
    </message>
    <message>
        <source>a mesh with %1 sites comes before one with %2</source>
        <translation>ein Netz mit %1 Stützstellen steht vor einem mit %2</translation>
    </message>
    <message>
        <source>a mesh has %1 of %2 sites, and the model %3</source>
        <translation>ein Netz hat %1 von %2 Stützstellen und das Modell %3</translation>
    </message>
    <message>
        <source>a mesh has %1 of %2 tetrahedra, and the model %3</source>
        <translation>ein Netz hat %1 von %2 Tetraedern und das Modell %3</translation>
    </message>
    <message>
        <source>a mesh keeps %1 times the error</source>
        <translation>ein Netz hält das %1-fache des Fehlers ein</translation>
    </message>
    <message>
        <source>a tetrahedron exists at errors that are not numbers of at least 0</source>
        <translation>ein Tetraeder lebt bei Fehlern, die keine Zahlen ab 0 sind</translation>
    </message>
    <message>
        <source>the libcurl of this machine does not support what TAn needs (%1). Check the address and SSL_CERT_FILE, and install a libcurl with HTTPS, 7.85 or later.</source>
        <translation>die libcurl dieses Rechners kann nicht, was TAn braucht (%1). Prüfen Sie die Adresse und SSL_CERT_FILE, und installieren Sie eine libcurl mit HTTPS ab 7.85.</translation>
    </message>
    <message>
        <source>This TAn was built without the network (TAN_NETWORK), so it cannot open &apos;%1&apos;. Download the file and open the copy.</source>
        <translation>Dieses TAn ist ohne Netzwerk gebaut (TAN_NETWORK) und kann „%1“ nicht öffnen. Laden Sie die Datei herunter und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>a level of accuracy has no mesh of its own</source>
        <translation>eine Genauigkeitsstufe hat kein eigenes Netz</translation>
    </message>
    <message>
        <source>its three directions %1; %2; %3 lie in a plane, or are not of unit length, so that it has no volume. Give three that span one.</source>
        <translation>seine drei Richtungen %1; %2; %3 liegen in einer Ebene oder haben nicht die Länge 1, sodass es kein Volumen hat. Geben Sie drei an, die eines aufspannen.</translation>
    </message>
    <message>
        <source>it has a section &apos;%1&apos;, which only a regular lattice has</source>
        <translation>sie hat einen Abschnitt „%1“, den nur ein regelmäßiges Gitter hat</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: its section &apos;%2&apos; is invalid. Copy the file again, or build it again.</source>
        <translation>„%1“ ist beschädigt: Ihr Abschnitt „%2“ ergibt keinen Sinn. Kopieren Sie die Datei neu, oder erstellen Sie sie neu.</translation>
    </message>
    <message>
        <source>Copying the model</source>
        <translation>Das Modell wird kopiert</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was built with weights at places (&apos;%2&apos;), which would then lie elsewhere than intended. Build it again from data that state where they lie.</source>
        <translation>„%1“ wurde mit Gewichten an bestimmten Stellen erstellt („%2“), die dann anderswo lägen, als sie gemeint waren. Erstellen Sie es neu aus Daten, die sagen, wo sie liegen.</translation>
    </message>
    <message>
        <source>The model cannot be placed there: %1</source>
        <translation>Das Modell kann dort nicht liegen: %1</translation>
    </message>
    <message>
        <source>Not enough memory to copy the model. Close other programs.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um das Modell zu kopieren. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Measuring the deviation</source>
        <translation>Die Abweichung wird gemessen</translation>
    </message>
    <message>
        <source>One of the two surfaces is empty, so there is no distance.</source>
        <translation>Eine der beiden Flächen ist leer, deshalb gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>Not enough memory to measure the deviation. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um die Abweichung zu messen. Schließen Sie andere Programme, oder verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>its section &apos;%1&apos; is invalid</source>
        <translation>ihr Abschnitt „%1“ ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>Closing the surface</source>
        <translation>Die Fläche wird geschlossen</translation>
    </message>
    <message>
        <source>The mesh has too many tetrahedra for its boundary to be found. Lower the accuracy of the mesh.</source>
        <translation>Das Netz hat zu viele Tetraeder, um seine Berandung zu finden. Verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>Not enough memory to close the isosurface. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Der Arbeitsspeicher reicht nicht, um die Isofläche zu schließen. Schließen Sie andere Programme, oder verringern Sie die Genauigkeit des Netzes.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has coordinates in single precision, which cannot hold this surface: it is too large or too small. Write a .vtp or .ply file.</source>
        <translation>„%1“ hat Koordinaten in einfacher Genauigkeit, die diese Fläche nicht fassen kann: Sie ist zu groß oder zu klein. Schreiben Sie eine .vtp- oder .ply-Datei.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: the program that reads it has ended. Look at its messages.</source>
        <translation>„%1“ kann nicht geschrieben werden: Das Programm, das es lesen sollte, wurde beendet. Sehen Sie nach, was jenes Programm meldet.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2.</source>
        <translation>„%1“ kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a second file next to &apos;%2&apos;. Give the output a name instead of &apos;-&apos;.</source>
        <translation>„%1“ wäre eine zweite Datei neben „%2“. Geben Sie der Ausgabe einen Namen statt „-“.</translation>
    </message>
    <message>
        <source>&apos;data file: %1&apos; in its header %2</source>
        <translation>„data file: %1“ in ihrem Kopf %2</translation>
    </message>
    <message>
        <source>must end with the number of dimensions that each file holds, from 1 to %1, or without it.</source>
        <translation>muss mit der Zahl der Dimensionen enden, die jede Datei fasst, von 1 bis %1, oder ohne sie.</translation>
    </message>
    <message>
        <source>must be a name with a number such as &apos;%03d&apos;, and the number of the first file, of the last, and the step.</source>
        <translation>muss ein Name mit einer Zahl wie „%03d“ sein, dann die Nummern der ersten und der letzten Datei und die Schrittweite.</translation>
    </message>
    <message>
        <source>names %1 files, which is not the number that its sizes require. Correct the numbers of the first and the last file.</source>
        <translation>nennt %1 Dateien, was nicht die Zahl ist, die ihre Größen verlangen. Berichtigen Sie die Nummern der ersten und der letzten Datei.</translation>
    </message>
    <message>
        <source>is followed by the names of %1 files, which is not the number that its sizes require. Each is on a line of its own.</source>
        <translation>ist gefolgt von den Namen von %1 Dateien, was nicht die Zahl ist, die ihre Größen verlangen. Jeder steht in einer eigenen Zeile.</translation>
    </message>
    <message>
        <source>one of its axes, of size %1, is time. A volume has three axes in space: take out one time step.</source>
        <translation>eine ihrer Achsen, der Größe %1, läuft durch die Zeit. Ein Volumen hat drei im Raum: Nehmen Sie einen Zeitschritt heraus.</translation>
    </message>
    <message>
        <source>Its header calls its orientation &apos;%1&apos;, but by its matrix it is &apos;%2&apos;. The matrix was used.</source>
        <translation>Ihr Kopf nennt die Ausrichtung „%1“, die nach ihrer Matrix „%2“ ist. Die Matrix wurde genommen.</translation>
    </message>
    <message>
        <source>its Direction is &apos;%1&apos; and not nine numbers.</source>
        <translation>ihre Direction ist „%1“ und nicht neun Zahlen.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; x, y and z are smaller than in the data by %2, %3 and %4, because single precision is too coarse so far from the origin; the first node of the file adds these numbers.</source>
        <translation>In „%1“ sind x, y und z um %2, %3 und %4 kleiner als in den Daten, weil einfache Genauigkeit so weit vom Ursprung zu grob ist; der erste Knoten der Datei addiert diese Zahlen.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; x, y and z are smaller than in the data by %2, %3 and %4, because single precision is too coarse so far from the origin: add these numbers to get places of the data.</source>
        <translation>In „%1“ sind x, y und z um %2, %3 und %4 kleiner als in den Daten, weil einfache Genauigkeit so weit vom Ursprung zu grob ist: Addieren Sie diese Zahlen, um Orte der Daten zu erhalten.</translation>
    </message>
    <message>
        <source>The deviation is measured from the finest mesh, which stays at the server. Save without it, or download the model.</source>
        <translation>Die Abweichung wird vom feinsten Netz aus gemessen, das auf dem Server bleibt. Speichern Sie ohne sie, oder holen Sie das Modell.</translation>
    </message>
    <message>
        <source>The deviation is that of whole surfaces. Show all values, and cut off what lies outside the crop box, or save without it.</source>
        <translation>Die Abweichung ist die ganzer Flächen. Zeigen Sie alle Werte, und schneiden Sie ab, was außerhalb des Fensters liegt, oder speichern Sie ohne sie.</translation>
    </message>
    <message>
        <source>The tetrahedra of a range of errors overlap, so they make no solid. Show the mesh of one error.</source>
        <translation>Was in einem Bereich von Fehlern lebt, liegt übereinander und ergibt deshalb keinen Körper. Zeigen Sie das Netz eines einzigen Fehlers.</translation>
    </message>
    <message>
        <source>Value %1: closed; parts: %2, area: %3, volume: %4.</source>
        <translation>Wert %1: geschlossen; Teile: %2, Flächeninhalt: %3, Volumen: %4.</translation>
    </message>
    <message>
        <source>Value %1: open; openings: %2 (edges: %3), parts: %4, area: %5.</source>
        <translation>Wert %1: offen; Öffnungen: %2 (Kanten: %3), Teile: %4, Flächeninhalt: %5.</translation>
    </message>
    <message>
        <source>%1 More than two triangles meet at some edges: %2.</source>
        <translation>%1 An manchen Kanten treffen sich mehr als zwei Dreiecke: %2.</translation>
    </message>
    <message>
        <source>its %1 is &apos;%2&apos; and not %3 finite numbers.</source>
        <translation>ihr %1 ist „%2“ und nicht %3 endliche Zahlen.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>Files that do not state it: the unit of coordinates, such as mm. It is displayed; nothing is converted.</source>
        <translation>Dateien, die sie nicht angeben: die Einheit der Koordinaten, etwa mm. Sie wird angezeigt und rechnet nichts um.</translation>
    </message>
    <message>
        <source>The model is placed by the directions of its data, but its view was saved without them, because TAn up to version 0.1 read such data differently: its places were other ones. The camera shows all of it; choose regions again.</source>
        <translation>Das Modell liegt so, wie die Richtungen seiner Daten es sagen, und wurde ohne sie gesehen, wie TAn bis zur Version 0.1 solche Daten las: Seine Orte waren andere. Die Kamera zeigt alles davon; wählen Sie Bereiche neu.</translation>
    </message>
    <message>
        <source>its origin %1 and spacing %2 are not finite, or too large or small to compute with. Check both.</source>
        <translation>sein Ursprung %1 und sein Abstand %2 sind nicht endlich oder zu groß oder zu klein, um damit zu rechnen. Prüfen Sie beide.</translation>
    </message>
    <message>
        <source>Files that do not state it, including raw ones: the distance between neighbouring points along x, y and z, as in 1x1x2.5; by default 1.</source>
        <translation>Dateien, die ihn nicht nennen, darunter Rohdaten: der Abstand benachbarter Punkte entlang x, y und z, etwa 1x1x2.5; sonst wird 1 angenommen.</translation>
    </message>
    <message>
        <source>Files that do not state it: the position of the first point, as in 10,20,-5; by default 0.</source>
        <translation>Dateien, die ihn nicht nennen: der Ort des ersten Punktes, etwa 10,20,-5; sonst wird 0 angenommen.</translation>
    </message>
    <message>
        <source>The file does not state its spacing: %1 is assumed. Give it with &apos;--spacing&apos; or in Import Options, or afterwards with &apos;tan set-frame&apos;.</source>
        <translation>Die Datei gibt ihren Abstand nicht an: %1 wird angenommen. Geben Sie ihn mit „--spacing“ oder unter Importoptionen an, oder nachträglich mit „tan set-frame“.</translation>
    </message>
    <message>
        <source>names %1 files. Put the samples into fewer.</source>
        <translation>nennt %1 Dateien. Verteilen Sie die Abtastwerte auf weniger.</translation>
    </message>
    <message>
        <source>Its space &apos;%1&apos; is left-handed. Its coordinates are kept, and pictures and other programs treat them as right-handed: they show the mirror image.</source>
        <translation>Ihr Raum „%1“ ist linkshändig. Seine Koordinaten bleiben, und Bilder und andere Programme nehmen sie als rechtshändig: Sie zeigen das Spiegelbild.</translation>
    </message>
    <message>
        <source>Its units differ from axis to axis: %1. Its numbers were used as they are, without a unit.</source>
        <translation>Ihre Einheiten sind von Achse zu Achse verschieden: %1. Ihre Zahlen wurden genommen, wie sie sind, ohne Einheit.</translation>
    </message>
    <message>
        <source>Looking for openings</source>
        <translation>Öffnungen werden gesucht</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; one triangle is left out, because two of its corners coincide in single precision.</source>
        <translation>In „%1“ fehlt ein Dreieck, da zwei seiner Ecken in einfacher Genauigkeit gleich sind.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; %2 triangles are left out, because two corners of each coincide in single precision.</source>
        <translation>In „%1“ fehlen %2 Dreiecke, da je zwei ihrer Ecken in einfacher Genauigkeit gleich sind.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not contain the triangles&apos; values (%2), because many programs cannot read a PLY file with such values. To keep them, write a .vtp file.</source>
        <translation>„%1“ hat die Werte der Dreiecke (%2) nicht, da viele Programme keine PLY-Datei mit solchen Werten lesen können. Um sie zu behalten, schreiben Sie eine .vtp-Datei.</translation>
    </message>
    <message>
        <source>The finest mesh has the surface of %1 and this mesh does not, so no deviation is stated.</source>
        <translation>Das feinste Netz hat die Fläche von %1 und dieses Netz nicht, daher wird keine Abweichung angegeben.</translation>
    </message>
    <message>
        <source>The finest mesh does not have the surface of %1, so no deviation is stated.</source>
        <translation>Das feinste Netz hat die Fläche von %1 nicht, daher wird keine Abweichung angegeben.</translation>
    </message>
    <message>
        <source>Value %1: empty.</source>
        <translation>Wert %1: leer.</translation>
    </message>
    <message>
        <source>%1 Deviation from the finest mesh, measured at many places: largest %2 (mean %3), and of that from this: largest %4 (mean %5).</source>
        <translation>%1 Abweichung vom feinsten Netz, an vielen Orten gemessen: größte %2 (Mittel %3), und die von jenem zu diesem: größte %4 (Mittel %5).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a model of a regular lattice: each of its points has its own position. Spacing, origin and unit can be set afterwards for a lattice only; for other data give &apos;--unit&apos; when you build the model.</source>
        <translation>„%1“ ist kein Modell eines regelmäßigen Gitters: Seine Punkte liegen, wo die Daten es sagen, jeder für sich. Nur bei einem regelmäßigen Gitter lassen sich Abstand, Ursprung und Einheit nachträglich setzen; bei anderen Daten geben Sie „--unit“ beim Bau des Modells an.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;%2&apos; is not understood. Give three numbers, along x, y and z, as in %3.</source>
        <translation>„%1“ für „%2“ ist nicht verständlich. Geben Sie drei Zahlen an, entlang x, y und z, etwa %3.</translation>
    </message>
    <message>
        <source>it states its %1 itself. Leave &apos;--%1&apos; out; &apos;tan set-frame&apos; changes it in the model of a lattice.</source>
        <translation>sie nennt ihr %1 selbst. Lassen Sie „--%1“ weg; „tan set-frame“ gibt dem Modell eines regelmäßigen Gitters ein anderes.</translation>
    </message>
    <message>
        <source>1 polyhedron was cut into tetrahedra.</source>
        <translation>1 Polyeder wurde in Tetraeder zerlegt.</translation>
    </message>
    <message>
        <source>1 polyhedron was cut into tetrahedra around a point in its middle.</source>
        <translation>1 Polyeder wurde um einen Punkt in seiner Mitte in Tetraeder zerlegt.</translation>
    </message>
    <message>
        <source>%1 polyhedra were cut into tetrahedra.</source>
        <translation>%1 Polyeder wurden in Tetraeder zerlegt.</translation>
    </message>
    <message>
        <source>%1 polyhedra were cut into tetrahedra; %2 of them got a point in the middle.</source>
        <translation>%1 Polyeder wurden in Tetraeder zerlegt; %2 davon bekamen einen Punkt in der Mitte.</translation>
    </message>
    <message>
        <source>Polyhedra left out because no point in them sees all of their faces: %1.</source>
        <translation>Polyeder, die weggelassen wurden, weil kein Punkt in ihnen alle ihre Seiten sieht: %1.</translation>
    </message>
    <message>
        <source>Polyhedra left out because no tetrahedra between their own points fill them: %1. With &apos;--polyhedra centre&apos; they get a point in the middle.</source>
        <translation>Polyeder, die weggelassen wurden, weil keine Tetraeder zwischen ihren eigenen Punkten sie füllen: %1. Mit „--polyhedra centre“ bekommen sie einen Punkt in der Mitte.</translation>
    </message>
    <message>
        <source>Polyhedra left out because their faces do not enclose a volume: %1.</source>
        <translation>Polyeder, die weggelassen wurden, weil ihre Seiten kein Volumen umschließen: %1.</translation>
    </message>
    <message>
        <source>The share of cells that may be faulty is %1; it must be from 0 to 1.</source>
        <translation>Der Anteil der Zellen, die fehlerhaft sein dürfen, ist %1; er muss von 0 bis 1 sein.</translation>
    </message>
    <message>
        <source>Faces of polyhedra have more points than are listed (%1 in all, the first is of cell %2). The file is damaged.</source>
        <translation>Seiten von Polyedern haben mehr Punkte, als genannt sind (%1 insgesamt, die erste gehört zu Zelle %2). Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>At least %1 of the mesh&apos;s %2 cells are faulty, more than %3. The first is cell %4 at (%5, %6, %7): %8. Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %9&apos;.</source>
        <translation>Mindestens %1 der %2 Zellen des Netzes sind fehlerhaft, mehr als %3. Die erste ist Zelle %4 bei (%5, %6, %7): %8. Reparieren Sie das Netz in dem Programm, das es erzeugt hat, oder lassen Sie zu, dass mehr Zellen weggelassen werden, etwa mit „--faulty %9“.</translation>
    </message>
    <message>
        <source>%1 cells are folded or so warped that no tetrahedra fill them, more than %2; the first is cell %3 at (%4, %5, %6). Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %7&apos;.</source>
        <translation>%1 Zellen sind gefaltet oder so verzogen, dass keine Tetraeder sie füllen, mehr als %2; die erste ist Zelle %3 bei (%4, %5, %6). Reparieren Sie das Netz in dem Programm, das es erzeugt hat, oder lassen Sie zu, dass mehr Zellen weggelassen werden, etwa mit „--faulty %7“.</translation>
    </message>
    <message>
        <source>cell %1 at (%2, %3, %4)</source>
        <translation>Zelle %1 bei (%2, %3, %4)</translation>
    </message>
    <message>
        <source>%1 of the mesh&apos;s %2 cells are polyhedra in which no point sees all of their faces, more than %3; the first is %4. Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %5&apos;.</source>
        <translation>%1 der %2 Zellen des Netzes sind Polyeder, in denen kein Punkt alle ihre Seiten sieht, mehr als %3; die erste ist %4. Reparieren Sie das Netz in dem Programm, das es erzeugt hat, oder lassen Sie zu, dass mehr Zellen weggelassen werden, etwa mit „--faulty %5“.</translation>
    </message>
    <message>
        <source>%1 of the mesh&apos;s %2 cells are polyhedra that no tetrahedra between their own points fill, more than %3; the first is %4. With &apos;--polyhedra centre&apos; they get a point in the middle; with &apos;--faulty %5&apos; they are left out.</source>
        <translation>%1 der %2 Zellen des Netzes sind Polyeder, die von keinen Tetraedern zwischen ihren eigenen Punkten gefüllt werden, mehr als %3; die erste ist %4. Mit „--polyhedra centre“ bekommen sie einen Punkt in der Mitte; mit „--faulty %5“ werden sie weggelassen.</translation>
    </message>
    <message>
        <source>The faces of %1 of the mesh&apos;s %2 cells do not enclose a volume; the first is cell %3 at (%4, %5, %6). Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %7&apos;.</source>
        <translation>Die Seiten von %1 der %2 Zellen des Netzes umschließen kein Volumen; die erste ist Zelle %3 bei (%4, %5, %6). Reparieren Sie das Netz in dem Programm, das es erzeugt hat, oder lassen Sie zu, dass mehr Zellen weggelassen werden, etwa mit „--faulty %7“.</translation>
    </message>
    <message>
        <source>Joining the zones</source>
        <translation>Zonen werden verbunden</translation>
    </message>
    <message>
        <source>The zone &apos;%1&apos; is not a structured grid with a value for each point.</source>
        <translation>Die Zone „%1“ ist kein strukturiertes Gitter mit einem Wert für jeden Punkt.</translation>
    </message>
    <message>
        <source>None of the zones has cells: a volume has at least two points along each of three axes.</source>
        <translation>Keine der Zonen hat Zellen: Ein Volumen hat mindestens zwei Punkte entlang jeder von drei Achsen.</translation>
    </message>
    <message>
        <source>The zones have %1 points; at most 4294967294 can be numbered. Take one zone.</source>
        <translation>Die Zonen haben %1 Punkte; höchstens 4294967294 können nummeriert werden. Nehmen Sie eine Zone.</translation>
    </message>
    <message>
        <source>The zones have %1 cells, whose mesh takes up to %2 of memory, of %3. Take one zone.</source>
        <translation>Die Zonen haben %1 Zellen, deren Netz bis zu %2 Speicher braucht, von %3. Nehmen Sie eine Zone.</translation>
    </message>
    <message>
        <source>Its %1 zones were joined into one mesh, in which they share %2 faces.</source>
        <translation>Ihre %1 Zonen wurden zu einem Netz verbunden, in dem sie %2 Seiten gemeinsam haben.</translation>
    </message>
    <message>
        <source>Its %1 zones were put into one mesh, in which no two of them share a face.</source>
        <translation>Ihre %1 Zonen wurden in ein Netz gesetzt, in dem keine zwei von ihnen eine Seite gemeinsam haben.</translation>
    </message>
    <message>
        <source>Faces of zones that meet another zone with different points there: %1. The mesh has a seam there, and is not connected across it.</source>
        <translation>Seiten von Zonen, die an einer anderen Zone liegen, deren Punkte dort andere sind: %1. Das Netz hat dort eine Naht, über die hinweg es nicht zusammenhängt.</translation>
    </message>
    <message>
        <source>Zones left out because they have no volume: %1.</source>
        <translation>Zonen, die weggelassen wurden, weil sie kein Volumen haben: %1.</translation>
    </message>
    <message>
        <source>array</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Lage im Raum</translation>
    </message>
    <message>
        <source>unit of the values</source>
        <translation>Einheit der Werte</translation>
    </message>
    <message>
        <source>fill value</source>
        <translation>Füllwert</translation>
    </message>
    <message>
        <source>%1: %2 (a guess)</source>
        <translation>%1: %2 (vermutet)</translation>
    </message>
    <message>
        <source>Faulty cells</source>
        <translation>Fehlerhafte Zellen</translation>
    </message>
    <message>
        <source>Meshes: the largest share of cells, or of their volume, that may be left out because they overlap others or are inverted, as in 5%; a mesh with more of them is refused.</source>
        <translation>Netze: der größte Anteil der Zellen oder ihres Volumens, der weggelassen werden darf, weil sie andere überlappen oder umgestülpt sind, etwa 5%; ein Netz mit mehr davon wird abgelehnt.</translation>
    </message>
    <message>
        <source>Give a share from 0% to 100%, as in 5%.</source>
        <translation>Geben Sie einen Anteil von 0% bis 100% an, etwa 5%.</translation>
    </message>
    <message>
        <source>Polyhedra</source>
        <translation>Polyeder</translation>
    </message>
    <message>
        <source>Meshes with polyhedra: &apos;corners&apos; cuts each into tetrahedra between its own points; &apos;centre&apos; adds a point in the middle of those that cannot be cut in that way.</source>
        <translation>Netze mit Polyedern: „Ecken“ zerlegt jedes in Tetraeder zwischen seinen eigenen Punkten; „Mitte“ gibt denen, bei denen das nicht geht, einen Punkt in der Mitte.</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;faulty&apos; is not understood. Give a share from 0% to 100%, as in 5%.</source>
        <translation>„%1“ für „faulty“ ist nicht verständlich. Geben Sie einen Anteil von 0% bis 100% an, etwa 5%.</translation>
    </message>
    <message>
        <source>a MINC volume</source>
        <translation>ein MINC-Volumen</translation>
    </message>
    <message>
        <source>Convert it to NIfTI, with &apos;mnc2nii&apos; of the MINC tools.</source>
        <translation>Wandeln Sie es mit „mnc2nii“ aus den MINC-Werkzeugen in NIfTI um.</translation>
    </message>
    <message>
        <source>a volume of FreeSurfer</source>
        <translation>ein Volumen von FreeSurfer</translation>
    </message>
    <message>
        <source>Convert it to NIfTI, with &apos;mri_convert&apos; of FreeSurfer.</source>
        <translation>Wandeln Sie es mit „mri_convert“ von FreeSurfer in NIfTI um.</translation>
    </message>
    <message>
        <source>an AVS field</source>
        <translation>ein AVS-Feld</translation>
    </message>
    <message>
        <source>Save it as VTK or NRRD in a program that reads it, or write an NRRD header (.nhdr) that names the numbers of a uniform one as its data file.</source>
        <translation>Speichern Sie es in einem Programm, das es liest, als VTK oder NRRD, oder schreiben Sie bei einem gleichmäßigen einen NRRD-Kopf (.nhdr), der die Zahlen als seine Datendatei nennt.</translation>
    </message>
    <message>
        <source>an OpenVDB volume</source>
        <translation>ein OpenVDB-Volumen</translation>
    </message>
    <message>
        <source>Sample it on a regular grid, and save that as VTK, NRRD or a NumPy array.</source>
        <translation>Tasten Sie es auf einem regelmäßigen Gitter ab, und speichern Sie das als VTK, NRRD oder NumPy-Array.</translation>
    </message>
    <message>
        <source>an Amira file</source>
        <translation>eine Amira-Datei</translation>
    </message>
    <message>
        <source>Export it from Amira as NRRD or VTK.</source>
        <translation>Exportieren Sie sie aus Amira als NRRD oder VTK.</translation>
    </message>
    <message>
        <source>a microscope&apos;s own file</source>
        <translation>eine Datei im eigenen Format eines Mikroskops</translation>
    </message>
    <message>
        <source>Export it as OME-TIFF, with Fiji or the microscope&apos;s program.</source>
        <translation>Exportieren Sie sie als OME-TIFF, mit Fiji oder dem Programm des Mikroskops.</translation>
    </message>
    <message>
        <source>By its name &apos;%1&apos; is %2, which TAn does not read. %3</source>
        <translation>Dem Namen nach ist „%1“ %2, und das liest TAn nicht. %3</translation>
    </message>
    <message>
        <source>%1 needs more memory for it than the %2 that programs may use here. Raise the limit (ulimit -v).</source>
        <translation>%1 braucht dafür mehr Speicher als die %2, die Programme hier belegen dürfen. Heben Sie die Begrenzung an (ulimit -v).</translation>
    </message>
    <message>
        <source>There is not enough memory, or there are not enough processes or open files, to start the %1 readers (%2). Close other programs, or raise the limit (ulimit).</source>
        <translation>Speicher, Prozesse oder offene Dateien reichen nicht, um die %1-Leser zu starten (%2). Schließen Sie andere Programme, oder heben Sie die Begrenzung an (ulimit).</translation>
    </message>
    <message>
        <source>The %1 readers are not installed. %2</source>
        <translation>Die %1-Leser sind nicht installiert. %2</translation>
    </message>
    <message>
        <source>The %1 readers cannot be started: &apos;%2&apos;: %3</source>
        <translation>Die %1-Leser können nicht gestartet werden: „%2“: %3</translation>
    </message>
    <message>
        <source>The %1 readers are not installed: %2. %3</source>
        <translation>Die %1-Leser sind nicht installiert: %2. %3</translation>
    </message>
    <message>
        <source>The %1 readers are not installed correctly: %2. %3</source>
        <translation>Die %1-Leser sind fehlerhaft installiert: %2. %3</translation>
    </message>
    <message>
        <source>the system ended %1, which happens when memory runs out. Close other programs, or take a part of the file.</source>
        <translation>das System hat %1 beendet, wie es das tut, wenn der Speicher ausgeht. Schließen Sie andere Programme, oder nehmen Sie einen Teil der Datei.</translation>
    </message>
    <message>
        <source>%1 has waited for its disk for minutes. Check whether the disk answers, or copy the file to another one.</source>
        <translation>%1 wartet seit Minuten auf den Datenträger. Prüfen Sie, ob er antwortet, oder kopieren Sie die Datei auf einen anderen.</translation>
    </message>
    <message>
        <source>%1 says: %2. It cannot be read.</source>
        <translation>%1 meldet: %2. Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>quadratic-linear wedges</source>
        <translation>quadratisch-lineare Keile</translation>
    </message>
    <message>
        <source>convex point sets</source>
        <translation>konvexe Punktmengen</translation>
    </message>
    <message>
        <source>Bezier tetrahedra</source>
        <translation>Bézier-Tetraeder</translation>
    </message>
    <message>
        <source>Bezier hexahedra</source>
        <translation>Bézier-Hexaeder</translation>
    </message>
    <message>
        <source>Bezier wedges</source>
        <translation>Bézier-Keile</translation>
    </message>
    <message>
        <source>Bezier pyramids</source>
        <translation>Bézier-Pyramiden</translation>
    </message>
    <message>
        <source>the offsets of its faces are out of range.</source>
        <translation>die Anfänge ihrer Seiten liegen außerhalb des Bereichs.</translation>
    </message>
    <message>
        <source>a cell has %1 points, and its shape needs %2.</source>
        <translation>eine Zelle hat %1 Punkte, und ihre Form braucht %2.</translation>
    </message>
    <message>
        <source>the polyhedron %1 has no faces.</source>
        <translation>das Polyeder %1 hat keine Seiten.</translation>
    </message>
    <message>
        <source>the faces of the polyhedron %1 are damaged.</source>
        <translation>die Seiten des Polyeders %1 sind beschädigt.</translation>
    </message>
    <message>
        <source>Nodes in the faces of quadratic cells were not used: in %1 cells.</source>
        <translation>Knoten in den Seiten quadratischer Zellen wurden nicht benutzt: die von %1 Zellen.</translation>
    </message>
    <message>
        <source>For the Lagrange cells of order %1 (%2) only the corners were used, with straight edges.</source>
        <translation>Von den Lagrange-Zellen der Ordnung %1 (%2) wurden nur die Ecken benutzt, mit geraden Kanten.</translation>
    </message>
    <message>
        <source>For the Lagrange cells whose order differs by direction (%1) only the corners were used, with straight edges.</source>
        <translation>Von den Lagrange-Zellen, die nicht in allen Richtungen dieselbe Ordnung haben (%1), wurden nur die Ecken benutzt, mit geraden Kanten.</translation>
    </message>
    <message>
        <source>It states the time %1.</source>
        <translation>Sie gibt an, dass sie zum Zeitpunkt %1 gehört.</translation>
    </message>
    <message>
        <source>this TAn was built without GDCM, which reads DICOM. Rebuild it after &apos;apt install libgdcm-dev&apos;, or convert the file to NRRD.</source>
        <translation>dieses TAn wurde ohne GDCM gebaut, das DICOM liest. Bauen Sie es nach „apt install libgdcm-dev“ neu, oder wandeln Sie die Datei in NRRD um.</translation>
    </message>
    <message>
        <source>its number of frames is %1. It is damaged: copy the file again.</source>
        <translation>die Anzahl ihrer Bilder ist %1. Sie ist beschädigt: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it has %1 frames and describes %2 of them. It is damaged: copy the file again.</source>
        <translation>sie hat %1 Bilder und beschreibt davon %2. Sie ist beschädigt: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>the pieces of its packed pixels are damaged. Copy the file again.</source>
        <translation>die Stücke ihrer gepackten Pixel sind beschädigt. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>temporal position</source>
        <translation>zeitliche Position</translation>
    </message>
    <message>
        <source>echo</source>
        <translation>Echo</translation>
    </message>
    <message>
        <source>diffusion weight</source>
        <translation>Diffusionswichtung</translation>
    </message>
    <message>
        <source>trigger time</source>
        <translation>Triggerzeit</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>image type</source>
        <translation>Bildtyp</translation>
    </message>
    <message>
        <source>acquisition</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>acquired at</source>
        <translation>aufgenommen um</translation>
    </message>
    <message>
        <source>made at</source>
        <translation>erstellt um</translation>
    </message>
    <message>
        <source>it cannot be read.</source>
        <translation>sie kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>it is not a DICOM file, or ends too early. Copy the file again.</source>
        <translation>sie ist keine DICOM-Datei oder endet zu früh. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>Its slices are spaced unevenly, %1 to %2 mm apart; each was left where it lies.</source>
        <translation>Ihre Schichten liegen ungleichmäßig, mit Abständen von %1 bis %2 mm; jede blieb, wo sie liegt.</translation>
    </message>
    <message>
        <source>Missing after slice %1, between %2 and %3: %4.</source>
        <translation>Es fehlen hinter Schicht %1, zwischen %2 und %3: %4.</translation>
    </message>
    <message>
        <source>slices %1 mm apart (%2)</source>
        <translation>Schichten mit %1 mm Abstand (%2)</translation>
    </message>
    <message>
        <source>pixels %1 x %2 mm, as at the detector (ImagerPixelSpacing)</source>
        <translation>Pixel von %1 x %2 mm, wie am Detektor (ImagerPixelSpacing)</translation>
    </message>
    <message>
        <source>pixels 1 x 1 mm, because the file does not state their size</source>
        <translation>Pixel von 1 x 1 mm, da die Datei ihre Größe nicht angibt</translation>
    </message>
    <message>
        <source>some of its pixels are missing. Copy the file again.</source>
        <translation>ihre Pixel sind nicht alle da. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>GDCM cannot unpack its pixels (%1). They are damaged, or of a kind that it does not support: unpack them with the program that wrote them.</source>
        <translation>GDCM kann ihre Pixel nicht entpacken (%1). Sie sind beschädigt oder von einer Art, die es nicht kennt: Entpacken Sie sie mit dem Programm, das sie geschrieben hat.</translation>
    </message>
    <message>
        <source>it is the table of contents of a disk (DICOMDIR). Open one of the pictures in the folders next to it.</source>
        <translation>sie ist das Inhaltsverzeichnis eines Datenträgers (DICOMDIR). Öffnen Sie eines der Bilder, die in den Ordnern daneben liegen.</translation>
    </message>
    <message>
        <source>it is a segmentation, whose pictures are outlines of objects, not numbers. Export it as NRRD, for instance with 3D Slicer.</source>
        <translation>sie ist eine Segmentierung, deren Bilder Umrisse von Dingen enthalten und keine Zahlen. Exportieren Sie sie als NRRD, etwa mit 3D Slicer.</translation>
    </message>
    <message>
        <source>its pixels are floating-point numbers (FloatPixelData), which TAn does not read from DICOM files. Export it as NRRD, for instance with 3D Slicer.</source>
        <translation>ihre Pixel sind Gleitkommazahlen (FloatPixelData), die TAn aus DICOM-Dateien nicht liest. Exportieren Sie sie als NRRD, etwa mit 3D Slicer.</translation>
    </message>
    <message>
        <source>it holds no picture (%1). If it should have one, it is cut short: copy it again. Otherwise open a picture of the series that it belongs to.</source>
        <translation>sie enthält kein Bild (%1). Wenn sie eines haben soll, ist sie abgeschnitten: Kopieren Sie sie noch einmal. Sonst öffnen Sie ein Bild der Serie, zu der sie gehört.</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos; of its series: it is not a DICOM file, or ends too early. Copy the file again.</source>
        <translation>die Datei „%1“ ihrer Serie: Sie ist keine DICOM-Datei oder endet zu früh. Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos; of its series: %2</source>
        <translation>die Datei „%1“ ihrer Serie: %2</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; next to it was not read: %2</source>
        <translation>Die Datei „%1“ daneben wurde nicht gelesen: %2</translation>
    </message>
    <message>
        <source>it has no rows or columns. The file is damaged: copy or export it again.</source>
        <translation>sie hat keine Zeilen oder Spalten. Die Datei ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its pictures are in colour (%1), and TAn reads one value for each point. Export them in shades of grey.</source>
        <translation>ihre Bilder sind farbig (%1), und TAn liest einen Wert für jeden Punkt. Exportieren Sie sie in Graustufen.</translation>
    </message>
    <message>
        <source>each of its pictures is a mosaic of slices (Siemens). Convert it to NIfTI with dcm2niix.</source>
        <translation>jedes ihrer Bilder ist ein Mosaik von Schichten (Siemens). Wandeln Sie sie mit dcm2niix in NIfTI um.</translation>
    </message>
    <message>
        <source>its pictures are frames of a film and not slices of a volume.</source>
        <translation>ihre Bilder sind Zeitpunkte eines Films und keine Schichten eines Volumens.</translation>
    </message>
    <message>
        <source>its pixels have %1 bits, and TAn reads those of 8, 16 and 32. Write them with 16.</source>
        <translation>ihre Pixel haben %1 Bits, und TAn liest solche mit 8, 16 und 32. Schreiben Sie sie mit 16.</translation>
    </message>
    <message>
        <source>it states that %1 of %2 bits of a pixel count, up to bit %3. The file is damaged: copy or export it again.</source>
        <translation>sie gibt an, dass %1 von %2 Bits eines Pixels zählen, bis Bit %3. Die Datei ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Its pictures are meant to be shown with small values bright (MONOCHROME1); the values are as the file has them.</source>
        <translation>Ihre Bilder sind dafür gedacht, kleine Werte hell zu zeigen (MONOCHROME1); die Werte sind so, wie die Datei sie hat.</translation>
    </message>
    <message>
        <source>Pixels outside the picture have the value %1 (PixelPaddingValue), and are treated as ordinary values.</source>
        <translation>Pixel außerhalb des Bildes haben den Wert %1 (PixelPaddingValue) und sind Werte wie andere.</translation>
    </message>
    <message>
        <source>It has a table (ModalityLUT) that converts stored numbers into values; the stored numbers are used.</source>
        <translation>Sie hat eine Tabelle (ModalityLUT), die gespeicherte Zahlen in Werte umsetzt; genommen werden die gespeicherten Zahlen.</translation>
    </message>
    <message>
        <source>It states that its pictures were compressed with loss.</source>
        <translation>Sie gibt an, dass ihre Bilder verlustbehaftet komprimiert wurden.</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Next to it is series %1: %2. Choose it with &apos;series&apos;.</source>
        <translation>Daneben liegt Serie %1: %2. Wählen Sie sie mit „series“.</translation>
    </message>
    <message>
        <source>%1 more series are next to it.</source>
        <translation>%1 weitere Serien liegen daneben.</translation>
    </message>
    <message>
        <source>%1 pictures of the series have another size or direction, as overviews have, and were left out.</source>
        <translation>%1 Bilder der Serie haben eine andere Größe oder Richtung, wie Übersichtsbilder sie haben, und wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 files are copies of others, and were left out.</source>
        <translation>%1 Dateien sind Kopien anderer und wurden weggelassen.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>its values are scaled beyond the range of numbers (RescaleSlope). The file is damaged: copy or export it again.</source>
        <translation>ihre Werte sind über alle Zahlen hinaus skaliert (RescaleSlope). Die Datei ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 pictures of its series lie at one place, such as &apos;%2&apos; and &apos;%3&apos;, and nothing tells which of them belong together. Put the slices of one volume alone into a folder.</source>
        <translation>%1 Bilder ihrer Serie liegen am selben Ort, etwa „%2“ und „%3“, und nichts sagt, welche davon zusammengehören. Legen Sie die Schichten eines Volumens allein in einen Ordner.</translation>
    </message>
    <message>
        <source>number %1 of each place</source>
        <translation>Nummer %1 an jedem Ort</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos; of its series does not say where it lies (ImagePositionPatient), and others do. Take it out of the folder, or export the series again.</source>
        <translation>die Datei „%1“ ihrer Serie gibt nicht an, wo sie liegt (ImagePositionPatient), und andere tun es. Nehmen Sie sie aus dem Ordner, oder exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>it is a single picture, and no other slices of its series are next to it. TAn reads volumes: put the files of the series into one folder and open one of them.</source>
        <translation>sie ist ein einzelnes Bild, und keine anderen Schichten ihrer Serie liegen daneben. TAn liest Volumen: Legen Sie die Dateien der Serie in einen Ordner, und öffnen Sie eine davon.</translation>
    </message>
    <message>
        <source>it is a single picture of another size or direction than the %1 slices of its series. Open one of these, such as &apos;%2&apos;.</source>
        <translation>sie ist ein einzelnes Bild mit anderer Größe oder Richtung als die %1 Schichten ihrer Serie. Öffnen Sie eine von diesen, etwa „%2“.</translation>
    </message>
    <message>
        <source>of another size or direction</source>
        <translation>mit anderer Größe oder Richtung</translation>
    </message>
    <message>
        <source>all pictures of its series lie at one place. TAn reads volumes: it needs slices.</source>
        <translation>alle Bilder ihrer Serie liegen am selben Ort. TAn liest Volumen: Es braucht Schichten.</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Pictures with several channels: one of them, by name or number from 1; by default the first.</source>
        <translation>Bei Bildern mit mehreren Kanälen: einer, nach Name oder Nummer ab 1; sonst der erste.</translation>
    </message>
    <message>
        <source>Colour pictures: the number of one colour, from 0, or &apos;magnitude&apos;.</source>
        <translation>Bei farbigen Bildern: die Nummer einer Farbe, ab 0, oder „magnitude“ für den Betrag.</translation>
    </message>
    <message>
        <source>Pictures at several times, or several volumes at one place: which one, from 1; 0 takes the first, or for DICOM files the one of the file.</source>
        <translation>Bei Bildern zu mehreren Zeiten oder mehreren Volumen an einem Ort: welches, ab 1; 0 nimmt das erste, bei DICOM-Dateien das der Datei.</translation>
    </message>
    <message>
        <source>it is neither DICOM nor TIFF. Let TAn choose the reader.</source>
        <translation>sie ist weder DICOM noch TIFF. Lassen Sie TAn den Leser wählen.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libgdcm-dev libtiff-dev&apos;), or convert the file to NRRD.</source>
        <translation>Installieren Sie das Paket tan-vtk-readers, das mit TAn kommt: „apt install ./tan-vtk-readers_*.deb“, wo die Datei liegt (bei einem selbst gebauten TAn: bauen Sie es nach „apt install libgdcm-dev libtiff-dev“ neu), oder wandeln Sie die Datei in NRRD um.</translation>
    </message>
    <message>
        <source>Install GDCM and libtiff with &apos;apt install libgdcm3.0 libtiff6&apos;.</source>
        <translation>Installieren Sie GDCM und libtiff mit „apt install libgdcm3.0 libtiff6“.</translation>
    </message>
    <message>
        <source>Export it again, or in another format (NRRD, NIfTI).</source>
        <translation>Exportieren Sie sie noch einmal, oder in einem anderen Format (NRRD, NIfTI).</translation>
    </message>
    <message>
        <source>its OME description is not understood: %1. Export it again, or as NRRD.</source>
        <translation>ihre OME-Beschreibung ist nicht verständlich: %1. Exportieren Sie sie noch einmal, oder als NRRD.</translation>
    </message>
    <message>
        <source>it has %1 channels and describes %2</source>
        <translation>sie hat %1 Kanäle und beschreibt %2</translation>
    </message>
    <message>
        <source>a plane lies beyond its %1 slices and %2 times</source>
        <translation>eine Ebene liegt hinter ihren %1 Schichten und %2 Zeiten</translation>
    </message>
    <message>
        <source>it names a file of another folder, &apos;%1&apos;</source>
        <translation>sie nennt eine Datei eines anderen Ordners, „%1“</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>it has no images; they may be in another file</source>
        <translation>sie hat keine Bilder; die Datei, die sie hat, ist vielleicht eine andere</translation>
    </message>
    <message>
        <source>it has %1 images</source>
        <translation>sie hat %1 Bilder</translation>
    </message>
    <message>
        <source>its image %1 has no pixels</source>
        <translation>ihr Bild %1 hat keine Pixel</translation>
    </message>
    <message>
        <source>it has %1 slices, channels or times</source>
        <translation>sie hat %1 Schichten, Kanäle oder Zeitpunkte</translation>
    </message>
    <message>
        <source>it has more than %1 planes</source>
        <translation>Sie hat mehr als %1 Ebenen</translation>
    </message>
    <message>
        <source>its order of dimensions is &apos;%1&apos;</source>
        <translation>die Reihenfolge ihrer Dimensionen ist „%1“</translation>
    </message>
    <message>
        <source>this TAn was built without libtiff, which reads TIFF. Rebuild it after &apos;apt install libtiff-dev&apos;, or convert the file to NRRD.</source>
        <translation>dieses TAn wurde ohne libtiff gebaut, das TIFF liest. Bauen Sie es nach „apt install libtiff-dev“ neu, oder wandeln Sie die Datei in NRRD um.</translation>
    </message>
    <message>
        <source>libtiff says: %1. The file is damaged, or of a kind that libtiff does not support: copy or export it again.</source>
        <translation>libtiff sagt: %1. Die Datei ist beschädigt oder von einer Art, die libtiff nicht kennt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it is divided into pieces of no size.</source>
        <translation>sie ist in Stücke ohne Größe geteilt.</translation>
    </message>
    <message>
        <source>its pieces have an impossible size.</source>
        <translation>ihre Stücke haben eine unmögliche Größe.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;. Choose one from 1 to %3, or by its name.</source>
        <translation>sie hat kein „%1“ für „%2“. Wählen Sie eines von 1 bis %3 oder nach seinem Namen.</translation>
    </message>
    <message>
        <source>It has %1 channels; the others are not read. Choose one with &apos;channel&apos;.</source>
        <translation>Sie hat %1 Kanäle; die anderen werden nicht gelesen. Wählen Sie einen mit „channel“.</translation>
    </message>
    <message>
        <source>it holds one slice%1, and TAn reads volumes. Put the slices of one volume as numbered files into a folder, or as pages into one file.</source>
        <translation>sie enthält eine Schicht%1, und TAn liest Volumen. Legen Sie die Schichten eines Volumens als nummerierte Dateien in einen Ordner oder als Seiten in eine Datei.</translation>
    </message>
    <message>
        <source>its %1 times as slices</source>
        <translation>ihre %1 Zeitpunkte als Schichten</translation>
    </message>
    <message>
        <source>its OME description lists each plane many times. The file is damaged: export it again.</source>
        <translation>ihre OME-Beschreibung nennt jede Ebene viele Male. Die Datei ist beschädigt: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its OME description does not tell where slice %1 is. Export the file again.</source>
        <translation>ihre OME-Beschreibung sagt von Schicht %1 nicht, wo sie steht. Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source> of each of its %1 channels</source>
        <translation> von jedem ihrer %1 Kanäle</translation>
    </message>
    <message>
        <source>It holds %1 images; the others are not read. Choose one with &apos;series&apos;.</source>
        <translation>Sie enthält %1 Bilder; die anderen werden nicht gelesen. Wählen Sie eines mit „series“.</translation>
    </message>
    <message>
        <source>ImageJ&apos;s description claims %1 slices, but some of their pixels are missing. It is cut short: copy the file again.</source>
        <translation>Nach der Beschreibung von ImageJ enthält sie %1 Schichten, deren Pixel aber nicht alle da sind. Sie ist abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>ImageJ&apos;s description lists %1 planes, and there are %2 pages; each is read as a slice.</source>
        <translation>Die Beschreibung von ImageJ nennt %1 Ebenen, und es gibt %2 Seiten; jede wird als Schicht genommen.</translation>
    </message>
    <message>
        <source>The numbers of its files, from %1 to %2, are not consecutive; the slices are taken to be evenly spaced.</source>
        <translation>Die Nummern ihrer Dateien, von %1 bis %2, folgen nicht lückenlos aufeinander; angenommen wird, dass die Schichten gleichmäßig liegen.</translation>
    </message>
    <message>
        <source>Slices are missing among its numbered files: %1 (%2). The gaps stay, and values are interpolated over them.</source>
        <translation>Unter ihren nummerierten Dateien fehlen Schichten: %1 (%2). Die Lücken bleiben, und über sie hinweg werden die Werte interpoliert.</translation>
    </message>
    <message>
        <source>It has pages of its own; the %1 files next to it with the same kind of number are not read.</source>
        <translation>Sie hat eigene Seiten; die %1 Dateien neben ihr, die wie sie nummeriert sind, werden nicht gelesen.</translation>
    </message>
    <message>
        <source>its description refers to page %1, and it has %2. Export it again.</source>
        <translation>ihre Beschreibung nennt Seite %1, und die Datei hat %2. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>page %1 has another size or type than the first slice. The slices of one volume have one size.</source>
        <translation>Seite %1 hat eine andere Größe oder einen anderen Typ als die erste Schicht. Die Schichten eines Volumens haben alle dieselbe Größe.</translation>
    </message>
    <message>
        <source>its pixels have %1 components, and number %2 was requested. Choose one from 0 to %3, or &apos;magnitude&apos;.</source>
        <translation>ihre Pixel haben %1 Komponenten, und verlangt ist Nummer %2. Wählen Sie eine von 0 bis %3, oder „magnitude“.</translation>
    </message>
    <message>
        <source>the magnitude of %1</source>
        <translation>der Betrag von %1</translation>
    </message>
    <message>
        <source>%1 of 0 to %2</source>
        <translation>%1 von 0 bis %2</translation>
    </message>
    <message>
        <source>Each pixel has %1 numbers, of which one value is made. Choose one with &apos;component&apos;.</source>
        <translation>Jedes Pixel hat %1 Zahlen, aus denen ein Wert gemacht wird. Wählen Sie eine mit „component“.</translation>
    </message>
    <message>
        <source>its pixels are the numbers of colours in a palette. Convert it to shades of grey.</source>
        <translation>ihre Pixel sind die Nummern von Farben einer Palette. Wandeln Sie sie in Graustufen um.</translation>
    </message>
    <message>
        <source>its colours are of a kind that TAn does not read (PhotometricInterpretation %1). Convert it to shades of grey.</source>
        <translation>ihre Farben sind von einer Art, die TAn nicht liest (PhotometricInterpretation %1). Wandeln Sie sie in Graustufen um.</translation>
    </message>
    <message>
        <source>The colours of its palette are not used.</source>
        <translation>Die Farben ihrer Palette werden nicht benutzt.</translation>
    </message>
    <message>
        <source>Its pictures are meant to be shown with small values bright; the values are as the file has them.</source>
        <translation>Ihre Bilder sollen kleine Werte hell zeigen; die Werte sind so, wie sie in der Datei stehen.</translation>
    </message>
    <message>
        <source>its samples have %1 bits and the format %2 (SampleFormat), which TAn does not read. Write whole numbers or floating-point numbers of 32 bits.</source>
        <translation>ihre Abtastwerte haben %1 Bit und das Format %2 (SampleFormat), was TAn nicht liest. Schreiben Sie ganze Zahlen oder Gleitkommazahlen mit 32 Bit.</translation>
    </message>
    <message>
        <source>ImageJ&apos;s calibration of the values is not used: the stored values are.</source>
        <translation>Die Kalibrierung der Werte durch ImageJ wird nicht benutzt: Sie sind so, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>It states %1 pixels per inch, as pictures without a scale do; that is not used.</source>
        <translation>Sie nennt %1 Pixel pro Zoll, wie Bilder ohne Maßstab es tun; das wird nicht benutzt.</translation>
    </message>
    <message>
        <source>slices 1 %1 apart, as ImageJ assumes without &apos;spacing&apos;</source>
        <translation>Schichten im Abstand von 1 %1, wie ImageJ es ohne „spacing“ annimmt</translation>
    </message>
    <message>
        <source>slices as far apart as pixels, %1</source>
        <translation>Schichten im selben Abstand wie die Pixel, %1</translation>
    </message>
    <message>
        <source>%1 whole numbers of 64 bits were rounded to double precision.</source>
        <translation>%1 ganze Zahlen mit 64 Bit wurden auf doppelte Genauigkeit gerundet.</translation>
    </message>
    <message>
        <source>%1 of its pages are smaller copies of others, or masks.</source>
        <translation>%1 ihrer Seiten sind kleinere Kopien anderer Seiten oder Masken.</translation>
    </message>
    <message>
        <source>Smaller copies of its pages (SubIFDs) are not read.</source>
        <translation>Kleinere Kopien ihrer Seiten (SubIFDs) werden nicht gelesen.</translation>
    </message>
    <message>
        <source>line %1 of its header, &apos;%2&apos;, is not &apos;KEY: value&apos;. Correct or remove it.</source>
        <translation>Zeile %1 ihres Kopfes, „%2“, ist nicht von der Form „KEY: value“. Berichtigen oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>its %1, &apos;%2&apos;, is not three numbers. Correct the line.</source>
        <translation>ihr %1, „%2“, besteht nicht aus drei Zahlen. Berichtigen Sie die Zeile.</translation>
    </message>
    <message>
        <source>its header has no line &apos;%1:&apos;. Add it.</source>
        <translation>ihr Kopf hat keine Zeile „%1:“. Fügen Sie sie hinzu.</translation>
    </message>
    <message>
        <source>its %1, &apos;%2&apos;, is not understood. Correct the line.</source>
        <translation>ihr %1, „%2“, ist nicht zu verstehen. Berichtigen Sie die Zeile.</translation>
    </message>
    <message>
        <source>The file does not state the byte order of its numbers: that of this computer was assumed.</source>
        <translation>Die Datei nennt die Bytefolge ihrer Zahlen nicht: Die dieses Rechners wurde angenommen.</translation>
    </message>
    <message>
        <source>Its bytes from 0 to 255 were converted to the numbers from %1 to %2, as it states.</source>
        <translation>Aus ihren Bytes von 0 bis 255 wurden die Zahlen von %1 bis %2, wie sie es angibt.</translation>
    </message>
    <message>
        <source>the middles of the cells</source>
        <translation>die Mitten der Zellen</translation>
    </message>
    <message>
        <source>the points</source>
        <translation>die Punkte</translation>
    </message>
    <message>
        <source>its data are divided among several files, &apos;%1&apos;. Join them into one, or save the volume from VisIt as VTK.</source>
        <translation>ihre Daten sind auf mehrere Dateien verteilt, „%1“. Fügen Sie sie zu einer zusammen, oder speichern Sie das Volumen aus VisIt als VTK.</translation>
    </message>
    <message>
        <source>its bricks repeat the values of their neighbours (HAS_BOUNDARY), which is not read. Save the volume from VisIt as VTK.</source>
        <translation>ihre Blöcke wiederholen die Werte ihrer Nachbarn (HAS_BOUNDARY), was nicht gelesen wird. Speichern Sie das Volumen aus VisIt als VTK.</translation>
    </message>
    <message>
        <source>Its line &apos;%1: %2&apos; is not used.</source>
        <translation>Ihre Zeile „%1: %2“ wird nicht benutzt.</translation>
    </message>
    <message>
        <source>the number of atoms and the first point</source>
        <translation>die Zahl der Atome und der erste Punkt</translation>
    </message>
    <message>
        <source>a number of points and the step between them</source>
        <translation>eine Zahl von Punkten und der Schritt zwischen ihnen</translation>
    </message>
    <message>
        <source>it ends in its header, after line %1. It is cut short.</source>
        <translation>sie endet in ihrem Kopf, nach Zeile %1. Sie ist abgeschnitten.</translation>
    </message>
    <message>
        <source>line %1 of it is not %2, which a Gaussian cube has there. Correct the line, or write the file again.</source>
        <translation>in Zeile %1 steht nicht das Erwartete (%2), wie es ein Gaussian-Cube dort hat. Berichtigen Sie die Zeile, oder schreiben Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>an atom (its number, charge and position)</source>
        <translation>ein Atom (seine Nummer, seine Ladung und sein Ort)</translation>
    </message>
    <message>
        <source>its number of atoms is negative, and no list of orbitals follows the atoms. Correct it, or write the file again.</source>
        <translation>ihre Zahl der Atome ist negativ, und auf die Atome folgt keine Liste von Orbitalen. Berichtigen Sie sie, oder schreiben Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>the list after its atoms does not have the numbers of %1 orbitals. Correct it, or write the file again.</source>
        <translation>die Liste hinter ihren Atomen enthält nicht die Nummern von %1 Orbitalen. Berichtigen Sie sie, oder schreiben Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>line 3 of it ends with &apos;%1&apos;, where a number of values at each point is expected. Correct it, or leave it out.</source>
        <translation>ihre Zeile 3 endet mit „%1“, und verlangt ist dort die Zahl der Werte an jedem Punkt. Berichtigen Sie die Angabe, oder lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>its numbers of points are negative along some axes, as if some steps were in angstrom and others in bohr. Make all of them positive or all negative.</source>
        <translation>ihre Punktzahlen sind entlang einiger Achsen negativ, als wären einige Schritte in Ångström und andere in Bohr. Machen Sie alle positiv oder alle negativ.</translation>
    </message>
    <message>
        <source>It names 1 atom, which is not shown.</source>
        <translation>Sie nennt 1 Atom, das nicht gezeigt wird.</translation>
    </message>
    <message>
        <source>It names %1 atoms, which are not shown.</source>
        <translation>Sie nennt %1 Atome, die nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>its header requires %1 values at each point, and at most %2 are read. Write fewer orbitals into a file.</source>
        <translation>ihr Kopf verlangt %1 Werte an jedem Punkt, und höchstens %2 werden gelesen. Schreiben Sie weniger Orbitale in eine Datei.</translation>
    </message>
    <message>
        <source>It holds %1 values at each point; the others are not read.</source>
        <translation>Sie enthält %1 Werte an jedem Punkt; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>it is a table of colours for pictures, which has the same ending as Gaussian cubes. It holds no volume.</source>
        <translation>sie ist eine Farbtabelle für Bilder, die dieselbe Endung hat wie ein Gaussian-Cube. Sie enthält kein Volumen.</translation>
    </message>
    <message>
        <source>its values have no positions in it. Export a field with its positions, all in one file.</source>
        <translation>ihre Werte haben darin keine Positionen. Exportieren Sie ein Feld mit seinen Positionen, alles in einer Datei.</translation>
    </message>
    <message>
        <source>its positions are of the class &apos;%1&apos;, and only &apos;gridpositions&apos; are read, a regular grid. Resample the field on a regular grid, or export its points as a table or its cells as .vtu.</source>
        <translation>ihre Positionen sind von der Klasse „%1“, und nur „gridpositions“ werden gelesen, ein regelmäßiges Gitter. Tasten Sie das Feld auf einem regelmäßigen Gitter neu ab, oder exportieren Sie seine Punkte als Tabelle oder seine Zellen als .vtu.</translation>
    </message>
    <message>
        <source>the number of dimensions of its grid is %1, and a volume has three. Export a field of three.</source>
        <translation>die Zahl der Dimensionen ihres Gitters ist %1, und ein Volumen hat drei. Exportieren Sie ein Feld mit drei.</translation>
    </message>
    <message>
        <source>its &apos;gridpositions&apos; do not have one &apos;origin&apos; and three &apos;delta&apos; of three numbers each. Correct them.</source>
        <translation>ihre „gridpositions“ haben nicht ein „origin“ und drei „delta“ aus je drei Zahlen. Berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>its array has %1 items, and its grid %2 points. Correct the numbers, or export it again.</source>
        <translation>ihr Array hat %1 Elemente und ihr Gitter %2 Punkte. Berichtigen Sie die Zahlen, oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its values are of the type &apos;%1&apos;, which is not read. Export real numbers.</source>
        <translation>ihre Werte sind vom Typ „%1“, der nicht gelesen wird. Exportieren Sie reelle Zahlen.</translation>
    </message>
    <message>
        <source>its array does not state where its data are. Export it again.</source>
        <translation>ihr Array sagt nicht, wo seine Daten stehen. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it has no OpenDX field with data in it. Export one field with its positions and data, all in one file.</source>
        <translation>sie enthält kein OpenDX-Feld mit Daten. Exportieren Sie ein Feld mit seinen Positionen und Daten, alles in einer Datei.</translation>
    </message>
    <message>
        <source>It holds %1 fields; the others are not read.</source>
        <translation>Sie enthält %1 Felder; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>it is not understood as an OpenDX file: %1. Write it again as one field with regular positions.</source>
        <translation>sie ist nicht als OpenDX-Datei zu verstehen: %1. Schreiben Sie sie noch einmal, als ein Feld mit regelmäßigen Positionen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; after &apos;%2&apos; is not a whole number</source>
        <translation>„%1“ hinter „%2“ ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>no name follows &apos;data file&apos;</source>
        <translation>auf „data file“ folgt kein Name</translation>
    </message>
    <message>
        <source>&apos;%1&apos; after &apos;data&apos; is not a position</source>
        <translation>„%1“ hinter „data“ nennt keinen Ort</translation>
    </message>
    <message>
        <source>an array has rank %1, and its shape %2 numbers</source>
        <translation>ein Array hat den Rang %1 und seine Form (shape) %2 Zahlen</translation>
    </message>
    <message>
        <source>it has more than %1 objects</source>
        <translation>Sie hat mehr als %1 Objekte</translation>
    </message>
    <message>
        <source>an object has more than %1 words</source>
        <translation>ein Objekt hat mehr als %1 Wörter</translation>
    </message>
    <message>
        <source>an array of it should have %1 items, and the file ends before. It is cut short, or the number is wrong.</source>
        <translation>eines ihrer Arrays sollte %1 Elemente haben, und die Datei endet vorher. Sie ist abgeschnitten, oder die Zahl ist falsch.</translation>
    </message>
    <message>
        <source>&apos;--%1&apos; selects among several volumes or components, and &apos;%2&apos; has one number for each point. Leave it out.</source>
        <translation>„--%1“ wählt unter mehreren Volumen oder Komponenten, und „%2“ hat eine Zahl für jeden Punkt. Lassen Sie die Option weg.</translation>
    </message>
    <message>
        <source>NIfTI (*.nii *.hdr)</source>
        <translation>NIfTI (*.nii *.hdr)</translation>
    </message>
    <message>
        <source>MRC and CCP4 maps (*.mrc *.ccp4 *.map)</source>
        <translation>MRC- und CCP4-Karten (*.mrc *.ccp4 *.map)</translation>
    </message>
    <message>
        <source>its header names %1 files. Put the samples into fewer.</source>
        <translation>ihr Kopf nennt %1 Dateien. Verteilen Sie die Abtastwerte auf weniger.</translation>
    </message>
    <message>
        <source>its matrix turns space into its further axes. Write one volume of it.</source>
        <translation>ihre Matrix dreht den Raum in ihre weiteren Achsen. Schreiben Sie ein einzelnes Volumen daraus.</translation>
    </message>
    <message>
        <source>Its header gives the same quantity under two names, with different values: %1 was used, and %2 (%3) was not.</source>
        <translation>Ihr Kopf gibt dasselbe unter zwei Namen verschieden an: %1 wurde genommen, und %2 (%3) nicht.</translation>
    </message>
    <message>
        <source>it holds no image: its ObjectType is &apos;%1&apos;. TAn reads only images of this format.</source>
        <translation>sie enthält kein Bild: Ihr ObjectType ist „%1“. TAn liest von diesem Format nur Bilder.</translation>
    </message>
    <message>
        <source>it has %1 dimensions, and a volume has three. Write its pictures as one volume, or a part of it with three.</source>
        <translation>sie hat %1 Dimensionen, und ein Volumen hat drei. Schreiben Sie ihre Bilder als ein Volumen oder einen Teil davon mit drei Dimensionen.</translation>
    </message>
    <message>
        <source>Its header does not state the byte order of its numbers: that of this machine was assumed, %1 endian.</source>
        <translation>Ihr Kopf sagt nicht, in welcher Folge die Bytes einer Zahl stehen: Die dieses Rechners wurde genommen, %1 endian.</translation>
    </message>
    <message>
        <source>Its header states how intensities follow from samples (times %1, plus %2), which was not applied.</source>
        <translation>Ihr Kopf sagt, wie Intensitäten aus den Abtastwerten folgen (mal %1, plus %2); das wurde nicht angewandt.</translation>
    </message>
    <message>
        <source>Its CenterOfRotation was not used: a sample lies at Offset plus its directions times its distances, as in ITK.</source>
        <translation>Ihr CenterOfRotation wurde nicht benutzt: Ein Abtastwert liegt bei Offset plus ihren Richtungen mal ihren Abständen, wie in ITK.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and the header of a map alone has %2. It is cut short, or not a map: copy the file again.</source>
        <translation>sie hat %1 Bytes, und der Kopf einer Karte allein hat %2. Sie ist keine Karte oder abgeschnitten: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Its cell angles are %1, which no cell has; right angles were used.</source>
        <translation>Ihre Zellwinkel sind %1, die keine Zelle haben kann; rechte Winkel wurden genommen.</translation>
    </message>
    <message>
        <source>Its header states that its columns, rows and sections run along the axes %1, %2 and %3, which is impossible; x, y and z were used.</source>
        <translation>Nach ihrem Kopf laufen ihre Spalten, Zeilen und Schnitte entlang der Achsen %1, %2 und %3, was nicht sein kann; x, y und z wurden genommen.</translation>
    </message>
    <message>
        <source>Its ORIGIN is not a finite number and was not used.</source>
        <translation>Ihr ORIGIN ist keine endliche Zahl und wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>By its NXSTART, NYSTART and NZSTART (%1) the first sample would lie at %2; its ORIGIN was used.</source>
        <translation>Nach ihrem NXSTART, NYSTART und NZSTART (%1) läge der erste Abtastwert bei %2; ihr ORIGIN wurde genommen.</translation>
    </message>
    <message>
        <source>IMOD wrote it without the flag that its ORIGIN has the usual sign: the first sample may lie at the negative of it.</source>
        <translation>IMOD hat sie ohne das Kennzeichen geschrieben, dass ihr ORIGIN das übliche Vorzeichen hat: Der erste Abtastwert liegt vielleicht beim Negativen davon.</translation>
    </message>
    <message>
        <source>Its header has a matrix that turns the map (LSKFLG), which was not used.</source>
        <translation>Ihr Kopf hat eine Matrix, die die Karte dreht (LSKFLG); sie wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>Its bytes were read as unsigned, from 0 to 255, as IMOD&apos;s flag states.</source>
        <translation>Ihre Bytes wurden ohne Vorzeichen genommen, von 0 bis 255, wie das Kennzeichen von IMOD es sagt.</translation>
    </message>
    <message>
        <source>Its bytes were read as unsigned, from 0 to 255, because its header states that the largest value is %1.</source>
        <translation>Ihre Bytes wurden ohne Vorzeichen genommen, von 0 bis 255, weil nach ihrem Kopf der größte Wert %1 ist.</translation>
    </message>
    <message>
        <source>its samples have four bits each (mode 101), which is not read. Write it with bytes (mode 0), for instance with IMOD&apos;s &apos;newstack -mode 0&apos;.</source>
        <translation>ihre Abtastwerte haben je vier Bit (Modus 101), was nicht gelesen wird. Schreiben Sie sie mit Bytes (Modus 0), etwa mit „newstack -mode 0“ von IMOD.</translation>
    </message>
    <message>
        <source>its samples are of mode %1, which is not read. Write it with mode 2 (floating point).</source>
        <translation>ihre Abtastwerte sind vom Modus %1, der nicht gelesen wird. Schreiben Sie sie im Modus 2 (Gleitkommazahlen).</translation>
    </message>
    <message>
        <source>Its samples are complex numbers (mode %1), as of a Fourier transform: their places are not those of a body.</source>
        <translation>Ihre Abtastwerte sind komplexe Zahlen (Modus %1), wie die einer Fouriertransformierten: Ihre Orte sind nicht die eines Körpers.</translation>
    </message>
    <message>
        <source>The machine stamp of its header does not state the byte order: the one in which its numbers are plausible was used, %1 endian.</source>
        <translation>Die Maschinenkennung in ihrem Kopf sagt nicht, in welcher Folge ihre Bytes stehen: Die, in der ihre Zahlen einen Sinn ergeben, wurde genommen, %1 endian.</translation>
    </message>
    <message>
        <source>Its header states that it is a stack of %1 pictures and not a volume (space group 0, MZ 1); it was read as a volume.</source>
        <translation>Nach ihrem Kopf ist sie ein Stapel aus %1 Bildern und kein Volumen (Raumgruppe 0, MZ 1); sie wurde als Volumen gelesen.</translation>
    </message>
    <message>
        <source>its header claims %1 x %2 x %3 points, after an extension of %4 bytes. It is damaged, or not a map: copy or export it again.</source>
        <translation>nach ihrem Kopf hat sie %1 x %2 x %3 Punkte, hinter einer Erweiterung von %4 Bytes. Sie ist beschädigt oder keine Karte: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it does not begin like a header of NIfTI or Analyze 7.5. It is of another format, or damaged.</source>
        <translation>sie beginnt nicht wie die Köpfe von NIfTI und Analyze 7.5. Sie hat ein anderes Format oder ist beschädigt.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and a header of NIfTI has %2. It is cut short, or of another format: copy the file again.</source>
        <translation>sie hat %1 Bytes, und ein Kopf von NIfTI hat %2. Sie ist abgeschnitten oder hat ein anderes Format: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>of the scanner</source>
        <translation>des Scanners</translation>
    </message>
    <message>
        <source>aligned to another scan</source>
        <translation>an eine andere Aufnahme angepasst</translation>
    </message>
    <message>
        <source>of Talairach</source>
        <translation>von Talairach</translation>
    </message>
    <message>
        <source>of MNI 152</source>
        <translation>von MNI 152</translation>
    </message>
    <message>
        <source>of a template</source>
        <translation>einer Vorlage</translation>
    </message>
    <message>
        <source>Its qform would place it elsewhere, mirrored and up to %1 away; it was not used.</source>
        <translation>Ihre qform legte sie an einen anderen Ort, gespiegelt und bis zu %1 entfernt; sie wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>Its qform would place it elsewhere, up to %1 away; it was not used.</source>
        <translation>Ihre qform legte sie an einen anderen Ort, bis zu %1 entfernt; sie wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>Its pixdim states that samples are %1 x %2 x %3 apart, which was not used.</source>
        <translation>Nach ihrem pixdim haben die Abtastwerte die Abstände %1 x %2 x %3; das wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>distances alone (pixdim)</source>
        <translation>nur Abstände (pixdim)</translation>
    </message>
    <message>
        <source>Its header states neither where it lies nor which side of it is the left one: it has no sform and no qform.</source>
        <translation>Ihr Kopf sagt weder, wo sie liegt, noch welche ihrer Seiten die linke ist: Sie hat keine sform und keine qform.</translation>
    </message>
    <message>
        <source>distances, and the origin as SPM writes it</source>
        <translation>Abstände, und der Ursprung, wie SPM ihn schreibt</translation>
    </message>
    <message>
        <source>Its header, of Analyze 7.5, does not state which side of it is the left one. Convert it to NIfTI with a program that knows where it comes from.</source>
        <translation>Ihr Kopf, von Analyze 7.5, sagt nicht, welche ihrer Seiten die linke ist. Wandeln Sie sie mit einem Programm in NIfTI um, das weiß, woher sie kommt.</translation>
    </message>
    <message>
        <source>Its code for the orientation, %1, was not used.</source>
        <translation>Ihr Code für die Ausrichtung, %1, wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>Its sform is unusable (its steps lie in a plane, or are not finite numbers); it was not used.</source>
        <translation>Ihre sform führt nirgendwohin (ihre Schritte liegen in einer Ebene oder sind keine endlichen Zahlen); sie wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>Its qform is unusable (its numbers are not finite, or too large or small); it was not used.</source>
        <translation>Ihre qform führt nirgendwohin (ihre Zahlen sind nicht endlich oder zu groß oder zu klein); sie wurde nicht benutzt.</translation>
    </message>
    <message>
        <source>sform, coordinates %1</source>
        <translation>sform, Koordinaten %1</translation>
    </message>
    <message>
        <source>qform, coordinates %1</source>
        <translation>qform, Koordinaten %1</translation>
    </message>
    <message>
        <source>its samples are floating-point numbers of 128 bits, which are not read: their layout differs from machine to machine. Write them with 64 bits.</source>
        <translation>ihre Abtastwerte sind Gleitkommazahlen mit 128 Bit, die nicht gelesen werden: Was sie bedeuten, ist von Rechner zu Rechner verschieden. Schreiben Sie sie mit 64 Bit.</translation>
    </message>
    <message>
        <source>its samples are single bits, which are not read. Write them as bytes.</source>
        <translation>ihre Abtastwerte sind einzelne Bits, die nicht gelesen werden. Schreiben Sie sie als Bytes.</translation>
    </message>
    <message>
        <source>its samples are of the type %1, which NIfTI does not define. The file is damaged: copy or export it again.</source>
        <translation>ihre Abtastwerte sind vom Typ %1, den NIfTI nicht kennt. Die Datei ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its header claims %1 dimensions. It is damaged: copy or export it again.</source>
        <translation>nach ihrem Kopf hat sie %1 Dimensionen. Sie ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its header claims %1 points along its dimension %2. It is damaged: copy or export it again.</source>
        <translation>nach ihrem Kopf hat sie %1 Punkte entlang ihrer Dimension %2. Sie ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>It holds %1 times as many samples along its last dimensions; the first were read.</source>
        <translation>Sie enthält %1-mal so viele Abtastwerte entlang ihrer letzten Dimensionen; die ersten wurden gelesen.</translation>
    </message>
    <message>
        <source>The samples were multiplied by %1, which SPM stores in the header&apos;s first unused field.</source>
        <translation>Die Abtastwerte wurden mit %1 multipliziert, wie SPM es mit dem ersten unbenutzten Feld des Kopfes meint.</translation>
    </message>
    <message>
        <source>The samples were multiplied by %1, and %2 was added, as the header of the file requires.</source>
        <translation>Die Abtastwerte wurden mit %1 multipliziert, und %2 wurde addiert, wie der Kopf der Datei es verlangt.</translation>
    </message>
    <message>
        <source>its header states that its samples begin at byte %1, which is impossible. It is damaged: copy or export it again.</source>
        <translation>nach ihrem Kopf beginnen ihre Abtastwerte bei Byte %1, wo sie nicht stehen können. Sie ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its samples are in a file &apos;%1&apos;, which is missing. Copy it into the same folder: the two belong together.</source>
        <translation>ihre Abtastwerte stehen in einer Datei „%1“, die fehlt. Kopieren Sie sie in den Ordner dieser Datei: Die beiden gehören zusammen.</translation>
    </message>
    <message>
        <source>its header is not that of a NumPy array: %1. Save the array again with numpy.save().</source>
        <translation>ihr Kopf ist nicht der eines NumPy-Arrays: %1. Speichern Sie das Array noch einmal mit numpy.save().</translation>
    </message>
    <message>
        <source>it has no dictionary</source>
        <translation>das Dictionary fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood</source>
        <translation>„%1“ ist nicht zu verstehen</translation>
    </message>
    <message>
        <source>&apos;descr&apos;, &apos;fortran_order&apos; or &apos;shape&apos; is missing</source>
        <translation>„descr“, „fortran_order“ oder „shape“ fehlt</translation>
    </message>
    <message>
        <source>its first bytes are different</source>
        <translation>die ersten Bytes sind andere</translation>
    </message>
    <message>
        <source>it has version %1 of NumPy&apos;s format, and versions 1 to 3 are read. Save it again with numpy.save() of an earlier NumPy.</source>
        <translation>sie hat Version %1 des NumPy-Formats, und gelesen werden die Versionen 1 bis 3. Speichern Sie sie noch einmal mit numpy.save() eines früheren NumPy.</translation>
    </message>
    <message>
        <source>it is cut short</source>
        <translation>das Ende fehlt</translation>
    </message>
    <message>
        <source>its elements are records of several fields. Save one field on its own: numpy.save(name, array[&apos;field&apos;]).</source>
        <translation>ihre Elemente sind Datensätze aus mehreren Feldern. Speichern Sie ein Feld für sich: numpy.save(name, array[&apos;field&apos;]).</translation>
    </message>
    <message>
        <source>its elements are Python objects, which only Python can read. Save an array of numbers: array.astype(&apos;float32&apos;).</source>
        <translation>ihre Elemente sind Python-Objekte, die nur Python lesen kann. Speichern Sie ein Array aus Zahlen: array.astype(&apos;float32&apos;).</translation>
    </message>
    <message>
        <source>its elements have the type &apos;%1&apos;, which is not read. Save numbers of a usual type: array.astype(&apos;float64&apos;).</source>
        <translation>ihre Elemente haben den Typ „%1“, der nicht gelesen wird. Speichern Sie Zahlen eines üblichen Typs: array.astype(&apos;float64&apos;).</translation>
    </message>
    <message>
        <source>its array has the shape (%1), and a volume needs three dimensions of more than one element. Save a part that has them, such as array[0] or array[..., 0].</source>
        <translation>ihr Array hat die Form (%1), und ein Volumen braucht drei Dimensionen mit mehr als einem Element. Speichern Sie einen Teil, der sie hat, etwa array[0] oder array[..., 0].</translation>
    </message>
    <message>
        <source>axes z, y, x: the last one runs fastest</source>
        <translation>Achsen z, y, x: Die letzte läuft am schnellsten</translation>
    </message>
    <message>
        <source>space directions</source>
        <translation>space directions</translation>
    </message>
    <message>
        <source>Its samples stand for numbers from %1 to %2 (&apos;old min&apos;, &apos;old max&apos;), from which they were quantized; they are used as stored.</source>
        <translation>Ihre Abtastwerte stehen für Zahlen von %1 bis %2 („old min“, „old max“), aus denen sie quantisiert wurden; sie werden genommen, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>Its spacings and the ends of its axes are not used: its space directions state where it lies.</source>
        <translation>Ihre Abstände und die Enden ihrer Achsen werden nicht benutzt: Ihre space directions sagen, wo sie liegt.</translation>
    </message>
    <message>
        <source>its samples are of a type that has 4 bytes by the format, and there are %1 bytes for %2 samples: as many as for a type of 8 bytes. Write them as MET_INT or MET_LONG_LONG.</source>
        <translation>ihre Abtastwerte sind von einem Typ, der nach dem Format 4 Bytes hat, und für %2 Abtastwerte gibt es %1 Bytes: so viele wie bei einem Typ von 8 Bytes. Schreiben Sie sie als MET_INT oder MET_LONG_LONG.</translation>
    </message>
    <message>
        <source>%1 bytes after its samples were not read.</source>
        <translation>%1 Bytes hinter ihren Abtastwerten wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>its header requires more samples than any file holds. It is damaged: copy or export it again.</source>
        <translation>ihr Kopf verlangt mehr Abtastwerte, als irgendeine Datei enthält. Sie ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it has one time step, and number %1 was requested. Leave &apos;--time&apos; out.</source>
        <translation>sie hat einen Zeitschritt, und verlangt war Nummer %1. Lassen Sie „--time“ weg.</translation>
    </message>
    <message>
        <source>it has %1 time steps, and number %2 was requested. Give one from 1 to %1.</source>
        <translation>sie hat %1 Zeitschritte, und verlangt ist Nummer %2. Geben Sie einen von 1 bis %1 an.</translation>
    </message>
    <message>
        <source>%1 of %2, time %3</source>
        <translation>%1 von %2, Zeit %3</translation>
    </message>
    <message>
        <source>It holds %1 volumes; the others are not read.</source>
        <translation>Sie enthält %1 Volumen; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>it has one number for each sample, and component &apos;%1&apos; was requested. Leave &apos;--component&apos; out.</source>
        <translation>sie hat eine Zahl je Abtastwert, und verlangt ist Komponente „%1“. Lassen Sie „--component“ weg.</translation>
    </message>
    <message>
        <source>it has no component &apos;%1&apos;. Choose one from 0 to %2, or &apos;magnitude&apos;.</source>
        <translation>sie hat keine Komponente „%1“. Wählen Sie eine von 0 bis %2, oder „magnitude“.</translation>
    </message>
    <message>
        <source>magnitude of %1</source>
        <translation>Betrag von %1</translation>
    </message>
    <message>
        <source>%1 of %2, counted from 0</source>
        <translation>%1 von %2, ab 0 gezählt</translation>
    </message>
    <message>
        <source>Each sample has %1 components; the others are not read.</source>
        <translation>Jeder Abtastwert hat %1 Komponenten; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>%1 ...</source>
        <translation>%1 ...</translation>
    </message>
    <message>
        <source>Files with several sets of values (Gaussian cube, OpenDX): one of them, by name or by number from 1; by default the first.</source>
        <translation>Dateien mit mehreren Sätzen von Werten (Gaussian-Cube, OpenDX): einer, nach Name oder Nummer ab 1; ohne Angabe der erste.</translation>
    </message>
    <message>
        <source>it has only one array, and not &apos;%1&apos;. Leave &apos;--array&apos; out.</source>
        <translation>sie hat kein Feld „%1“, sondern nur ein einziges. Lassen Sie „--array“ weg.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. It has %2: %3.</source>
        <translation>sie hat kein Feld „%1“. Sie hat %2: %3.</translation>
    </message>
    <message>
        <source>%1, number %2 of %3</source>
        <translation>%1, Nummer %2 von %3</translation>
    </message>
    <message>
        <source>%1 of %2, from 0</source>
        <translation>%1 von %2, ab 0</translation>
    </message>
    <message>
        <source>NumPy array (*.npy)</source>
        <translation>NumPy-Array (*.npy)</translation>
    </message>
    <message>
        <source>Gaussian cube (*.cube *.cub)</source>
        <translation>Gaussian-Cube (*.cube *.cub)</translation>
    </message>
    <message>
        <source>OpenDX (*.dx)</source>
        <translation>OpenDX (*.dx)</translation>
    </message>
    <message>
        <source>Brick of values (*.bov)</source>
        <translation>Quader von Werten (*.bov)</translation>
    </message>
    <message>
        <source>Install Python and meshio with &apos;apt install python3-meshio&apos;, or write the mesh as .vtu.</source>
        <translation>Installieren Sie Python und meshio mit „apt install python3-meshio“, oder schreiben Sie das Netz als .vtu.</translation>
    </message>
    <message>
        <source>Install Python and meshio with &apos;apt install python3-meshio&apos;.</source>
        <translation>Installieren Sie Python und meshio mit „apt install python3-meshio“.</translation>
    </message>
    <message>
        <source>Export it again, as .vtu if the program can.</source>
        <translation>Exportieren Sie sie noch einmal, als .vtu, wenn das Programm es kann.</translation>
    </message>
    <message>
        <source>its format is not one that TAn leaves to meshio. Let TAn choose the reader.</source>
        <translation>sie hat kein Format, das TAn meshio überlässt. Lassen Sie TAn den Leser wählen.</translation>
    </message>
    <message>
        <source>Gmsh mesh (*.msh)</source>
        <translation>Gmsh-Netz (*.msh)</translation>
    </message>
    <message>
        <source>MED mesh (*.med)</source>
        <translation>MED-Netz (*.med)</translation>
    </message>
    <message>
        <source>XDMF mesh (*.xdmf *.xmf)</source>
        <translation>XDMF-Netz (*.xdmf *.xmf)</translation>
    </message>
    <message>
        <source>Nastran mesh (*.bdf *.nas *.fem)</source>
        <translation>Nastran-Netz (*.bdf *.nas *.fem)</translation>
    </message>
    <message>
        <source>Abaqus mesh (*.inp)</source>
        <translation>Abaqus-Netz (*.inp)</translation>
    </message>
    <message>
        <source>Medit mesh (*.mesh *.meshb)</source>
        <translation>Medit-Netz (*.mesh *.meshb)</translation>
    </message>
    <message>
        <source>it refers to the file &apos;%1&apos;, which is not in its folder. Put the files into one folder.</source>
        <translation>sie nennt die Datei „%1“, die nicht in ihrem Ordner liegt. Verschieben Sie die Dateien gemeinsam.</translation>
    </message>
    <message>
        <source>it holds a mesh, and no values at its points or cells. Export the results with the mesh, as .vtu if the program can.</source>
        <translation>sie enthält ein Netz, aber keine Werte an dessen Punkten oder Zellen. Exportieren Sie die Ergebnisse mit dem Netz, als .vtu, wenn das Programm es kann.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has the components 0 to %2, and no component %3.</source>
        <translation>ihr Feld „%1“ hat die Komponenten 0 bis %2 und keine Komponente %3.</translation>
    </message>
    <message>
        <source>one of its cells has a corner that is not one of its %1 points. It is damaged.</source>
        <translation>eine ihrer Zellen hat eine Ecke, die keiner ihrer %1 Punkte ist. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>its points lie in a plane. A three-dimensional mesh is needed.</source>
        <translation>ihre Punkte liegen in einer Ebene. Gebraucht wird ein Netz mit drei Dimensionen.</translation>
    </message>
    <message>
        <source>%1 cells of the kind &apos;%2&apos; were left out: TAn does not support them.</source>
        <translation>%1 Zellen der Art „%2“ wurden weggelassen: Solche kennt TAn nicht.</translation>
    </message>
    <message>
        <source>meshio, which reads such files, is not installed. Install it with &apos;apt install python3-meshio&apos; (other systems: &apos;pip install meshio&apos;), or write the mesh as .vtu.</source>
        <translation>meshio, das solche Dateien liest, ist nicht installiert. Installieren Sie es mit „apt install python3-meshio“ (andere Systeme: „pip install meshio“), oder schreiben Sie das Netz als .vtu.</translation>
    </message>
    <message>
        <source>meshio needs the Python module &apos;%1&apos; for it. Install it with &apos;apt install python3-%1&apos;, or write the mesh as .vtu.</source>
        <translation>meshio braucht dafür das Python-Modul „%1“. Installieren Sie es mit „apt install python3-%1“, oder schreiben Sie das Netz als .vtu.</translation>
    </message>
    <message>
        <source>the system says: %1. Check that the file and those that it refers to can be read.</source>
        <translation>das System meldet: %1. Sorgen Sie dafür, dass die Datei und die, die sie nennt, gelesen werden können.</translation>
    </message>
    <message>
        <source>meshio does not understand it (%1). Open it in the program that wrote it, and export it again, as .vtu if the program can.</source>
        <translation>meshio versteht sie nicht (%1). Öffnen Sie sie in dem Programm, das sie geschrieben hat, und exportieren Sie sie noch einmal, als .vtu, wenn das Programm es kann.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;index&apos; is not understood. Give the name of each dimension with a number from 1, as in member=3,type=1.</source>
        <translation>„%1“ für „index“ ist nicht zu verstehen. Geben Sie den Namen jeder Dimension mit einer Nummer ab 1 an, wie in member=3,type=1.</translation>
    </message>
    <message>
        <source>its list &apos;%1&apos; is missing or shorter than its elements require. It is damaged: export it again.</source>
        <translation>ihre Liste „%1“ fehlt oder ist kürzer, als ihre Elemente verlangen. Sie ist beschädigt: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its list &apos;%1&apos; contains number %2, and there are %3. It is damaged: export it again.</source>
        <translation>ihre Liste „%1“ nennt Nummer %2, und es gibt %3. Sie ist beschädigt: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; does not have %2 values at time step %3. It is damaged or was not written completely: export it again.</source>
        <translation>ihre Variable „%1“ hat zum Zeitschritt %3 nicht %2 Werte. Sie ist beschädigt oder wurde nicht zu Ende geschrieben: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it has no coordinates of its nodes (&apos;%1&apos;). Write it with a mesh.</source>
        <translation>sie hat keine Koordinaten ihrer Knoten („%1“). Schreiben Sie sie mit einem Netz.</translation>
    </message>
    <message>
        <source>its coordinates &apos;%1&apos; are not those of %2 nodes. It is damaged: export it again.</source>
        <translation>ihre Koordinaten „%1“ sind nicht die von %2 Knoten. Sie ist beschädigt: Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it lists a variable number %1 at its nodes but has no values of it. Export it again.</source>
        <translation>sie nennt eine Variable Nummer %1 an ihren Knoten und hat keine Werte davon. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>it has no part &apos;%1&apos;. Available: %2.</source>
        <translation>sie hat keinen Teil „%1“. Es gibt: %2.</translation>
    </message>
    <message>
        <source>it has no elements. Write it with a mesh.</source>
        <translation>sie hat keine Elemente. Schreiben Sie sie mit einem Netz.</translation>
    </message>
    <message>
        <source>its elements are of a shape that TAn does not support: %1. Divide them into simpler ones.</source>
        <translation>ihre Elemente haben eine Form, die TAn nicht kennt: %1. Zerlegen Sie sie in einfachere.</translation>
    </message>
    <message>
        <source>it is a mesh without results: no variables of nodes or elements. Open the file that the solver wrote, or write it with values.</source>
        <translation>sie ist ein Netz ohne Ergebnisse: Variablen an Knoten oder Elementen fehlen. Öffnen Sie die Datei, die der Löser geschrieben hat, oder schreiben Sie sie mit Werten.</translation>
    </message>
    <message>
        <source>it has no variables of nodes or elements. Write it with one.</source>
        <translation>sie hat keine Variablen an Knoten oder Elementen. Schreiben Sie sie mit einer.</translation>
    </message>
    <message>
        <source>moved by &apos;%1&apos;</source>
        <translation>verschoben um „%1“</translation>
    </message>
    <message>
        <source>It has displacements (&apos;%1&apos;); its nodes are not moved by them. &apos;displace&apos; moves them.</source>
        <translation>Sie hat Verschiebungen („%1“); ihre Knoten bleiben, wo sie vorher waren. „displace“ verschiebt sie.</translation>
    </message>
    <message>
        <source>1 of its blocks has lines or surfaces and is left out.</source>
        <translation>1 ihrer Blöcke hat Linien oder Flächen und wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 of its blocks have lines or surfaces and are left out.</source>
        <translation>%1 ihrer Blöcke haben Linien oder Flächen und werden weggelassen.</translation>
    </message>
    <message>
        <source>%1 of its blocks have elements of a shape that TAn does not support (&apos;%2&apos;) and are left out.</source>
        <translation>%1 ihrer Blöcke haben Elemente einer Form, die TAn nicht kennt („%2“), und werden weggelassen.</translation>
    </message>
    <message>
        <source>it has no displacements, whose names begin with &apos;disp&apos;. Leave &apos;displace&apos; out.</source>
        <translation>sie hat keine Verschiebungen, deren Namen mit „disp“ beginnen. Lassen Sie „displace“ weg.</translation>
    </message>
    <message>
        <source>%1 elements have nodes beyond those of linear and quadratic shapes, which were left out.</source>
        <translation>%1 Elemente haben außer den Knoten linearer und quadratischer Formen weitere, die weggelassen wurden.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has values for its surfaces, not its points. Choose an array of points.</source>
        <translation>ihr Feld „%1“ hat Werte für ihre Flächen, nicht für ihre Punkte. Wählen Sie ein Feld von Punkten.</translation>
    </message>
    <message>
        <source>none of the blocks that are taken has &apos;%1&apos;. Choose another array or part.</source>
        <translation>keiner der Blöcke, die genommen werden, hat „%1“. Wählen Sie ein anderes Feld oder einen anderen Teil.</translation>
    </message>
    <message>
        <source>1 of its blocks has no &apos;%1&apos; and was left out.</source>
        <translation>1 ihrer Blöcke hat kein „%1“ und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 of its blocks have no &apos;%2&apos; and were left out.</source>
        <translation>%1 ihrer Blöcke haben kein „%2“ und wurden weggelassen.</translation>
    </message>
    <message>
        <source>it has no variable &apos;%1&apos; with three dimensions of space. Choose one of these: %2.</source>
        <translation>sie hat keine Variable „%1“ mit drei Dimensionen im Raum. Wählen Sie eine von diesen: %2.</translation>
    </message>
    <message>
        <source>it is a mesh that follows the conventions %1, which are not read. Convert it to .vtu, for instance with ParaView.</source>
        <translation>sie ist ein Netz nach den Konventionen %1, die nicht gelesen werden. Wandeln Sie sie in .vtu um, etwa mit ParaView.</translation>
    </message>
    <message>
        <source>it holds no variables other than coordinates. Write it with values.</source>
        <translation>sie enthält keine Variablen außer Koordinaten. Schreiben Sie sie mit Werten.</translation>
    </message>
    <message>
        <source>none of its variables has numbers along three dimensions of space with two points or more: %1. TAn takes volumes: choose a file of several levels, or join files along one.</source>
        <translation>keine ihrer Variablen hat Zahlen entlang dreier Dimensionen im Raum mit je zwei oder mehr Punkten: %1. TAn nimmt Volumen: Wählen Sie eine Datei mit mehreren Schichten, oder fügen Sie Dateien entlang einer Dimension zusammen.</translation>
    </message>
    <message>
        <source>its variable %1 does not extend along three dimensions of space with two points or more. Choose one that does.</source>
        <translation>ihre Variable %1 erstreckt sich nicht entlang dreier Dimensionen im Raum mit je zwei oder mehr Punkten. Wählen Sie eine, die das tut.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; is of the type %2, which is not a number. Choose another one.</source>
        <translation>ihre Variable „%1“ ist vom Typ %2, der keine Zahl ist. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>it has no time step: nothing was written along its dimension &apos;%1&apos;.</source>
        <translation>sie hat keinen Zeitschritt: Entlang ihrer Dimension „%1“ wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>it has %1 numbers along &apos;%2&apos;, and %3 was requested with &apos;index&apos;.</source>
        <translation>sie hat %1 Nummern entlang „%2“, und mit „index“ wird %3 verlangt.</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 von %3</translation>
    </message>
    <message>
        <source>its variable %1 has no further dimension &apos;%2&apos;, which was requested with &apos;index&apos;.</source>
        <translation>ihre Variable %1 hat keine weitere Dimension „%2“, die mit „index“ verlangt wird.</translation>
    </message>
    <message>
        <source>%1, time %2</source>
        <translation>%1, Zeit %2</translation>
    </message>
    <message>
        <source>%1, time %2 (%3)</source>
        <translation>%1, Zeit %2 (%3)</translation>
    </message>
    <message>
        <source>%1, with which the NetCDF library fills what was never written</source>
        <translation>%1, womit die NetCDF-Bibliothek füllt, was niemand geschrieben hat</translation>
    </message>
    <message>
        <source>the NetCDF library says of %1: %2. Copy or export the file again.</source>
        <translation>die NetCDF-Bibliothek meldet zu %1: %2. Kopieren oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos;</source>
        <translation>ihrer Variablen „%1“</translation>
    </message>
    <message>
        <source>it does not begin like a NetCDF file. It is of another format, or damaged.</source>
        <translation>sie beginnt nicht wie eine NetCDF-Datei. Sie hat ein anderes Format oder ist beschädigt.</translation>
    </message>
    <message>
        <source>the NetCDF library cannot open it: %1. Copy or export it again.</source>
        <translation>die NetCDF-Bibliothek kann sie nicht öffnen: %1. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its variables</source>
        <translation>ihren Variablen</translation>
    </message>
    <message>
        <source>its groups</source>
        <translation>ihren Gruppen</translation>
    </message>
    <message>
        <source>its dimensions</source>
        <translation>ihren Dimensionen</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; has a dimension that none of its enclosing groups has. It is damaged: copy or export it again.</source>
        <translation>ihre Variable „%1“ hat eine Dimension, die keine Gruppe um sie herum hat. Sie ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Its longitudes &apos;%1&apos; start again within it: they were continued in full turns of 360 degrees.</source>
        <translation>Ihre Längengrade „%1“ beginnen zwischendrin von vorn: Sie wurden um ganze Umdrehungen von 360 Grad fortgesetzt.</translation>
    </message>
    <message>
        <source>numbers of &apos;%1&apos;</source>
        <translation>Nummern von „%1“</translation>
    </message>
    <message>
        <source>Its coordinate &apos;%1&apos; counts downwards; it is used as z unchanged, so that up is where z decreases.</source>
        <translation>Ihre Koordinate „%1“ zählt nach unten; sie ist z, wie sie ist, sodass oben ist, wo z kleiner wird.</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>It states which map projection its coordinates belong to (&apos;%1&apos;), which is not used.</source>
        <translation>Sie sagt, zu welcher Kartenprojektion ihre Koordinaten gehören („%1“); das wird nicht benutzt.</translation>
    </message>
    <message>
        <source>all beyond %1 to %2</source>
        <translation>alle außerhalb von %1 bis %2</translation>
    </message>
    <message>
        <source>all below %1</source>
        <translation>alle unter %1</translation>
    </message>
    <message>
        <source>all above %1</source>
        <translation>alle über %1</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Nummern</translation>
    </message>
    <message>
        <source>%1, %2, height (PH + PHB) / 9.81 in m</source>
        <translation>%1, %2, Höhe (PH + PHB) / 9.81 in m</translation>
    </message>
    <message>
        <source>Exodus variables with several components: the number of one, from 0, or &apos;magnitude&apos;.</source>
        <translation>Bei Exodus-Variablen mit mehreren Komponenten: die Nummer einer, ab 0, oder „magnitude“ für den Betrag.</translation>
    </message>
    <message>
        <source>Further dimensions</source>
        <translation>Weitere Dimensionen</translation>
    </message>
    <message>
        <source>Variables with more dimensions than space and time: the number along each, from 1, as in member=3; by default the first.</source>
        <translation>Bei Variablen mit mehr Dimensionen als Raum und Zeit: die Nummer entlang jeder, ab 1, wie in member=3; sonst wird die erste genommen.</translation>
    </message>
    <message>
        <source>Exodus files: one element block, by its name, its number from 1 or its id; by default all that have the values.</source>
        <translation>Bei Exodus-Dateien: ein Elementblock, nach seinem Namen, seiner Nummer ab 1 oder seiner ID; ohne Angabe alle, die die Werte haben.</translation>
    </message>
    <message>
        <source>Displace</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Exodus files with displacements: moves the nodes by them.</source>
        <translation>Bei Exodus-Dateien mit Verschiebungen: verschiebt die Knoten um diese.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libnetcdf-dev&apos;), or convert the file to NRRD or VTU.</source>
        <translation>Installieren Sie das Paket tan-vtk-readers, das mit TAn kommt: „apt install ./tan-vtk-readers_*.deb“, wo die Datei liegt (bei einem selbst gebauten TAn: Bauen Sie es nach „apt install libnetcdf-dev“ neu), oder wandeln Sie die Datei in NRRD oder VTU um.</translation>
    </message>
    <message>
        <source>Install the NetCDF library with &apos;apt install libnetcdf19&apos; (other systems: netcdf-c).</source>
        <translation>Installieren Sie die NetCDF-Bibliothek mit „apt install libnetcdf19“ (andere Systeme: netcdf-c).</translation>
    </message>
    <message>
        <source>Copy or export it again; &apos;ncdump -h&apos; shows its content.</source>
        <translation>Kopieren oder exportieren Sie sie noch einmal; „ncdump -h“ zeigt, was darin ist.</translation>
    </message>
    <message>
        <source>NetCDF (*.nc *.nc4 *.netcdf *.cdf *.ncdf)</source>
        <translation>NetCDF (*.nc *.nc4 *.netcdf *.cdf *.ncdf)</translation>
    </message>
    <message>
        <source>The solution states: Mach number %1, angle of attack %2, Reynolds number %3, time %4. They are not used.</source>
        <translation>Die Lösung nennt: Mach-Zahl %1, Anstellwinkel %2, Reynolds-Zahl %3, Zeit %4. Das wird nicht benutzt.</translation>
    </message>
    <message>
        <source>all %1 grids</source>
        <translation>alle %1 Gitter</translation>
    </message>
    <message>
        <source>grid %1 of %2</source>
        <translation>Gitter %1 von %2</translation>
    </message>
    <message>
        <source>It holds %1 grids; the others are not read.</source>
        <translation>Sie enthält %1 Gitter; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>its %1 grids do not make a mesh together. %2 Alternatively choose one of them: &apos;grid&apos; from 1 to %3.</source>
        <translation>ihre %1 Gitter ergeben zusammen kein Netz. %2 Oder wählen Sie eines davon: „grid“ von 1 bis %3.</translation>
    </message>
    <message>
        <source>Which grid of a PLOT3D file with several, from 1; 0 joins all into one mesh.</source>
        <translation>Welches Gitter einer PLOT3D-Datei, die mehrere enthält, ab 1; 0 verbindet alle zu einem Netz.</translation>
    </message>
    <message>
        <source>it has numbers in %1 of its columns, and points need at least four: x, y, z and a value.</source>
        <translation>sie hat Zahlen in %1 ihrer Spalten, und Punkte brauchen mindestens vier: x, y, z und einen Wert.</translation>
    </message>
    <message>
        <source>which of its columns are x, y and z? It has %1. Name three of them with &apos;--positions&apos;, or in Import Options, as in --positions %2.</source>
        <translation>welche ihrer Spalten sind x, y und z? Sie hat %1. Nennen Sie drei davon mit „--positions“ oder unter Importoptionen, wie in --positions %2.</translation>
    </message>
    <message>
        <source>The points of its %1 parts were put together.</source>
        <translation>Die Punkte ihrer %1 Teile wurden zusammengefügt.</translation>
    </message>
    <message>
        <source>Tables of points: the columns of x, y and z, by name or number, as in a,b,c or 1,2,3; &apos;automatic&apos; finds them by their names, or takes the first three if there are no names.</source>
        <translation>Tabellen von Punkten: die Spalten von x, y und z, nach Name oder Nummer, wie in a,b,c oder 1,2,3; „automatic“ findet sie an ihren Namen; gibt es keine Namen, nimmt es die ersten drei.</translation>
    </message>
    <message>
        <source>Its section &apos;%1&apos; is not read.</source>
        <translation>Ihr Abschnitt „%1“ wird nicht gelesen.</translation>
    </message>
    <message>
        <source>Its coordinates are in different units (%1, %2, %3) and are used as they are.</source>
        <translation>Ihre Koordinaten haben verschiedene Einheiten (%1, %2, %3) und werden genommen, wie sie dastehen.</translation>
    </message>
    <message>
        <source>Its depths (&apos;%1&apos;) are used for z as they are: if they are positive, the data are upside down.</source>
        <translation>Ihre Tiefen („%1“) werden als z genommen, wie sie dastehen: Sind sie positiv, so stehen die Daten auf dem Kopf.</translation>
    </message>
    <message>
        <source>it has no section &apos;[Data]&apos;, and so no points.</source>
        <translation>sie hat keinen Abschnitt „[Data]“ und deshalb keine Punkte.</translation>
    </message>
    <message>
        <source>line %1 announces %2 points, and there are more.</source>
        <translation>Zeile %1 sagt, dass %2 Punkte folgen, und es sind mehr.</translation>
    </message>
    <message>
        <source>line %1 announces %2 points, and there are %3. The copy may be incomplete: copy the file again.</source>
        <translation>Zeile %1 sagt, dass %2 Punkte folgen, und es sind %3. Vielleicht ist die Kopie unvollständig: Kopieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Its array &apos;%1&apos; has %2 values for %3 cells and is not read.</source>
        <translation>Ihr Feld „%1“ hat %2 Werte für %3 Zellen und wird nicht gelesen.</translation>
    </message>
    <message>
        <source>Its array &apos;%1&apos; has %2 values for %3 points and is not read.</source>
        <translation>Ihr Feld „%1“ hat %2 Werte für %3 Punkte und wird nicht gelesen.</translation>
    </message>
    <message>
        <source>it has cells of a shape that TAn does not support: %1. Divide them into simpler ones, in ParaView with the filter Tetrahedralize or Tessellate.</source>
        <translation>sie hat Zellen einer Form, die TAn nicht kennt: %1. Zerlegen Sie sie in einfachere, in ParaView mit dem Filter Tetrahedralize oder Tessellate.</translation>
    </message>
    <message>
        <source>a face of cell %1 (from 0) has %2 points, more than are listed, or fewer than three. It is damaged.</source>
        <translation>eine Seite von Zelle %1 (ab 0) hat %2 Punkte, mehr, als aufgeführt sind, oder weniger als drei. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>1 cell has nodes in the middle of its faces, which were not used.</source>
        <translation>1 Zelle hat Knoten in der Mitte ihrer Seiten, die nicht benutzt wurden.</translation>
    </message>
    <message>
        <source>%1 cells have nodes in the middle of their faces, which were not used.</source>
        <translation>%1 Zellen haben Knoten in der Mitte ihrer Seiten, die nicht benutzt wurden.</translation>
    </message>
    <message>
        <source>1 cell is of a higher order: it was read by its corners alone, with straight edges.</source>
        <translation>1 Zelle ist von höherer Ordnung: Nur ihre Ecken wurden gelesen, mit geraden Kanten.</translation>
    </message>
    <message>
        <source>%1 cells are of a higher order: they were read by their corners alone, with straight edges.</source>
        <translation>%1 Zellen sind von höherer Ordnung: Nur ihre Ecken wurden gelesen, mit geraden Kanten.</translation>
    </message>
    <message>
        <source>The patches of its boundary are not read: %1.</source>
        <translation>Die Patches ihrer Berandung werden nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>Its zones of cells are not distinguished: %1.</source>
        <translation>Ihre Zonen von Zellen werden nicht unterschieden: %1.</translation>
    </message>
    <message>
        <source>Its clouds of particles are not read.</source>
        <translation>Ihre Wolken von Partikeln werden nicht gelesen.</translation>
    </message>
    <message>
        <source>its case is decomposed into folders that several processors share (processors2 ...), which VTK 9.1 does not read. Run reconstructPar, and open it again.</source>
        <translation>ihr Fall ist in Ordner zerlegt, die sich mehrere Prozessoren teilen (processors2 ...), was VTK 9.1 nicht liest. Rufen Sie reconstructPar auf, und öffnen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its case has no mesh: there is no &apos;constant/polyMesh&apos; in &apos;%1&apos;, and no folder of a processor. The file must lie in the folder of the case, beside &apos;constant&apos; and &apos;system&apos;.</source>
        <translation>ihr Fall hat kein Netz: In „%1“ gibt es kein „constant/polyMesh“ und keinen Ordner eines Prozessors. Die Datei muss im Ordner des Falls liegen, neben „constant“ und „system“.</translation>
    </message>
    <message>
        <source>the folders of %1 processors</source>
        <translation>die Ordner von %1 Prozessoren</translation>
    </message>
    <message>
        <source>Its case as a whole is not read: the folders of its processors contain later times.</source>
        <translation>Ihr Fall als Ganzes wird nicht gelesen: Die Ordner seiner Prozessoren reichen bis zu späteren Zeiten.</translation>
    </message>
    <message>
        <source>The folders of its %1 processors are not read: the case as a whole is.</source>
        <translation>Die Ordner ihrer %1 Prozessoren werden nicht gelesen, sondern der Fall als Ganzes.</translation>
    </message>
    <message>
        <source>1 other part has no &apos;%1&apos; and is not read: %2.</source>
        <translation>1 weiterer Teil hat kein „%1“ und wird nicht gelesen: %2.</translation>
    </message>
    <message>
        <source>%1 other parts have no &apos;%2&apos; and are not read: %3.</source>
        <translation>%1 weitere Teile haben kein „%2“ und werden nicht gelesen: %3.</translation>
    </message>
    <message>
        <source>1 other part is not read: %1.</source>
        <translation>1 weiterer Teil wird nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>%1 other parts are not read: %2.</source>
        <translation>%1 weitere Teile werden nicht gelesen: %2.</translation>
    </message>
    <message>
        <source>Field data, which belong to no point or cell, are not read: %1.</source>
        <translation>Felddaten, die zu keinem Punkt und keiner Zelle gehören, werden nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>%1 of %2, time %3, file &apos;%4&apos;</source>
        <translation>%1 von %2, Zeit %3, Datei „%4“</translation>
    </message>
    <message>
        <source>VTK finds nothing in it that it can read. Export it in another format (.vtu, .vti).</source>
        <translation>VTK findet nichts darin, was es lesen kann. Exportieren Sie sie in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>it refers to the file &apos;%1&apos;, which is not in its folder or below it. Put it there, and correct its name.</source>
        <translation>sie nennt die Datei „%1“, die nicht in ihrem Ordner oder darunter liegt. Legen Sie sie dort ab, und schreiben Sie ihren Namen neu.</translation>
    </message>
    <message>
        <source>it has the time &apos;%1&apos;, which is not a number.</source>
        <translation>sie hat die Zeit „%1“, die keine Zahl ist.</translation>
    </message>
    <message>
        <source>its XML ends or breaks in line %1. It is damaged or cut short: copy or export it again.</source>
        <translation>ihr XML endet oder bricht in Zeile %1 ab. Sie ist beschädigt oder abgeschnitten: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its JSON breaks at byte %1. It is damaged or cut short: copy or export it again.</source>
        <translation>ihr JSON bricht bei Byte %1 ab. Sie ist beschädigt oder abgeschnitten: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it has no list of &apos;files&apos;.</source>
        <translation>sie hat keine Liste „files“.</translation>
    </message>
    <message>
        <source>its file number %1 does not have a &apos;name&apos; and a &apos;time&apos; that is a number.</source>
        <translation>ihre Datei Nummer %1 ist nicht durch einen „name“ und eine „time“ als Zahl angegeben.</translation>
    </message>
    <message>
        <source>it has %1 bytes, more than a list of files has.</source>
        <translation>sie hat %1 Bytes, mehr als eine Liste von Dateien hat.</translation>
    </message>
    <message>
        <source>it is a list of files, but names none.</source>
        <translation>sie ist eine Liste von Dateien und nennt keine.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; is not of VTK&apos;s own formats. Open that file on its own.</source>
        <translation>ihre Datei „%1“ hat keines der eigenen Formate von VTK. Öffnen Sie jene Datei für sich allein.</translation>
    </message>
    <message>
        <source>VTK says: %1 TAn cannot tell whether the file is damaged or of a kind that VTK does not read. Compare it with its original, or export it in another format (.vtu, .vti).</source>
        <translation>VTK meldet: %1 TAn kann nicht feststellen, ob die Datei beschädigt ist oder von einer Art, die VTK nicht liest. Vergleichen Sie sie mit ihrem Original, oder exportieren Sie sie in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>VTK reads different values each time: where the file has none, it returns what was in memory. The file is incomplete, or of a kind that VTK reads wrongly. Export it again, or in another format (.vtu, .vti).</source>
        <translation>VTK liest sie zweimal und findet verschiedene Werte: Wo die Datei keine hat, liefert es, was im Arbeitsspeicher stand. Die Datei ist unvollständig oder von einer Art, die VTK falsch liest. Exportieren Sie sie noch einmal, oder in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>Lists of VTK files (*.pvd *.series)</source>
        <translation>Listen von VTK-Dateien (*.pvd *.series)</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libvtk9-dev&apos;), or convert the file to NRRD or CSV.</source>
        <translation>Installieren Sie das Paket tan-vtk-readers, das mit TAn kommt: „apt install ./tan-vtk-readers_*.deb“, wo die Datei liegt (bei einem selbst gebauten TAn: Bauen Sie es nach „apt install libvtk9-dev“ neu), oder wandeln Sie die Datei in NRRD oder CSV um.</translation>
    </message>
    <message>
        <source>Export it again, or in another format (.vtu, .vti).</source>
        <translation>Exportieren Sie sie noch einmal, oder in einem anderen Format (.vtu, .vti).</translation>
    </message>
    <message>
        <source>Install the NetCDF library with &apos;apt install libnetcdf19&apos;.</source>
        <translation>Installieren Sie die NetCDF-Bibliothek mit „apt install libnetcdf19“.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; has %2 values, which do not fit into half of the memory of this machine. Choose a smaller one.</source>
        <translation>ihre Variable „%1“ hat %2 Werte, die nicht in die Hälfte des Speichers dieses Rechners passen. Nehmen Sie eine kleinere.</translation>
    </message>
    <message>
        <source>The region does not lie in the grid, of which it takes the numbers of points, not coordinates: along %1 whole numbers from 0 to %2.</source>
        <translation>Der Bereich liegt nicht im Gitter, dessen Punktnummern er verlangt, nicht Koordinaten: entlang %1 ganze Zahlen von 0 bis %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a file of an OpenFOAM case, which is opened as a whole: open &apos;system/controlDict&apos; in its folder, or an empty file there whose name ends in &apos;.foam&apos;.%2</source>
        <translation>„%1“ ist eine Datei eines OpenFOAM-Falls, der als Ganzes geöffnet wird: mit „system/controlDict“ in seinem Ordner oder mit einer leeren Datei dort, deren Name auf „.foam“ endet.%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the folder of an OpenFOAM case. Open &apos;system/controlDict&apos; in it.</source>
        <translation>„%1“ ist der Ordner eines OpenFOAM-Falls. Öffnen Sie darin „system/controlDict“.</translation>
    </message>
    <message>
        <source>%1 It has %2 parts, of which &apos;part&apos; takes one: %3.</source>
        <translation>%1 Sie hat %2 Teile, von denen „part“ einen nimmt: %3.</translation>
    </message>
    <message>
        <source>%1 needs more than %2 of memory for it, half of what this machine has. It may be damaged, or too large for this machine: take a part of it.</source>
        <translation>%1 braucht dafür mehr als %2 Speicher, die Hälfte dessen, was dieser Rechner hat. Die Datei ist vielleicht beschädigt oder zu groß für diesen Rechner: Nehmen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>%1 needs more than %2 of memory for it, which files of its size do not need. It may be damaged; if not, write it in another format (.vtu, .vti, .nrrd).</source>
        <translation>%1 braucht dafür mehr als %2 Speicher, was Dateien dieser Größe nicht brauchen. Die Datei ist vielleicht beschädigt; wenn nicht, schreiben Sie sie in einem anderen Format (.vtu, .vti, .nrrd).</translation>
    </message>
    <message>
        <source>%1 needs more than %2 seconds of processor time for it, which files of its size do not need. It may be damaged; if not, write it in another format (.vtu, .vti, .nrrd).</source>
        <translation>%1 braucht dafür mehr als %2 Sekunden Prozessorzeit, was Dateien dieser Größe nicht brauchen. Die Datei ist vielleicht beschädigt; wenn nicht, schreiben Sie sie in einem anderen Format (.vtu, .vti, .nrrd).</translation>
    </message>
    <message>
        <source>%1&apos;s reader crashed, and TAn cannot tell why: the file may be damaged, or of a kind that %1 reads incorrectly. %2</source>
        <translation>Der Leser von %1 ist abgestürzt, und TAn kann nicht sagen, warum: Die Datei ist vielleicht beschädigt oder von einer Art, die %1 schlecht liest. %2</translation>
    </message>
    <message>
        <source>it has no values, of points or of cells. Write it with some.</source>
        <translation>sie hat keine Werte, weder von Punkten noch von Zellen. Schreiben Sie sie mit welchen.</translation>
    </message>
    <message>
        <source>it has polyhedra, but not their faces: these are in the arrays &apos;faces&apos; and &apos;faceoffsets&apos; or, since VTK 9.4, &apos;face_connectivity&apos;, &apos;face_offsets&apos;, &apos;polyhedron_to_faces&apos; and &apos;polyhedron_offsets&apos;. Save it again, or divide its cells into tetrahedra.</source>
        <translation>sie hat Polyeder, aber nicht deren Seiten: Diese stehen in den Feldern „faces“ und „faceoffsets“ oder, seit VTK 9.4, „face_connectivity“, „face_offsets“, „polyhedron_to_faces“ und „polyhedron_offsets“. Speichern Sie sie neu, oder zerlegen Sie ihre Zellen in Tetraeder.</translation>
    </message>
    <message>
        <source>the offsets of its faces do not rise, or point beyond their points.</source>
        <translation>die Anfänge ihrer Seiten steigen nicht oder führen über deren Punkte hinaus.</translation>
    </message>
    <message>
        <source>the polyhedron %1 has the face %2 of %3.</source>
        <translation>das Polyeder %1 hat die Seite %2 von %3.</translation>
    </message>
    <message>
        <source>its polyhedra use its faces more often than cells of a mesh can.</source>
        <translation>ihre Polyeder verwenden ihre Seiten öfter, als die Zellen eines Netzes es können.</translation>
    </message>
    <message>
        <source>Give the number of a channel, from 1.</source>
        <translation>Geben Sie die Nummer eines Kanals an, ab 1.</translation>
    </message>
    <message>
        <source>The array to take, by its path in the file, as in /fields/density, or by number; &apos;automatic&apos; takes the one that the file shows first (NeXus), else the largest.</source>
        <translation>Das Array, das genommen wird, nach seinem Pfad in der Datei, wie in /fields/density, oder nach seiner Nummer; „automatic“ nimmt das, welches die Datei zuerst zeigt (NeXus), sonst das größte.</translation>
    </message>
    <message>
        <source>Arrays with several time steps: which one, from 1.</source>
        <translation>Bei Arrays mit mehreren Zeitschritten: welcher, ab 1.</translation>
    </message>
    <message>
        <source>Arrays with several channels: the number of one, from 1; by default the first.</source>
        <translation>Bei Arrays mit mehreren Kanälen: die Nummer eines davon, ab 1; sonst der erste.</translation>
    </message>
    <message>
        <source>Arrays with more dimensions than space, time and channels: the number along each, from 1, as in d2=3; by default the first.</source>
        <translation>Bei Arrays mit mehr Dimensionen als Raum, Zeit und Kanälen: die Nummer entlang jeder davon, ab 1, wie in d2=3; sonst wird die erste genommen.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libhdf5-dev&apos;), or save the array as .npy, for instance with h5py and NumPy.</source>
        <translation>Installieren Sie das Paket tan-vtk-readers, das mit TAn kommt: „apt install ./tan-vtk-readers_*.deb“, wo die Datei liegt (bei einem selbst gebauten TAn: Bauen Sie es nach „apt install libhdf5-dev“ neu), oder speichern Sie das Array als .npy, etwa mit h5py und NumPy.</translation>
    </message>
    <message>
        <source>Install the HDF5 library with &apos;apt install libhdf5-103-1&apos; (other systems: hdf5).</source>
        <translation>Installieren Sie die HDF5-Bibliothek mit „apt install libhdf5-103-1“ (andere Systeme: hdf5).</translation>
    </message>
    <message>
        <source>Copy or export it again; &apos;h5dump -H&apos; shows its content.</source>
        <translation>Kopieren oder exportieren Sie sie noch einmal; „h5dump -H“ zeigt, was darin ist.</translation>
    </message>
    <message>
        <source>it has %1 %2, and number %3 was requested with &apos;%4&apos;.</source>
        <translation>sie hat %1 %2, und verlangt ist mit „%4“ Nummer %3.</translation>
    </message>
    <message>
        <source>components, counted from 0</source>
        <translation>Komponenten, gezählt ab 0</translation>
    </message>
    <message>
        <source>numbers along &apos;%1&apos;</source>
        <translation>Nummern entlang „%1“</translation>
    </message>
    <message>
        <source>its array %1 has no further dimension &apos;%2&apos;, which was requested with &apos;index&apos;.</source>
        <translation>ihr Array %1 hat keine weitere Dimension „%2“, die mit „index“ verlangt wird.</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>its array %1 has fewer than three dimensions of space: the others are time or channels. TAn reads volumes: choose another array, or write one.</source>
        <translation>ihr Array %1 hat weniger als drei Dimensionen im Raum: Die anderen sind solche der Zeit oder der Kanäle. TAn nimmt Volumen: Wählen Sie ein anderes Array, oder schreiben Sie eines.</translation>
    </message>
    <message>
        <source>its array %1 needs %2 of memory, and this machine can spare %3. Write a part of it, or one with fewer points.</source>
        <translation>ihr Array %1 braucht %2 Speicher, und dieser Rechner kann %3 entbehren. Schreiben Sie einen Teil davon oder eines mit weniger Punkten.</translation>
    </message>
    <message>
        <source>It has an attribute &apos;%1&apos;, which is not used.</source>
        <translation>Sie hat ein Attribut „%1“, das nicht benutzt wird.</translation>
    </message>
    <message>
        <source>It holds other arrays, which are not read: %1.</source>
        <translation>Sie enthält andere Arrays, die nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>%1, &apos;%2&apos; in the order of the array&apos;s axes</source>
        <translation>%1, „%2“ in der Reihenfolge der Achsen des Arrays</translation>
    </message>
    <message>
        <source>Its coordinates &apos;%1&apos; are the edges of bins: their midpoints were used.</source>
        <translation>Ihre Koordinaten „%1“ sind die Ränder von Intervallen: Genommen wurden deren Mitten.</translation>
    </message>
    <message>
        <source>&apos;Origin&apos;, &apos;Spacing&apos; and &apos;Directions&apos; of ITK</source>
        <translation>„Origin“, „Spacing“ und „Directions“ von ITK</translation>
    </message>
    <message>
        <source>the chunks of its array &apos;%1&apos;</source>
        <translation>die Stücke (Chunks) ihres Arrays „%1“</translation>
    </message>
    <message>
        <source>nothing was written to its array %1: it holds only a fill value. Choose another array, or write this one.</source>
        <translation>in ihr Array %1 wurde nichts geschrieben: Alles, was es hat, ist ein Füllwert. Wählen Sie ein anderes Array, oder schreiben Sie dieses.</translation>
    </message>
    <message>
        <source>only %1 of the %2 chunks of its array &apos;%3&apos; were written, and it has no fill value for the others. Write all of it.</source>
        <translation>nur %1 der %2 Stücke (Chunks) ihres Arrays „%3“ wurden geschrieben, und es hat keinen Füllwert für die anderen. Schreiben Sie es ganz.</translation>
    </message>
    <message>
        <source>%1, the array&apos;s fill value</source>
        <translation>%1, der Füllwert des Arrays</translation>
    </message>
    <message>
        <source>%1, %2, the array&apos;s fill value</source>
        <translation>%1, %2, der Füllwert des Arrays</translation>
    </message>
    <message>
        <source>0 in %1 of %2 chunks, which were never written</source>
        <translation>0 in %1 von %2 Stücken (Chunks), die nie geschrieben wurden</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos;</source>
        <translation>ihr Array „%1“</translation>
    </message>
    <message>
        <source>Its numbers of more than 64 bits were converted to floating-point numbers, which are exact to 53 bits.</source>
        <translation>Aus ihren Zahlen mit mehr als 64 Bit wurden Gleitkommazahlen von 53 Bit.</translation>
    </message>
    <message>
        <source>It holds more than %1 groups and arrays, or groups nested more than %2 levels deep: not all of them were examined.</source>
        <translation>Sie enthält mehr als %1 Gruppen und Arrays oder mehr als %2-fach verschachtelte Gruppen: Nicht alle davon wurden durchgesehen.</translation>
    </message>
    <message>
        <source>Its links into other files are not followed: %1.</source>
        <translation>Ihren Verweisen in andere Dateien wird nicht gefolgt: %1.</translation>
    </message>
    <message>
        <source>it is a file of %1, which TAn recognises by its name. Give it the ending %2.</source>
        <translation>sie ist eine Datei von %1, die TAn an ihrem Namen erkennt. Geben Sie ihr die Endung %2.</translation>
    </message>
    <message>
        <source>it is a MINC 2 file, whose numbers are scaled slice by slice; this is not read. Convert it with mnc2nii.</source>
        <translation>sie ist eine MINC-2-Datei, deren Zahlen schichtweise skaliert sind; das wird nicht gelesen. Wandeln Sie sie mit mnc2nii um.</translation>
    </message>
    <message>
        <source>it holds no arrays of its own. %1 Open the file that holds them.</source>
        <translation>sie enthält keine eigenen Arrays. %1 Öffnen Sie die Datei, die sie enthält.</translation>
    </message>
    <message>
        <source>it holds no arrays. Write it with values.</source>
        <translation>sie enthält keine Arrays. Schreiben Sie sie mit Werten.</translation>
    </message>
    <message>
        <source>none of its arrays has numbers along three dimensions with two points or more: %1. TAn takes volumes: choose a file that holds one, or write one, for instance with h5py.</source>
        <translation>keines ihrer Arrays hat Zahlen entlang dreier Dimensionen mit je zwei oder mehr Punkten: %1. TAn nimmt Volumen: Wählen Sie eine Datei, die eines enthält, oder schreiben Sie eine, etwa mit h5py.</translation>
    </message>
    <message>
        <source>the values of its array &apos;%1&apos; lie in other files or arrays, which are not opened. Copy them into an array of their own, for instance with h5py.</source>
        <translation>die Werte ihres Arrays „%1“ liegen in anderen Dateien oder Arrays, die nicht geöffnet werden. Kopieren Sie sie in ein eigenes Array, etwa mit h5py.</translation>
    </message>
    <message>
        <source>its array %1 holds no numbers that can be read. Choose another one.</source>
        <translation>ihr Array %1 enthält keine Zahlen, die gelesen werden. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>its array %1 does not extend along three dimensions with two points or more. Choose one that does.</source>
        <translation>ihr Array %1 erstreckt sich nicht entlang dreier Dimensionen mit je zwei oder mehr Punkten. Wählen Sie eines, das es tut.</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>die ganze Datei</translation>
    </message>
    <message>
        <source>%1 (in other files)</source>
        <translation>%1 (in anderen Dateien)</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; does not state how it is packed. The file is damaged: copy or export it again.</source>
        <translation>ihr Array „%1“ sagt nicht, wie es gepackt ist. Die Datei ist beschädigt: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; is packed with the filter %2, which is not part of HDF5 and is not read. Write it with gzip or unpacked: &apos;h5repack -f GZIP=4 old.h5 new.h5&apos; does so where the filter is installed.</source>
        <translation>ihr Array „%1“ ist mit dem Filter %2 gepackt, der kein Teil von HDF5 ist und nicht gelesen wird. Schreiben Sie es mit gzip oder ungepackt: „h5repack -f GZIP=4 old.h5 new.h5“ tut dies, wo der Filter installiert ist.</translation>
    </message>
    <message>
        <source>the HDF5 library says of %1: %2. Copy or export the file again.</source>
        <translation>die HDF5-Bibliothek sagt über %1: %2. Kopieren oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>its size cannot be determined: %1.</source>
        <translation>ihre Größe ist nicht zu ermitteln: %1.</translation>
    </message>
    <message>
        <source>it unpacks to more than %1, which pictures of so few bytes do not. It is damaged; if not, export it without compression.</source>
        <translation>entpackt ist sie größer als %1, was bei Bildern aus so wenigen Bytes nicht vorkommt. Sie ist beschädigt; wenn nicht, exportieren Sie sie ohne Kompression.</translation>
    </message>
    <message>
        <source>1 slice is missing between the others. The gap stays, and values are interpolated across it.</source>
        <translation>Zwischen den anderen fehlt 1 Schicht. Die Lücke bleibt, und über sie hinweg wird interpoliert.</translation>
    </message>
    <message>
        <source>%1 slices are missing between the others. The gaps stay, and values are interpolated across them.</source>
        <translation>Zwischen den anderen fehlen %1 Schichten. Die Lücken bleiben, und über sie hinweg wird interpoliert.</translation>
    </message>
    <message>
        <source>SeriesNumber %1, %2</source>
        <translation>SeriesNumber %1, %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>its folder holds one series, and &apos;%1&apos; was requested. Leave &apos;series&apos; out.</source>
        <translation>ihr Ordner enthält eine Serie, und verlangt ist „%1“. Lassen Sie „series“ weg.</translation>
    </message>
    <message>
        <source>its folder holds %1 series, and &apos;%2&apos; was requested. Choose one with &apos;series&apos;, by its number from 1 or its description: %3.</source>
        <translation>ihr Ordner enthält %1 Serien, und verlangt ist „%2“. Wählen Sie eine mit „series“, nach der Nummer von 1 an oder nach der Beschreibung: %3.</translation>
    </message>
    <message>
        <source>Next to it is series %1: %2.</source>
        <translation>Daneben liegt Serie %1: %2.</translation>
    </message>
    <message>
        <source>The series holds %1 volumes; the others are not read.</source>
        <translation>Die Serie enthält %1 Volumen; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>A folder with several DICOM series, or an OME file with several images: which one, by number from 1, by its description or name, or by its SeriesInstanceUID; by default that of the file, or the first.</source>
        <translation>Bei einem Ordner mit mehreren DICOM-Serien oder einer OME-Datei mit mehreren Bildern: welche oder welches, nach der Nummer von 1 an, nach Beschreibung oder Name oder nach der SeriesInstanceUID; ohne Angabe das der Datei oder das erste.</translation>
    </message>
    <message>
        <source>a piece of %1 has %2 bytes, which cannot hold the %3 that its size requires.</source>
        <translation>ein Stück von %1 hat %2 Bytes, in denen die %3, die seine Größe verlangt, keinen Platz haben.</translation>
    </message>
    <message>
        <source>its description, or its resolution,</source>
        <translation>ihre Beschreibung oder ihre Auflösung</translation>
    </message>
    <message>
        <source>page %1 is followed by no page, or by an earlier one.</source>
        <translation>hinter Seite %1 folgt keine Seite oder eine, die schon vorkam.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;, and nothing to choose from. Leave &apos;%2&apos; out.</source>
        <translation>sie hat kein „%1“ für „%2“ und nichts, was zur Wahl steht. Lassen Sie „%2“ weg.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;. Choose one from 1 to %3.</source>
        <translation>sie hat kein „%1“ für „%2“. Wählen Sie eines von 1 bis %3.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;. Choose one from 1 to %3, or by its name: %4.</source>
        <translation>sie hat kein „%1“ für „%2“. Wählen Sie eines von 1 bis %3 oder nach seinem Namen: %4.</translation>
    </message>
    <message>
        <source>It has %1 channels; the others are not read.</source>
        <translation>Sie hat %1 Kanäle; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1, %2 %3</translation>
    </message>
    <message>
        <source>It has %1 time steps; the others are not read.</source>
        <translation>Sie hat %1 Zeitschritte; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>It holds %1 images; the others are not read.</source>
        <translation>Sie enthält %1 Bilder; die anderen werden nicht gelesen.</translation>
    </message>
    <message>
        <source>its type &apos;%1&apos; is not known. Use uint8, int8, uint16, int16, uint32, int32, int64, uint64, float or double.</source>
        <translation>ihr Typ „%1“ ist nicht bekannt. Es gibt uint8, int8, uint16, int16, uint32, int32, int64, uint64, float und double.</translation>
    </message>
    <message>
        <source>its samples are matrices of %1 numbers (&apos;%2&apos;), whose magnitude has no meaning. Choose one of them with &apos;--component&apos;, from 0.</source>
        <translation>ihre Abtastwerte sind Matrizen aus %1 Zahlen („%2“), deren Betrag nichts bedeutet. Wählen Sie eine davon mit „--component“, ab 0.</translation>
    </message>
    <message>
        <source>%1 numbers of type %2, %3 bytes</source>
        <translation>%1 Zahlen vom Typ %2, %3 Bytes</translation>
    </message>
    <message>
        <source>its array has the shape %1. Export it again.</source>
        <translation>ihr Array hat die Form %1. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it names &apos;%1&apos;, which is not a regular file. Copy its content into one first.</source>
        <translation>sie nennt „%1“, was keine gewöhnliche Datei ist. Kopieren Sie den Inhalt erst in eine.</translation>
    </message>
    <message>
        <source>its values &apos;%1&apos; refer to a node or an element %2, which it does not have.</source>
        <translation>ihre Werte „%1“ nennen einen Knoten oder ein Element %2, das sie nicht hat.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 steps; the last one is read.</source>
        <translation>Von „%1“ hat sie %2 Schritte; der letzte wird gelesen.</translation>
    </message>
    <message>
        <source>%1, %2 (%3 %4)</source>
        <translation>%1, %2 (%3 %4)</translation>
    </message>
    <message>
        <source>NetCDF and Exodus files: the variable, by name or number; &apos;automatic&apos; takes the first that is not constant.</source>
        <translation>Bei NetCDF- und Exodus-Dateien: die Variable, nach Name oder Nummer; „automatic“ nimmt die erste, die nicht konstant ist.</translation>
    </message>
    <message>
        <source>%1: it is of another format that begins with whole numbers, such as a surface of MOVIE.BYU, or only the beginning of a grid. Export its data as PLOT3D, .vtu or a table.</source>
        <translation>%1: Sie hat ein anderes Format, das mit ganzen Zahlen beginnt, etwa das einer Fläche von MOVIE.BYU, oder ist nur der Anfang eines Gitters. Exportieren Sie ihre Daten als PLOT3D, .vtu oder Tabelle.</translation>
    </message>
    <message>
        <source>Tables of points: the column of the values, by its name or its number in the table, from 1; &apos;automatic&apos; takes the first that is measured, not a counter or a constant.</source>
        <translation>Tabellen von Punkten: die Spalte der Werte, nach ihrem Namen oder ihrer Nummer in der Tabelle, ab 1; „automatic“ nimmt die erste, die Messwerte enthält, keinen Zähler und keine Konstante.</translation>
    </message>
    <message>
        <source>The line of units below its names has %1 of them for %2 columns.</source>
        <translation>Die Zeile der Einheiten unter ihren Namen hat %1 davon für %2 Spalten.</translation>
    </message>
    <message>
        <source>Its file &apos;%1&apos; ends without an end of line: if it was cut short there, its last number is wrong.</source>
        <translation>Ihre Datei „%1“ endet ohne Zeilenende: Wenn sie dort abgeschnitten wurde, ist ihre letzte Zahl falsch.</translation>
    </message>
    <message>
        <source>cell %1 (from 0) is a polyhedron, and VTK 9.1 finds no faces of it: since VTK 9.4 they are written differently, which TAn reads in a single .vtu that is not compressed, or compressed with zlib. Save it as one.</source>
        <translation>Zelle %1 (ab 0) ist ein Polyeder, und VTK 9.1 findet keine Seiten davon: Ab VTK 9.4 werden sie auf andere Weise geschrieben, die TAn aus einer einzelnen .vtu liest, die nicht oder mit zlib gepackt ist. Speichern Sie die Daten so.</translation>
    </message>
    <message>
        <source>VTK reads its positions in single precision: they may be up to %1 from those in the file.</source>
        <translation>VTK liest ihre Positionen in einfacher Genauigkeit: Sie können um bis zu %1 von denen in der Datei abweichen.</translation>
    </message>
    <message>
        <source>Its families (boundary conditions and the like) are not distinguished: %1.</source>
        <translation>Ihre Familien (Randbedingungen und dergleichen) werden nicht unterschieden: %1.</translation>
    </message>
    <message>
        <source>its part &apos;%1&apos; has %2 points, and its size states another number.</source>
        <translation>ihr Teil „%1“ hat %2 Punkte, und seine Größe sagt eine andere Zahl.</translation>
    </message>
    <message>
        <source>Its grids do not make a mesh together, and only the first one is read. %1</source>
        <translation>Ihre Gitter ergeben zusammen kein Netz, und nur das erste wird gelesen. %1</translation>
    </message>
    <message>
        <source>Files with several blocks or parts: one, by name or number from 1; by default all volumes that have the values, as one mesh.</source>
        <translation>Bei Dateien mit mehreren Blöcken oder Teilen: einer, nach Name oder Nummer ab 1; sonst alle Volumen, die die Werte haben, als ein Netz.</translation>
    </message>
    <message>
        <source>%1 Export the image again.</source>
        <translation>%1 Exportieren Sie das Bild noch einmal.</translation>
    </message>
    <message>
        <source>one of its axes has no name.</source>
        <translation>eine ihrer Achsen hat keinen Namen.</translation>
    </message>
    <message>
        <source>it has %1 axes.</source>
        <translation>sie hat %1 Achsen.</translation>
    </message>
    <message>
        <source>its transformation &apos;%1&apos; is in a separate array, which TAn does not read.</source>
        <translation>ihre Transformation „%1“ steht in einem eigenen Array, das TAn nicht liest.</translation>
    </message>
    <message>
        <source>its transformation &apos;%1&apos; does not have one number for each of its %2 axes.</source>
        <translation>ihre Transformation „%1“ hat nicht für jede ihrer %2 Achsen eine Zahl.</translation>
    </message>
    <message>
        <source>its transformation is of the kind &apos;%1&apos;, and TAn reads &apos;scale&apos; and &apos;translation&apos;.</source>
        <translation>ihre Transformation ist von der Art „%1“, und TAn liest „scale“ und „translation“.</translation>
    </message>
    <message>
        <source>one of its levels has no path.</source>
        <translation>eine ihrer Stufen hat keinen Pfad.</translation>
    </message>
    <message>
        <source>it names no levels.</source>
        <translation>sie nennt keine Stufen.</translation>
    </message>
    <message>
        <source>its list of images (&apos;multiscales&apos;) is empty.</source>
        <translation>ihre Liste der Bilder („multiscales“) ist leer.</translation>
    </message>
    <message>
        <source>Its group describes %1 images; only the first of them is read.</source>
        <translation>Ihre Gruppe beschreibt %1 Bilder; nur das erste davon wird gelesen.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos;: %2</source>
        <translation>ihr Array „%1“: %2</translation>
    </message>
    <message>
        <source>its metadata have no usable &apos;%1&apos;. Copy or export it again.</source>
        <translation>ihre Metadaten haben kein brauchbares „%1“. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1, which TAn does not read. %2</source>
        <translation>%1, was TAn nicht liest. %2</translation>
    </message>
    <message>
        <source>Write it with Blosc, Zstandard, gzip or zlib.</source>
        <translation>Schreiben Sie sie mit Blosc, Zstandard, gzip oder zlib.</translation>
    </message>
    <message>
        <source>its chunks have %1 axes, and it has %2. It is damaged.</source>
        <translation>ihre Stücke (Chunks) haben %1 Achsen, und sie selbst hat %2. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>its chunks have no size. It is damaged.</source>
        <translation>ihre Stücke (Chunks) haben keine Größe. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>its chunks would have more bytes than any machine. It is damaged.</source>
        <translation>ihre Stücke (Chunks) hätten mehr Bytes, als irgendein Rechner fasst. Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;</source>
        <translation>ihre Stücke (Chunks) sind mit „%1“ gepackt</translation>
    </message>
    <message>
        <source>its numbers were passed through the filter &apos;%1&apos;</source>
        <translation>ihre Zahlen gingen durch den Filter „%1“</translation>
    </message>
    <message>
        <source>Write it without filters.</source>
        <translation>Schreiben Sie sie ohne Filter.</translation>
    </message>
    <message>
        <source>its elements are records of several fields</source>
        <translation>ihre Elemente sind Datensätze aus mehreren Feldern</translation>
    </message>
    <message>
        <source>its elements are of the type &apos;%1&apos;</source>
        <translation>ihre Elemente sind vom Typ „%1“</translation>
    </message>
    <message>
        <source>Write whole numbers, or floating-point numbers of 16, 32 or 64 bits.</source>
        <translation>Schreiben Sie ganze Zahlen oder Gleitkommazahlen mit 16, 32 oder 64 Bit.</translation>
    </message>
    <message>
        <source>its codec &apos;%1&apos; is in an unusual place</source>
        <translation>ihr Codec „%1“ steht an einer ungewöhnlichen Stelle</translation>
    </message>
    <message>
        <source>its chunks were passed through the codec &apos;%1&apos;</source>
        <translation>ihre Stücke (Chunks) gingen durch den Codec „%1“</translation>
    </message>
    <message>
        <source>its shards are not a whole number of chunks. It is damaged.</source>
        <translation>ihre Shards bestehen nicht aus einer ganzen Zahl von Stücken (Chunks). Sie ist beschädigt.</translation>
    </message>
    <message>
        <source>the index of its shards is packed</source>
        <translation>das Verzeichnis ihrer Shards ist gepackt</translation>
    </message>
    <message>
        <source>Write it unpacked.</source>
        <translation>Schreiben Sie sie ungepackt.</translation>
    </message>
    <message>
        <source>the names of its chunks are of the kind &apos;%1&apos;</source>
        <translation>die Namen ihrer Stücke (Chunks) sind von der Art „%1“</translation>
    </message>
    <message>
        <source>Write it with the names &apos;default&apos;.</source>
        <translation>Schreiben Sie sie mit den Namen „default“.</translation>
    </message>
    <message>
        <source>it has the storage transformer &apos;%1&apos;</source>
        <translation>sie verwendet die Speicherumformung (storage transformer) „%1“</translation>
    </message>
    <message>
        <source>Write it without one.</source>
        <translation>Schreiben Sie sie ohne.</translation>
    </message>
    <message>
        <source>its chunks lie in a grid of the kind &apos;%1&apos;</source>
        <translation>ihre Stücke (Chunks) liegen in einem Gitter der Art „%1“</translation>
    </message>
    <message>
        <source>Write it in chunks of one size.</source>
        <translation>Schreiben Sie sie in Stücken (Chunks) von einheitlicher Größe.</translation>
    </message>
    <message>
        <source>it is of version %1 of Zarr&apos;s format</source>
        <translation>sie ist von Version %1 des Zarr-Formats</translation>
    </message>
    <message>
        <source>TAn reads the versions 2 and 3.</source>
        <translation>TAn liest die Versionen 2 und 3.</translation>
    </message>
    <message>
        <source>it has no level &apos;%1&apos;. Choose one from 0 to %2 with &apos;part&apos;.</source>
        <translation>sie hat keine Stufe „%1“. Wählen Sie mit „part“ eine von 0 bis %2.</translation>
    </message>
    <message>
        <source>It has %1 levels of detail, 0 being the finest; the others are not read. Choose one with &apos;part&apos;.</source>
        <translation>Sie hat %1 Detailstufen, von denen 0 die feinste ist; die anderen werden nicht gelesen. Wählen Sie eine mit „part“.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;.</source>
        <translation>sie hat kein Array „%1“.</translation>
    </message>
    <message>
        <source>Its labels, which number the parts of a picture, are not read.</source>
        <translation>Ihre Labels, die die Teile eines Bildes nummerieren, werden nicht gelesen.</translation>
    </message>
    <message>
        <source>It holds %1 other arrays (%2), which are not read. Choose one with &apos;array&apos;.</source>
        <translation>Sie enthält außerdem %1 Arrays (%2), die nicht gelesen werden. Wählen Sie eines mit „array“.</translation>
    </message>
    <message>
        <source>%1 of its groups and arrays have metadata that cannot be read.</source>
        <translation>%1 ihrer Gruppen und Arrays haben Metadaten, die nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>It has more groups and arrays than are listed; &apos;array&apos; takes any of them by its path.</source>
        <translation>Sie hat mehr Gruppen und Arrays, als durchgesehen werden; „array“ nimmt jedes davon nach seinem Pfad.</translation>
    </message>
    <message>
        <source>it is an array with %1 axes, and TAn reads volumes, which have three.</source>
        <translation>sie ist ein Array mit %1 Achsen, und TAn liest Volumen, die drei haben.</translation>
    </message>
    <message>
        <source>it holds %1 arrays, and none of numbers along three axes or more.</source>
        <translation>sie enthält %1 Arrays, und keines hat Zahlen entlang dreier oder mehr Achsen.</translation>
    </message>
    <message>
        <source>it holds no array. Open the folder that contains the arrays, or copy it again.</source>
        <translation>sie enthält kein Array. Öffnen Sie den Ordner, in dem die Arrays sind, oder kopieren Sie diesen Ordner noch einmal.</translation>
    </message>
    <message>
        <source>it has %1 of &apos;%2&apos;, and number %3 was requested. Choose one from 1 to %1.</source>
        <translation>sie hat %1 von „%2“, und verlangt ist Nummer %3. Wählen Sie eine von 1 bis %1.</translation>
    </message>
    <message>
        <source>%1, time %2 %3</source>
        <translation>%1, Zeit %2 %3</translation>
    </message>
    <message>
        <source>It has %1 volumes along its axis &apos;%2&apos;, of which the first is read. Choose one with &apos;index&apos;, as in %2=2.</source>
        <translation>Sie hat %1 Volumen entlang ihrer Achse „%2“, von denen das erste gelesen wird. Wählen Sie eines mit „index“, wie in %2=2.</translation>
    </message>
    <message>
        <source>it has no further axis &apos;%1&apos; for &apos;index&apos;.</source>
        <translation>sie hat keine weitere Achse „%1“ für „index“.</translation>
    </message>
    <message>
        <source>it holds no values: its size is %1.</source>
        <translation>sie enthält keine Werte: Ihre Größe ist %1.</translation>
    </message>
    <message>
        <source>it holds pictures, not volumes: it has fewer than three axes of space (its size is %1).</source>
        <translation>sie enthält Bilder, keine Volumen: Sie hat weniger als drei Achsen im Raum (ihre Größe ist %1).</translation>
    </message>
    <message>
        <source>x, y and z along its axes %1, %2 and %3</source>
        <translation>x, y und z entlang ihrer Achsen %1, %2 und %3</translation>
    </message>
    <message>
        <source>Its axes x, y and z have different units, or none (%1), which are not converted.</source>
        <translation>Ihre Achsen x, y und z haben verschiedene Einheiten oder keine (%1); sie werden nicht umgerechnet.</translation>
    </message>
    <message>
        <source>Its axes x, y and z have different units (%1): all are converted to %2.</source>
        <translation>Ihre Achsen x, y und z haben verschiedene Einheiten (%1): Alle werden in %2 umgerechnet.</translation>
    </message>
    <message>
        <source>its scale along an axis of space is 0. Export it again.</source>
        <translation>ihr Maßstab entlang einer Achse im Raum ist 0. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Its attributes %1 are not used: the stored values are.</source>
        <translation>Ihre Attribute %1 werden nicht benutzt: Die Werte sind so, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>It holds %1 arrays of volumes; the others are not read. Choose one with &apos;array&apos;.</source>
        <translation>Sie enthält %1 Arrays mit Volumen; die anderen werden nicht gelesen. Wählen Sie eines mit „array“.</translation>
    </message>
    <message>
        <source>its level &apos;%1&apos; has %2 axes, and it describes %3. Export it again.</source>
        <translation>ihre Stufe „%1“ hat %2 Achsen, und beschrieben sind %3. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its level &apos;%1&apos; is missing. The copy is not complete: copy the folder again, or choose another level with &apos;part&apos;.</source>
        <translation>ihre Stufe „%1“ ist nicht da. Die Kopie ist nicht vollständig: Kopieren Sie den Ordner noch einmal, oder wählen Sie mit „part“ eine andere Stufe.</translation>
    </message>
    <message>
        <source>it is damaged: %1. Copy or export it again.</source>
        <translation>sie ist beschädigt: %1. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it unpacks to more than the expected %1 bytes</source>
        <translation>entpackt hat sie mehr als die %1 Bytes, die es sein sollten</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>sie kann nicht entpackt werden</translation>
    </message>
    <message>
        <source>Zstandard says &apos;%1&apos;</source>
        <translation>Zstandard meldet „%1“</translation>
    </message>
    <message>
        <source>it does not begin like Blosc data, or is cut short</source>
        <translation>sie beginnt nicht so, wie Blosc schreibt, oder ist abgeschnitten</translation>
    </message>
    <message>
        <source>it unpacks to %1 bytes, more than the expected %2</source>
        <translation>entpackt hat sie %1 Bytes, mehr als die %2, die es sein sollten</translation>
    </message>
    <message>
        <source>Blosc cannot unpack it (%1)</source>
        <translation>Blosc kann sie nicht entpacken (%1)</translation>
    </message>
    <message>
        <source>its checksum is wrong</source>
        <translation>ihre Prüfsumme ist falsch</translation>
    </message>
    <message>
        <source>its differences of numbers of 16 bits (the filter &apos;delta&apos;) are not read. Write it without them.</source>
        <translation>ihre Differenzen von Zahlen mit 16 Bit (der Filter „delta“) werden nicht gelesen. Schreiben Sie sie ohne.</translation>
    </message>
    <message>
        <source>it has %1 bytes, more than its %2 bytes of numbers can yield</source>
        <translation>sie hat %1 Bytes, mehr, als aus ihren %2 Bytes an Zahlen werden kann</translation>
    </message>
    <message>
        <source>it has %1 bytes of numbers instead of %2</source>
        <translation>sie hat %1 Bytes an Zahlen statt %2</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; cannot be read (%2). Check its permissions.</source>
        <translation>ihre Datei „%1“ kann nicht gelesen werden (%2). Prüfen Sie deren Rechte.</translation>
    </message>
    <message>
        <source>it cannot be read (%1). Check the name and the permissions.</source>
        <translation>sie kann nicht gelesen werden (%1). Prüfen Sie den Namen und die Rechte.</translation>
    </message>
    <message>
        <source>it refers to &apos;%1&apos;, which is not a path inside the folder. Only what is in the folder is read.</source>
        <translation>sie nennt „%1“, was kein Pfad innerhalb des Ordners ist. Nur was im Ordner liegt, wird gelesen.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is a link to something that does not exist. Copy the folder together with the targets of its links.</source>
        <translation>ihr Eintrag „%1“ ist ein Verweis auf etwas, das nicht da ist. Kopieren Sie den Ordner mit dem, worauf seine Verweise führen.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is a link that leads out of the folder. Only what is in the folder is read: put a copy in its place.</source>
        <translation>ihr Eintrag „%1“ ist ein Verweis, der aus dem Ordner hinausführt. Nur was im Ordner liegt, wird gelesen: Legen Sie an seiner Stelle eine Kopie ab.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is not a file. Copy or export it again.</source>
        <translation>ihr Eintrag „%1“ ist keine Datei. Kopieren oder exportieren Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is larger than metadata are (%2). It is damaged, or not Zarr.</source>
        <translation>ihre Datei „%1“ ist größer, als Metadaten sind (%2). Sie ist beschädigt oder kein Zarr.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; %2</source>
        <translation>ihre Datei „%1“ %2</translation>
    </message>
    <message>
        <source>is not JSON: %1 at byte %2. Copy or export it again.</source>
        <translation>ist kein JSON: %1 bei Byte %2. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>holds no JSON object. Copy or export it again.</source>
        <translation>enthält kein JSON-Objekt. Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; was changed while it was read. Try again.</source>
        <translation>ihre Datei „%1“ wurde geändert, während sie gelesen wurde. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>none of the %1 files with its values exists, such as &apos;%2&apos;. The copy is not complete, or they were never written: copy or export it again.</source>
        <translation>keine der %1 Dateien mit ihren Werten ist da, etwa „%2“. Die Kopie ist nicht vollständig, oder sie wurden nie geschrieben: Kopieren oder exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 of its %2 chunks are missing: as the format specifies, their values are the fill value %3.</source>
        <translation>%1 ihrer %2 Stücke (Chunks) sind nicht da: Wie es das Format vorsieht, gilt für ihre Werte der Füllwert %3.</translation>
    </message>
    <message>
        <source>%1 of its %2 chunks are missing, and it has no fill value: %3 is assumed.</source>
        <translation>%1 ihrer %2 Stücke (Chunks) sind nicht da, und sie hat keinen Füllwert: %3 wird angenommen.</translation>
    </message>
    <message>
        <source>it lies in %1 files, more than %2. Write it in larger chunks.</source>
        <translation>sie liegt in %1 Dateien, mehr als %2. Schreiben Sie sie in größeren Stücken (Chunks).</translation>
    </message>
    <message>
        <source>none of its %1 chunks was written. Export it again.</source>
        <translation>keines ihrer %1 Stücke (Chunks) wurde geschrieben. Exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>it is shorter than the index of its chunks</source>
        <translation>sie ist kürzer als das Verzeichnis ihrer Stücke (Chunks)</translation>
    </message>
    <message>
        <source>the checksum of the index of its chunks is wrong</source>
        <translation>die Prüfsumme des Verzeichnisses ihrer Stücke (Chunks) ist falsch</translation>
    </message>
    <message>
        <source>the index of its chunks points beyond its end</source>
        <translation>das Verzeichnis ihrer Stücke (Chunks) führt über ihr Ende hinaus</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;index&apos; is not understood. Give the name of each axis with a number from 1, as in angle=3,type=1.</source>
        <translation>„%1“ für „index“ ist nicht zu verstehen. Geben Sie den Namen jeder Achse mit einer Nummer ab 1 an, wie in angle=3,type=1.</translation>
    </message>
    <message>
        <source>Zarr groups: the array to take, or the image, by its path in the folder; &apos;automatic&apos; takes the first.</source>
        <translation>Bei Zarr-Gruppen: das Array, das genommen wird, oder das Bild, nach seinem Pfad im Ordner; „automatic“ nimmt das erste.</translation>
    </message>
    <message>
        <source>OME-Zarr with several images: one, by its path or number from 1; by default the first.</source>
        <translation>Bei OME-Zarr mit mehreren Bildern: eines, nach seinem Pfad oder seiner Nummer ab 1; sonst das erste.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>OME-Zarr: the level of detail, by its path or by its number, 0 being the finest, which is the default.</source>
        <translation>Bei OME-Zarr: die Detailstufe, nach ihrem Pfad oder ihrer Nummer, wobei 0 die feinste ist; sonst diese.</translation>
    </message>
    <message>
        <source>Pictures at several times: which one, from 1; 0 takes the first.</source>
        <translation>Bei Bildern zu mehreren Zeiten: welches, ab 1; 0 nimmt das erste.</translation>
    </message>
    <message>
        <source>Further axes</source>
        <translation>Weitere Achsen</translation>
    </message>
    <message>
        <source>Arrays with more axes than space, time and channels: the number along each, from 1, as in angle=3; an axis without a name is called by its number from 1. By default the first is taken.</source>
        <translation>Bei Arrays mit mehr Achsen als Raum, Zeit und Kanälen: die Nummer entlang jeder davon, ab 1, wie in angle=3; eine Achse ohne Namen heißt nach ihrer Nummer ab 1. Sonst wird die erste genommen.</translation>
    </message>
    <message>
        <source>it is neither a Zarr folder nor a file that describes one (zarr.json, .zarray, .zattrs, .zgroup). Let TAn choose the reader.</source>
        <translation>sie ist kein Zarr-Ordner und auch keine Datei, die einen beschreibt (zarr.json, .zarray, .zattrs, .zgroup). Lassen Sie TAn den Leser wählen.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libblosc-dev libzstd-dev&apos;), or save the array as NumPy&apos;s (.npy).</source>
        <translation>Installieren Sie das Paket tan-vtk-readers, das mit TAn kommt: „apt install ./tan-vtk-readers_*.deb“, wo die Datei liegt (bei einem selbst gebauten TAn: Bauen Sie es nach „apt install libblosc-dev libzstd-dev“ neu), oder speichern Sie das Array im Format von NumPy (.npy).</translation>
    </message>
    <message>
        <source>Install Blosc and Zstandard with &apos;apt install libblosc1 libzstd1&apos;.</source>
        <translation>Installieren Sie Blosc und Zstandard mit „apt install libblosc1 libzstd1“.</translation>
    </message>
    <message>
        <source>Copy or export it again, or save the array as NumPy&apos;s (.npy).</source>
        <translation>Kopieren oder exportieren Sie sie noch einmal, oder speichern Sie das Array im Format von NumPy (.npy).</translation>
    </message>
    <message>
        <source>Zarr, OME-Zarr (*.zarr zarr.json .zattrs .zgroup .zarray)</source>
        <translation>Zarr, OME-Zarr (*.zarr zarr.json .zattrs .zgroup .zarray)</translation>
    </message>
    <message>
        <source>Install the HDF5 library with &apos;apt install libhdf5-103-1&apos;.</source>
        <translation>Installieren Sie die HDF5-Bibliothek mit „apt install libhdf5-103-1“.</translation>
    </message>
    <message>
        <source>a MATLAB file older than version 7.3</source>
        <translation>eine MATLAB-Datei vor Version 7.3</translation>
    </message>
    <message>
        <source>Save the array with the option &apos;-v7.3&apos;, or as NIfTI, by niftiwrite().</source>
        <translation>Speichern Sie das Array mit der Option „-v7.3“ oder als NIfTI, mit niftiwrite().</translation>
    </message>
    <message>
        <source>The scale &apos;%1&apos; is not understood. Give &apos;linear&apos;, &apos;log&apos;, or &apos;log:&apos; and the positive number that replaces smaller values, as in log:1e-6.</source>
        <translation>Die Skala „%1“ ist nicht zu verstehen. Geben Sie „linear“, „log“ oder „log:“ mit der positiven Zahl an, als die kleinere Werte genommen werden, wie in log:1e-6.</translation>
    </message>
    <message>
        <source>None of the %1 values is positive, so they have no logarithms. Choose the linear scale.</source>
        <translation>Keiner der %1 Werte ist positiv, sie haben also keine Logarithmen. Nehmen Sie die lineare Skala.</translation>
    </message>
    <message>
        <source>No value is larger than %1, which is to replace smaller ones: the largest is %2. Give a smaller number.</source>
        <translation>Kein Wert ist größer als %1, die Zahl, als die kleinere Werte genommen werden sollen: Der größte ist %2. Geben Sie eine kleinere Zahl an.</translation>
    </message>
    <message>
        <source>%1 of %2 values are not positive, so they have no logarithm. The smallest positive value is %3: with the scale log:%3 smaller ones are replaced by that value.</source>
        <translation>%1 von %2 Werten sind nicht positiv, sie haben also keinen Logarithmus. Der kleinste positive Wert ist %3: Mit der Skala log:%3 werden kleinere als dieser Wert genommen.</translation>
    </message>
    <message>
        <source>%1 of %2 values are smaller than %3, and were replaced by %3.</source>
        <translation>%1 von %2 Werten sind kleiner als %3 und wurden als %3 genommen.</translation>
    </message>
    <message>
        <source>Not enough memory for the logarithms of the values. Take a part of the data.</source>
        <translation>Der Arbeitsspeicher reicht nicht für die Logarithmen der Werte. Nehmen Sie einen Teil der Daten.</translation>
    </message>
    <message>
        <source>error in the grid</source>
        <translation>Fehler im Gitter</translation>
    </message>
    <message>
        <source>error in space</source>
        <translation>Fehler im Raum</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>errors in the grid</source>
        <translation>Fehler im Gitter</translation>
    </message>
    <message>
        <source>errors in space</source>
        <translation>Fehler im Raum</translation>
    </message>
    <message>
        <source>Error in the grid</source>
        <translation>Fehler im Gitter</translation>
    </message>
    <message>
        <source>Error in space</source>
        <translation>Fehler im Raum</translation>
    </message>
    <message>
        <source>in the grid; in space it may be larger</source>
        <translation>im Gitter; im Raum kann er größer sein</translation>
    </message>
    <message>
        <source>in the grid and in space</source>
        <translation>im Gitter und im Raum</translation>
    </message>
    <message>
        <source>The guarantee is for the error in the grid; the error in space, at the place where you look, may be larger.</source>
        <translation>Garantiert ist der Fehler im Gitter; der Fehler im Raum, an dem Ort, auf den Sie blicken, kann größer sein.</translation>
    </message>
    <message>
        <source>The error in the grid and the error in space, at the place where you look, are both guaranteed at every accuracy; in a focus or a field, the error in the grid alone.</source>
        <translation>Der Fehler im Gitter und der Fehler im Raum, an dem Ort, auf den Sie blicken, sind beide bei jeder Genauigkeit garantiert; in einem Fokus oder einem Fehlerfeld nur der Fehler im Gitter.</translation>
    </message>
    <message>
        <source>&apos;tan verify&apos; measures the error in space.</source>
        <translation>„tan verify“ misst den Fehler im Raum.</translation>
    </message>
    <message>
        <source>The isovalue %1 is within the displayed error, %2, of the end of the data range, %3: what you see of its surface may be error alone.</source>
        <translation>Der Isowert %1 ist höchstens um den gezeigten Fehler, %2, vom Ende der Werte der Daten, %3, entfernt: Was von seiner Fläche zu sehen ist, kann bloßer Fehler sein.</translation>
    </message>
    <message>
        <source>The isovalue %1 is within the displayed error, %2, of %3, the value of most of the domain: what you see of its surface may be error alone.</source>
        <translation>Der Isowert %1 ist höchstens um den gezeigten Fehler, %2, von %3 entfernt, dem Wert des größten Teils des Gebiets: Was von seiner Fläche zu sehen ist, kann bloßer Fehler sein.</translation>
    </message>
    <message>
        <source>The transfer function shows values from %1 on, which is within the displayed error, %2, of %3, the value of most of the domain: what you see there may be error alone.</source>
        <translation>Die Transferfunktion zeigt Werte ab %1; das ist höchstens um den gezeigten Fehler, %2, von %3 entfernt, dem Wert des größten Teils des Gebiets: Was dort zu sehen ist, kann bloßer Fehler sein.</translation>
    </message>
    <message>
        <source>The values that the transfer function shows around %1 span less than the displayed error, %2: the mesh cannot distinguish them from others.</source>
        <translation>Der Bereich der Werte, den die Transferfunktion um %1 zeigt, ist schmaler als der gezeigte Fehler, %2: Das Netz kann diese Werte nicht von anderen unterscheiden.</translation>
    </message>
    <message>
        <source>Choose other values.</source>
        <translation>Wählen Sie andere Werte.</translation>
    </message>
    <message>
        <source>An error of at most %1 % would be enough, everywhere or for values near %2 alone.</source>
        <translation>Ein Fehler von höchstens %1 % würde genügen, überall oder nur für Werte nahe %2.</translation>
    </message>
    <message>
        <source>Lit</source>
        <translation>Beleuchtet</translation>
    </message>
    <message>
        <source>Lights surfaces in the colours of values, so that their shape is easier to see; their colours then differ from those of the colour bar.</source>
        <translation>Beleuchtet Flächen in den Farben von Werten, sodass ihre Form besser zu sehen ist; ihre Farben sind dann nicht mehr die der Farbskala.</translation>
    </message>
    <message>
        <source>The preset covers 0 to 1, and is stretched over the values of the data, %1 to %2.</source>
        <translation>Die Vorlage geht von 0 bis 1 und wird über die Werte der Daten gespreizt, %1 bis %2.</translation>
    </message>
    <message>
        <source>it has no time step at %1. The nearest one is number %2, at %3.</source>
        <translation>sie hat keinen Zeitschritt bei %1. Der nächstgelegene ist Nummer %2, bei %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;--time&apos; is not understood. Give the number of a time step, from 1, &apos;first&apos;, &apos;last&apos;, or a time, as in t=0.25.</source>
        <translation>„%1“ für „--time“ ist nicht zu verstehen. Geben Sie die Nummer eines Zeitschritts, ab 1, „first“, „last“ oder eine Zeit an, wie in t=0.25.</translation>
    </message>
    <message>
        <source>it has more time steps than can be listed. Give the number of one, from 1, for &apos;--time&apos;.</source>
        <translation>sie hat mehr Zeitschritte, als aufgelistet werden können. Geben Sie für „--time“ die Nummer eines davon an, ab 1.</translation>
    </message>
    <message>
        <source>it has one time step, and states no time. Leave &apos;--time&apos; out.</source>
        <translation>sie hat einen Zeitschritt und nennt keine Zeit. Lassen Sie „--time“ weg.</translation>
    </message>
    <message>
        <source>The series holds %1 volumes; the others are not read. Choose one with &apos;--time&apos;.</source>
        <translation>Die Serie enthält %1 Volumen; die anderen werden nicht gelesen. Wählen Sie eines mit „--time“.</translation>
    </message>
    <message>
        <source>It has %1 time steps; the others are not read. Choose one with &apos;--time&apos;.</source>
        <translation>Sie hat %1 Zeitschritte; die anderen werden nicht gelesen. Wählen Sie einen mit „--time“.</translation>
    </message>
    <message>
        <source>the array&apos;s dimensions are z, y, x</source>
        <translation>die Dimensionen des Arrays sind z, y, x</translation>
    </message>
    <message>
        <source>the array&apos;s dimensions are x, y, z</source>
        <translation>die Dimensionen des Arrays sind x, y, z</translation>
    </message>
    <message>
        <source>the array&apos;s dimensions are x, y, z; give &apos;--axes zyx&apos; if they are z, y, x, as in stacks of images</source>
        <translation>die Dimensionen des Arrays sind x, y, z; geben Sie „--axes zyx“ an, wenn sie z, y, x sind, wie die von Bildstapeln</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>NumPy arrays: whether they are indexed as array[x, y, z], or as array[z, y, x], as stacks of images by scikit-image, imageio and tifffile are.</source>
        <translation>NumPy-Arrays: ob sie als array[x, y, z] indiziert sind oder als array[z, y, x], wie Bildstapel von scikit-image, imageio und tifffile.</translation>
    </message>
    <message>
        <source>&apos;--%1&apos; says how a NumPy array is indexed, and &apos;%2&apos; is not one. Leave it out.</source>
        <translation>„--%1“ sagt, wie ein NumPy-Array indiziert ist, und „%2“ ist keines. Lassen Sie die Option weg.</translation>
    </message>
    <message>
        <source>Its values &apos;%1&apos; at the corners of elements are not read: elements that share a node may have different ones there.</source>
        <translation>Ihre Werte „%1“ an den Ecken von Elementen werden nicht gelesen: Elemente, die einen Knoten gemeinsam haben, können dort verschiedene haben.</translation>
    </message>
    <message>
        <source>None of the isovalues lies within the model&apos;s values, %1 to %2, so their surfaces are empty.</source>
        <translation>Keiner der Isowerte liegt innerhalb der Werte des Modells, %1 bis %2, daher sind ihre Flächen leer.</translation>
    </message>
    <message>
        <source>Only curvilinear grids can be decimated in one space or the other, and &apos;%1&apos; is not one.</source>
        <translation>Nur krummlinige Gitter können in dem einen oder dem anderen Raum vergröbert werden, und „%1“ ist keines.</translation>
    </message>
    <message>
        <source>The grid &apos;%1&apos; cannot be used as a mesh: %2 Refine it instead.</source>
        <translation>Das Gitter „%1“ kann nicht als Netz genommen werden: %2 Verfeinern Sie es stattdessen.</translation>
    </message>
    <message>
        <source>The grid has %1 cells, whose mesh takes up to %2 of memory, of %3. Refine it instead, or take a region of it or fewer samples.</source>
        <translation>Das Gitter hat %1 Zellen, deren Netz bis zu %2 Speicher braucht, von %3. Verfeinern Sie es stattdessen, oder nehmen Sie einen Teil davon oder weniger Abtastwerte.</translation>
    </message>
    <message>
        <source>%1 of its points lie at the same place as another and have another value.</source>
        <translation>%1 seiner Punkte liegen am Ort eines anderen und haben einen anderen Wert.</translation>
    </message>
    <message>
        <source>%1 of its cells are folded, overlap others, or are so warped that no tetrahedra fill them.</source>
        <translation>%1 seiner Zellen sind gefaltet, überlappen andere oder sind so verzogen, dass keine Tetraeder sie füllen.</translation>
    </message>
    <message>
        <source>%1 of its points belong only to cells without volume.</source>
        <translation>%1 seiner Punkte gehören nur zu Zellen ohne Volumen.</translation>
    </message>
    <message>
        <source>it has %1 points, and the limit is %2.</source>
        <translation>es hat %1 Punkte, und höchstens %2 sind möglich.</translation>
    </message>
    <message>
        <source>%1 corners of its cells are folded.</source>
        <translation>%1 Ecken seiner Zellen sind gefaltet.</translation>
    </message>
    <message>
        <source>For grids whose points lie anywhere: &apos;physical&apos; builds where they lie, by decimation from the mesh of the grid&apos;s cells, or by refinement (of rectilinear grids) from the points alone; &apos;computational&apos; by their indices, as the paper did, which takes less memory and supports blocks.</source>
        <translation>Für Gitter, deren Punkte irgendwo liegen: „im physikalischen Raum“ baut dort, wo sie liegen, durch Vergröberung aus dem Netz der Zellen des Gitters, durch Verfeinerung (von rechtwinkligen Gittern) aus den Punkten allein; „im Rechenraum“ nach ihren Indizes, wie im Aufsatz, was weniger Speicher braucht und Blöcke erlaubt.</translation>
    </message>
    <message>
        <source>A curvilinear grid: decimation uses the mesh of its cells, and needs the fewest tetrahedra for an error in space, where the points lie.</source>
        <translation>Ein krummliniges Gitter: Die Vergröberung nimmt das Netz seiner Zellen und braucht die wenigsten Tetraeder für einen Fehler im Raum, also dort, wo die Punkte liegen.</translation>
    </message>
    <message>
        <source>For curvilinear data: &apos;grid&apos; keeps the error in the grid, at the points&apos; indices, as the paper did; &apos;space&apos; also the error in space, where the points lie, which is what you see. That takes more vertices and time, and the whole grid in memory. &apos;automatic&apos; keeps both for grids of up to a million points that are refined as a whole, using both thresholds.</source>
        <translation>Für krummlinige Daten: „im Gitter“ hält den Fehler im Gitter ein, bei den Indizes der Punkte, wie im Aufsatz; „im Raum“ auch den Fehler im Raum, dort, wo die Punkte liegen, also den, den Sie sehen. Das braucht mehr Knoten und Zeit und das ganze Gitter im Speicher. „automatisch“ hält beide bei Gittern bis zu einer Million Punkten ein, die als Ganzes und nach beiden Schwellen verfeinert werden.</translation>
    </message>
    <message>
        <source>A curvilinear grid: refinement in computational space bounds the error in the grid and the warping, even where cells of the grid are folded, and can bound the error in space.</source>
        <translation>Ein krummliniges Gitter: Die Verfeinerung im Rechenraum begrenzt den Fehler im Gitter und die Verwerfung, auch wo Zellen des Gitters gefaltet sind, und kann den Fehler im Raum begrenzen.</translation>
    </message>
    <message>
        <source>it is a list of EnSight cases, which VTK 9.1 does not read. Open one of the cases that it names.</source>
        <translation>es ist eine Liste von EnSight-Fällen, die VTK 9.1 nicht liest. Öffnen Sie einen der Fälle, die sie nennt.</translation>
    </message>
    <message>
        <source>its files refer to each other more than %1 levels deep.</source>
        <translation>ihre Dateien nennen einander mehr als %1 Ebenen tief.</translation>
    </message>
    <message>
        <source>it refers to the file &apos;%1&apos;, which refers back to it.</source>
        <translation>sie nennt die Datei „%1“, die wiederum sie nennt.</translation>
    </message>
    <message>
        <source>it lists the file &apos;%1&apos; twice for one time. Write each part once.</source>
        <translation>sie nennt die Datei „%1“ zweimal für einen Zeitpunkt. Schreiben Sie jeden Teil einmal.</translation>
    </message>
    <message>
        <source>its chunks were passed through %1 codecs, more than %2</source>
        <translation>ihre Stücke (Chunks) gingen durch %1 Codecs, mehr als %2</translation>
    </message>
    <message>
        <source>the values of one of its arrays lie in other files or arrays, which are not opened. Copy them into an array of their own, for instance with h5py.</source>
        <translation>die Werte eines ihrer Arrays liegen in anderen Dateien oder Arrays, die nicht geöffnet werden. Kopieren Sie sie in ein eigenes Array, zum Beispiel mit h5py.</translation>
    </message>
    <message>
        <source>xyz</source>
        <translation>xyz</translation>
    </message>
    <message>
        <source>zyx</source>
        <translation>zyx</translation>
    </message>
    <message>
        <source>%1 or a comment before it is longer than %2 bytes, so this is not a table of points.</source>
        <translation>%1 oder ein Kommentar davor ist länger als %2 Bytes und so nicht aus einer Tabelle von Punkten.</translation>
    </message>
    <message>
        <source>%1 has %2 columns, and at most %3 are read. Write a file with only the columns of positions and values that you need.</source>
        <translation>%1 hat %2 Spalten, und höchstens %3 werden gelesen. Schreiben Sie eine Datei aus den Spalten der Orte und Werte, die Sie brauchen.</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>eine Zahl über 0</translation>
    </message>
    <message>
        <source>a factor of %1</source>
        <translation>Faktor %1</translation>
    </message>
    <message>
        <source>HDF5 (*.h5 *.hdf5 *.hdf *.he5 *.nxs *.nx5 *.mat *.ims)</source>
        <translation>HDF5 (*.h5 *.hdf5 *.hdf *.he5 *.nxs *.nx5 *.mat *.ims)</translation>
    </message>
    <message>
        <source>&apos;ExtMin&apos; and &apos;ExtMax&apos; of Imaris</source>
        <translation>„ExtMin“ und „ExtMax“ von Imaris</translation>
    </message>
    <message>
        <source>It has %1 levels of detail, 0 being the finest; the others are not read. Choose one by its array, such as &apos;%2&apos;.</source>
        <translation>Sie hat %1 Detailstufen, von denen 0 die feinste ist; die anderen werden nicht gelesen. Wählen Sie eine durch ihr Feld, etwa „%2“.</translation>
    </message>
    <message>
        <source>%1 has values whose closing bracket directly follows the last one, of which VTK then drops a digit. Put an end of line before the bracket, or export the file again.</source>
        <translation>%1 hat Werte, deren Klammer gleich hinter dem letzten steht, von dem VTK dann eine Ziffer auslässt. Setzen Sie ein Zeilenende vor die Klammer, oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>it lists %1 files %2 times in all.</source>
        <translation>sie nennt %1 Dateien insgesamt %2 Mal.</translation>
    </message>
    <message>
        <source>names more than %1 variables. Take out those that are not needed.</source>
        <translation>nennt mehr als %1 Variablen. Nehmen Sie die heraus, die nicht gebraucht werden.</translation>
    </message>
    <message>
        <source>it has more than %1 zones. Write files of fewer zones.</source>
        <translation>Sie hat mehr als %1 Zonen. Schreiben Sie Dateien mit weniger Zonen.</translation>
    </message>
    <message>
        <source>Its chunks are unpacked whole, however little of them is needed, which takes %1 MB of memory.</source>
        <translation>Seine Stücke (Chunks) werden ganz entpackt, so wenig auch von ihnen gebraucht wird; das braucht %1 MB Speicher.</translation>
    </message>
    <message>
        <source>its model cannot have %1 bytes</source>
        <translation>sein Modell kann nicht %1 Bytes haben</translation>
    </message>
    <message>
        <source>It is written for plugin interface %1 of an earlier TAn, and this program has %2. Install a newer version of the plugin, or build it again with the headers of this TAn.</source>
        <translation>Es ist für die Plugin-Schnittstelle %1 eines früheren TAn geschrieben, und dieses Programm hat %2. Installieren Sie eine neuere Version des Plugins, oder bauen Sie es mit den Headern dieses TAn neu.</translation>
    </message>
    <message>
        <source>It was built for an earlier version of TAn. Install a later version of the plugin, or build it again with the headers of this TAn.</source>
        <translation>Es wurde für eine frühere Version von TAn gebaut. Installieren Sie eine neuere Version des Plugins, oder bauen Sie es mit den Headern dieses TAn neu.</translation>
    </message>
    <message>
        <source>it is not a shared library for this machine.</source>
        <translation>Es ist keine gemeinsam genutzte Bibliothek für diesen Rechner.</translation>
    </message>
    <message>
        <source>it ends too early.</source>
        <translation>Es endet zu früh.</translation>
    </message>
    <message>
        <source>Its metadata are malformed: %1 Ask the plugin&apos;s author for a fixed version.</source>
        <translation>Seine Metadaten sind fehlerhaft: %1 Bitten Sie den Autor des Plugins um eine berichtigte Version.</translation>
    </message>
    <message>
        <source>its metadata are damaged.</source>
        <translation>Seine Metadaten sind beschädigt.</translation>
    </message>
    <message>
        <source>it has no metadata.</source>
        <translation>Es hat keine Metadaten.</translation>
    </message>
    <message>
        <source>The view cannot be read: %1</source>
        <translation>Die Ansicht kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>it must be an object, in braces.</source>
        <translation>sie muss ein Objekt sein, in geschweiften Klammern.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a plane: give x, y or z and a position, as in z=12.5, or nx,ny,nz,offset for the points with nx x + ny y + nz z = offset, the first three not all zero.</source>
        <translation>„%1“ ist keine Ebene: Geben Sie x, y oder z mit einer Stelle an, wie z=12.5, oder nx,ny,nz,Abstand für die Punkte mit nx x + ny y + nz z = Abstand, die ersten drei nicht alle null.</translation>
    </message>
    <message>
        <source>The plane &apos;%1&apos; misses the data, which extend from %2 to %3 in its direction.</source>
        <translation>Die Ebene „%1“ trifft die Daten nicht, die in ihrer Richtung von %2 bis %3 reichen.</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Which value along each line of sight is shown: the largest (&apos;maximum&apos;) or the smallest (&apos;minimum&apos;).</source>
        <translation>Welcher Wert entlang jeder Sichtlinie gezeigt wird: der größte („Maximum“) oder der kleinste („Minimum“).</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>deckend</translation>
    </message>
    <message>
        <source>function</source>
        <translation>Funktion</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The axis perpendicular to the plane; &apos;all&apos; shows three planes, one for each axis.</source>
        <translation>Die Achse, zu der die Ebene senkrecht steht; „alle“ zeigt drei Ebenen, eine zu jeder.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Where the plane lies along its axis: 0 where the data begin, 100 where they end.</source>
        <translation>Wo die Ebene entlang ihrer Achse liegt: bei 0, wo die Daten beginnen, bei 100, wo sie enden.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Planes instead of those perpendicular to the axes: each by its axis and its position in the coordinates of the data, as in z=12.5, or in any direction: nx,ny,nz,offset, for the points with nx x + ny y + nz z = offset.</source>
        <translation>Ebenen anstelle derer zu den Achsen: jede durch ihre Achse und ihre Stelle in den Koordinaten der Daten, wie z=12.5, oder in beliebiger Richtung: nx,ny,nz,Abstand, für die Punkte mit nx x + ny y + nz z = Abstand.</translation>
    </message>
    <message>
        <source>Whether slices hide what is behind them (&apos;opaque&apos;), or each value is as opaque as the transfer &apos;function&apos; makes a layer of its unit of thickness.</source>
        <translation>Ob Schnitte verdecken, was dahinter liegt („deckend“), oder jeder Wert so deckend ist, wie die Transferfunktion („Funktion“) eine Schicht der Einheitsdicke macht.</translation>
    </message>
    <message>
        <source>The slices have their default position: the saved ones are for another domain.</source>
        <translation>Die Schnitte sind wie am Anfang: ihre Ebenen gehören zu einem anderen Gebiet.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>%1 %2 at the target</source>
        <translation>%1 %2 am Blickziel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>1 unit at the target</source>
        <translation>1 Einheit am Blickziel</translation>
    </message>
    <message>
        <source>1 unit</source>
        <translation>1 Einheit</translation>
    </message>
    <message>
        <source>%1 units at the target</source>
        <translation>%1 Einheiten am Blickziel</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 Einheiten</translation>
    </message>
    <message>
        <source>This system has no font to write into pictures. Install one, such as the package fonts-dejavu-core of Debian, or take the picture without annotations.</source>
        <translation>Dieses System hat keine Schriftart, mit der in Bilder geschrieben werden kann. Installieren Sie eine, etwa das Paket fonts-dejavu-core von Debian, oder machen Sie das Bild ohne Beschriftung.</translation>
    </message>
    <message>
        <source>No renderer plugin could be loaded, so there is no way to show a model. %1</source>
        <translation>Kein Plugin zur Darstellung konnte geladen werden; so lässt sich kein Modell zeigen. %1</translation>
    </message>
    <message>
        <source>There is no frame %1 in this film, which has %2 of them.</source>
        <translation>Dieser Film hat kein Bild %1; es sind %2.</translation>
    </message>
    <message>
        <source>%1 %2 in the focus, %3 outside</source>
        <translation>%1 %2 im Fokus, %3 außerhalb</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 bis %3</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1, in space up to %2</source>
        <translation>%1, im Raum bis %2</translation>
    </message>
    <message>
        <source>%1 (in space up to %2)</source>
        <translation>%1 (im Raum bis %2)</translation>
    </message>
    <message>
        <source>What tools have in the picture is left out: it is for another domain.</source>
        <translation>Was Werkzeuge im Bild haben, wird weggelassen: Es gilt für ein anderes Gebiet.</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>&quot;kind&quot; is &quot;%1&quot;, which is not one of builder, renderer, reader, writer, editor, tool</source>
        <translation>„kind“ ist „%1“, und das ist keines von builder, renderer, reader, writer, editor und tool</translation>
    </message>
    <message>
        <source>what it keeps is too long</source>
        <translation>was es behalten will, ist zu lang</translation>
    </message>
    <message>
        <source>what it keeps is no text</source>
        <translation>was es behalten will, ist kein Text</translation>
    </message>
    <message>
        <source>Clip plane</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Move Plane</source>
        <translation>Ebene bewegen</translation>
    </message>
    <message>
        <source>Turn Plane</source>
        <translation>Ebene drehen</translation>
    </message>
    <message>
        <source>This rendering mode has neither clip planes nor slices.</source>
        <translation>Diese Darstellungsart hat weder Schnittebenen noch Schnitte.</translation>
    </message>
    <message>
        <source>Centre of the plane</source>
        <translation>Mitte der Ebene</translation>
    </message>
    <message>
        <source>Direction of the plane</source>
        <translation>Richtung der Ebene</translation>
    </message>
    <message>
        <source>Add Plane</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>What is moved: a plane that cuts the picture open, or one that shows the data.</source>
        <translation>Was bewegt wird: eine Ebene, die das Bild aufschneidet, oder eine, die die Daten zeigt.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Which of the planes is moved.</source>
        <translation>Welche der Ebenen bewegt wird.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Across the plane, along x, y and z; of a clip plane towards what is shown.</source>
        <translation>Senkrecht zur Ebene, entlang x, y und z; bei einer Schnittebene zu dem hin, was gezeigt wird.</translation>
    </message>
    <message>
        <source>Place along it</source>
        <translation>Stelle entlang der Richtung</translation>
    </message>
    <message>
        <source>How far the plane lies from the origin in its direction, in the data&apos;s unit of length.</source>
        <translation>Wie weit die Ebene in ihrer Richtung vom Ursprung entfernt liegt, in der Längeneinheit der Daten.</translation>
    </message>
    <message>
        <source>Choose Plane</source>
        <translation>Ebene wählen</translation>
    </message>
    <message>
        <source>Cut through the middle of the data, across the axis that one looks along</source>
        <translation>Durch die Mitte der Daten schneiden, quer zu der Achse, entlang der man blickt</translation>
    </message>
    <message>
        <source>Flip Plane</source>
        <translation>Ebene umkehren</translation>
    </message>
    <message>
        <source>Show what was cut away, and cut away what was shown</source>
        <translation>Zeigen, was abgeschnitten war, und abschneiden, was gezeigt wurde</translation>
    </message>
    <message>
        <source>Align with Axis</source>
        <translation>An Achse ausrichten</translation>
    </message>
    <message>
        <source>Turn the plane across the nearest axis; Shift does so while it is turned</source>
        <translation>Die Ebene quer zur nächsten Achse drehen; beim Drehen tut das die Umschalttaste</translation>
    </message>
    <message>
        <source>Remove Plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Remove the plane that is moved</source>
        <translation>Die Ebene entfernen, die bewegt wird</translation>
    </message>
    <message>
        <source>%1 units of the file</source>
        <translation>%1 Einheiten der Datei</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Place %1 of ruler %2</source>
        <translation>Stelle %1 von Lineal %2</translation>
    </message>
    <message>
        <source>Measure Distance</source>
        <translation>Abstand messen</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>Winkel messen</translation>
    </message>
    <message>
        <source>Move Ruler</source>
        <translation>Lineal bewegen</translation>
    </message>
    <message>
        <source>Ruler %1</source>
        <translation>Lineal %1</translation>
    </message>
    <message>
        <source>%1 and %2, %3 between them</source>
        <translation>%1 und %2, dazwischen %3</translation>
    </message>
    <message>
        <source>New Ruler</source>
        <translation>Neues Lineal</translation>
    </message>
    <message>
        <source>Begin another ruler at the next click, without an angle</source>
        <translation>Beim nächsten Klick ein weiteres Lineal beginnen, ohne Winkel</translation>
    </message>
    <message>
        <source>Remove Ruler</source>
        <translation>Lineal entfernen</translation>
    </message>
    <message>
        <source>Remove the selected ruler, or else the last one</source>
        <translation>Das gewählte Lineal entfernen, sonst das letzte</translation>
    </message>
    <message>
        <source>Remove All Rulers</source>
        <translation>Alle Lineale entfernen</translation>
    </message>
    <message>
        <source>Remove all rulers from the picture</source>
        <translation>Alle Lineale aus dem Bild entfernen</translation>
    </message>
    <message>
        <source>Remove Rulers</source>
        <translation>Lineale entfernen</translation>
    </message>
    <message>
        <source>Complete Ruler</source>
        <translation>Lineal abschließen</translation>
    </message>
    <message>
        <source>Opacity of the boundary</source>
        <translation>Deckkraft der Berandung</translation>
    </message>
    <message>
        <source>The setting &apos;%1&apos; cannot be used: %2</source>
        <translation>Die Einstellung „%1“ ist nicht verwendbar: %2</translation>
    </message>
    <message>
        <source>its table for the loader is damaged.</source>
        <translation>Seine Tabelle für den Lader ist beschädigt.</translation>
    </message>
    <message>
        <source>It has no function %1, so it is not a complete plugin. Install it again, or ask its author for a complete one.</source>
        <translation>Es hat keine Funktion %1, ist also kein vollständiges Plugin. Installieren Sie es noch einmal, oder bitten Sie seinen Autor um ein vollständiges.</translation>
    </message>
    <message>
        <source>Some values of the model are not finite numbers, so no largest or smallest one can be shown. Choose another mode.</source>
        <translation>Manche Werte des Modells sind keine endlichen Zahlen, darum lässt sich kein größter oder kleinster zeigen. Wählen Sie einen anderen Modus.</translation>
    </message>
    <message>
        <source>Opacity of slices</source>
        <translation>Deckkraft der Schnitte</translation>
    </message>
    <message>
        <source>The table of an optical model has %1 entries; at most %2 can be used.</source>
        <translation>Die Tabelle eines optischen Modells hat %1 Einträge; höchstens %2 können verwendet werden.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; has an optical model with a table of %2 entries; at most %3 can be used. This is a fault of the plugin; tell its author.</source>
        <translation>Das Plugin „%1“ hat ein optisches Modell mit einer Tabelle aus %2 Einträgen; höchstens %3 können verwendet werden. Das ist ein Fehler des Plugins; sagen Sie es seinem Autor.</translation>
    </message>
    <message>
        <source>Points that the moved boundary leaves outside the mesh are compared with a place within the warping; at the nearest place they may be off by more, which &apos;tan verify&apos; measures.</source>
        <translation>Punkte, die der verschobene Rand außerhalb des Netzes lässt, werden mit einer Stelle innerhalb der Verwerfung verglichen; an der nächsten Stelle können sie um mehr abweichen, was „tan verify“ misst.</translation>
    </message>
    <message>
        <source>Between vertices interpolate &apos;%1&apos;, and take the power of ten afterwards: the factor holds for that. &apos;%2&apos;, interpolated itself, may be off by much more.</source>
        <translation>Interpolieren Sie zwischen Eckpunkten „%1“ und nehmen Sie danach die Zehnerpotenz: dafür gilt der Faktor. „%2“, selbst interpoliert, kann um viel mehr abweichen.</translation>
    </message>
    <message>
        <source>The model has no finer mesh than this, which keeps less than requested.</source>
        <translation>Das Modell hat kein feineres Netz als dieses, das weniger einhält als verlangt.</translation>
    </message>
    <message>
        <source>Lights the volume as if a surface lay perpendicular to the direction in which its values change most; the background is then dark, unless you choose another one.</source>
        <translation>Beleuchtet das Volumen, als läge eine Fläche quer zu der Richtung, in der sich seine Werte am stärksten ändern; der Hintergrund ist dann dunkel, sofern Sie keinen anderen wählen.</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Flesh</source>
        <translation>Fleisch</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Stein</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Kreide</translation>
    </message>
    <message>
        <source>1 point belongs to no cell with a volume and was left out.</source>
        <translation>1 Punkt gehört zu keiner Zelle mit einem Volumen und wurde weggelassen.</translation>
    </message>
    <message>
        <source>%1 points belong to no cell with a volume and were left out.</source>
        <translation>%1 Punkte gehören zu keiner Zelle mit einem Volumen und wurden weggelassen.</translation>
    </message>
    <message>
        <source>Cells have a corner whose position is not finite, or too large to compute with (%1 in all, the first is cell %2). Correct the points, or blank the cells.</source>
        <translation>Zellen haben eine Ecke, deren Ort nicht endlich oder zu groß zum Rechnen ist (%1 insgesamt, die erste ist Zelle %2). Korrigieren Sie die Punkte, oder blenden Sie die Zellen aus.</translation>
    </message>
    <message>
        <source>The mesh does not have a finite value for each point, and a finite position that is not too large to compute with.</source>
        <translation>Das Netz hat nicht für jeden Punkt einen endlichen Wert und eine endliche Position, die nicht zu groß zum Rechnen ist.</translation>
    </message>
    <message>
        <source>more than %1 pairs of tetrahedra that overlap, one at %2</source>
        <translation>mehr als %1 Paare sich überlappender Tetraeder, eines bei %2</translation>
    </message>
    <message>
        <source>the first axis, of %1 points; if it holds colours, the header has to say so (&apos;kinds: RGB-color domain domain&apos;)</source>
        <translation>die erste Achse mit %1 Punkten; wenn sie Farben enthält, muss der Kopf es sagen („kinds: RGB-color domain domain“)</translation>
    </message>
    <message>
        <source>it is not a PLOT3D file: it does not begin with the sizes of its grids. If it is of another program, export VTK, or a table of points with values.</source>
        <translation>Sie ist keine PLOT3D-Datei: Sie beginnt nicht mit den Größen ihrer Gitter. Ist sie von einem anderen Programm, exportieren Sie VTK oder eine Tabelle von Punkten mit Werten.</translation>
    </message>
    <message>
        <source>it has no array with a number for each point or cell. Write it with one, of points or cells that fill a volume.</source>
        <translation>Sie hat kein Feld mit einer Zahl für jeden Punkt oder jede Zelle. Schreiben Sie sie mit einem, von Punkten oder Zellen, die ein Volumen füllen.</translation>
    </message>
    <message>
        <source>Its units are not known: it has too many nodes to be looked at, or not those that CGNS&apos;s library writes.</source>
        <translation>Ihre Einheiten sind nicht bekannt: Sie hat zu viele Knoten zum Nachsehen, oder andere, als die Bibliothek von CGNS schreibt.</translation>
    </message>
    <message>
        <source>All points of &apos;%1&apos; lie in a plane, or there are fewer than four. TAn needs points that have a volume between them.</source>
        <translation>Alle Punkte von „%1“ liegen in einer Ebene, oder es sind weniger als vier. TAn braucht Punkte, zwischen denen ein Volumen liegt.</translation>
    </message>
    <message>
        <source>The preset is for Hounsfield units, and the values are assumed to be these: they are whole numbers from %1 to %2.</source>
        <translation>Die Vorlage ist für Hounsfield-Einheiten, und es wird angenommen, dass die Werte solche sind: Sie sind ganze Zahlen von %1 bis %2.</translation>
    </message>
    <message>
        <source>The preset is for Hounsfield units, which the data do not seem to have: it is stretched over their values, %1 to %2, as if these were -1024 to 3071.</source>
        <translation>Die Vorlage ist für Hounsfield-Einheiten, die die Daten nicht zu haben scheinen: Sie wird über deren Werte, %1 bis %2, gestreckt, als wären diese -1024 bis 3071.</translation>
    </message>
    <message>
        <source>This TAn was built without cairo, which writes PDF files. Save the picture as PNG.</source>
        <translation>Dieses TAn wurde ohne cairo gebaut, das PDF-Dateien schreibt. Speichern Sie das Bild als PNG.</translation>
    </message>
    <message>
        <source>The picture cannot be written as a PDF file: %1.</source>
        <translation>Das Bild kann nicht als PDF-Datei geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>JPEG pictures have no transparency. Save it as PNG, TIFF or PDF, or with a background.</source>
        <translation>JPEG-Bilder können nicht durchsichtig sein. Speichern Sie es als PNG, TIFF oder PDF oder mit einem Hintergrund.</translation>
    </message>
    <message>
        <source>This TAn was built without libjpeg, which writes JPEG files. Save the picture as PNG.</source>
        <translation>Dieses TAn wurde ohne libjpeg gebaut, das JPEG-Dateien schreibt. Speichern Sie das Bild als PNG.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not end in .png, .tif, .tiff, .jpg, .jpeg or .pdf, the formats in which pictures are written.</source>
        <translation>„%1“ endet nicht auf .png, .tif, .tiff, .jpg, .jpeg oder .pdf, die Formate, in denen Bilder geschrieben werden.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written: this TAn was built without the library for its format. Save the picture as PNG.</source>
        <translation>„%1“ kann nicht geschrieben werden: Dieses TAn wurde ohne die Bibliothek für das Format gebaut. Speichern Sie das Bild als PNG.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be transparent, as JPEG pictures have no transparency. Save it as PNG, TIFF or PDF, or with a background.</source>
        <translation>„%1“ kann nicht durchsichtig sein, da JPEG-Bilder keine Durchsichtigkeit haben. Speichern Sie es als PNG, TIFF oder PDF oder mit einem Hintergrund.</translation>
    </message>
    <message>
        <source>This TAn was built without libtiff, which writes TIFF files. Save the picture as PNG.</source>
        <translation>Dieses TAn wurde ohne libtiff gebaut, das TIFF-Dateien schreibt. Speichern Sie das Bild als PNG.</translation>
    </message>
    <message>
        <source>All its points lie in a plane: there is no volume between them, and no model can be built of them.</source>
        <translation>Alle Punkte liegen in einer Ebene: Zwischen ihnen ist kein Volumen, und es kann kein Modell aus ihnen gebaut werden.</translation>
    </message>
    <message>
        <source>Reading the data</source>
        <translation>Die Daten werden gelesen</translation>
    </message>
    <message>
        <source>The data of &apos;%1&apos; cannot be shown: %2 Put the file from which the model was built, &apos;%3&apos;, beside the model.</source>
        <translation>Die Daten von „%1“ können nicht gezeigt werden: %2 Legen Sie die Datei, aus der das Modell gebaut wurde, „%3“, neben das Modell.</translation>
    </message>
    <message>
        <source>the model holds %1 of the %2 samples.</source>
        <translation>Das Modell enthält %1 der %2 Abtastwerte.</translation>
    </message>
    <message>
        <source>the file of that name beside it contains other values.</source>
        <translation>Die Datei dieses Namens daneben enthält andere Werte.</translation>
    </message>
    <message>
        <source>Not enough memory to show the data beside the mesh. Close other programs.</source>
        <translation>Nicht genug Arbeitsspeicher, um die Daten neben dem Netz zu zeigen. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Only the samples of a lattice can be shown beside the mesh, and these data are %1.</source>
        <translation>Nur die Abtastwerte eines regelmäßigen Gitters können neben dem Netz gezeigt werden, und diese Daten sind %1.</translation>
    </message>
    <message>
        <source>OpenGL does not draw the samples of a lattice, nor differences to them. Let the CPU draw this picture.</source>
        <translation>OpenGL zeichnet weder die Abtastwerte eines regelmäßigen Gitters noch Unterschiede zu ihnen. Lassen Sie den Prozessor dieses Bild zeichnen.</translation>
    </message>
    <message>
        <source>Preparing the data</source>
        <translation>Die Daten werden vorbereitet</translation>
    </message>
    <message>
        <source>Only the samples of a whole lattice can be shown beside the mesh.</source>
        <translation>Nur die Abtastwerte eines ganzen regelmäßigen Gitters können neben dem Netz gezeigt werden.</translation>
    </message>
    <message>
        <source>The samples of the scene and their transfer function do not belong together.</source>
        <translation>Die Abtastwerte der Szene und ihre Transferfunktion gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>the data themselves</source>
        <translation>die Daten selbst</translation>
    </message>
    <message>
        <source>difference to the data, %1 times as bright, of a mesh with %2</source>
        <translation>Unterschied zu den Daten, %1-mal so hell, eines Netzes mit %2</translation>
    </message>
    <message>
        <source>All values are the same, so there are no standard deviations. Give a value of the data.</source>
        <translation>Alle Werte sind gleich, daher gibt es keine Standardabweichungen. Geben Sie einen Wert der Daten an.</translation>
    </message>
    <message>
        <source>The model is at its server and keeps no mean and no standard deviation of its values, as those of density maps do. Give a value of the data.</source>
        <translation>Das Modell liegt auf seinem Server und enthält weder Mittelwert noch Standardabweichung seiner Werte, wie es die von Dichtekarten tun. Geben Sie einen Wert der Daten an.</translation>
    </message>
    <message>
        <source>Not enough memory for the mean of the values. Give a value of the data.</source>
        <translation>Der Speicher reicht nicht für den Mittelwert der Werte. Geben Sie einen Wert der Daten an.</translation>
    </message>
    <message>
        <source>What the volume is drawn from: the mesh; the samples of the data themselves, so that you see what the mesh leaves out; or the difference between the two pictures, made brighter. A moving picture always shows the mesh, and so does one with a focus, a crop box, a filter of values or a range of accuracies.</source>
        <translation>Woraus das Volumen gezeichnet wird: aus dem Netz; aus den Abtastwerten der Daten selbst, sodass Sie sehen, was das Netz weglässt; oder der Unterschied zwischen den beiden Bildern, aufgehellt. Ein bewegtes Bild zeigt immer das Netz, ebenso eines mit einem Fokus, einem Fenster, einem Bereich von Werten oder einem Bereich von Genauigkeiten.</translation>
    </message>
    <message>
        <source>%1; data are not shown with a range of accuracies</source>
        <translation>%1; mit einem Bereich von Genauigkeiten werden keine Daten gezeigt</translation>
    </message>
    <message>
        <source>%1; data are not shown with a crop box</source>
        <translation>%1; mit einem Fenster werden keine Daten gezeigt</translation>
    </message>
    <message>
        <source>%1; data are not shown with a filter of values</source>
        <translation>%1; mit einem Bereich von Werten werden keine Daten gezeigt</translation>
    </message>
    <message>
        <source>%1; data are not shown with a focus</source>
        <translation>%1; mit einem Fokus werden keine Daten gezeigt</translation>
    </message>
    <message>
        <source>Full opacity at gradient</source>
        <translation>Volle Deckkraft ab Gradient</translation>
    </message>
    <message>
        <source>Of a shaded volume, how steeply the values must change, in units of the values for one of length, to be as opaque as the transfer function says; where they change less, the opacity is less in proportion, so that boundaries stand out. 0: the opacity does not depend on it.</source>
        <translation>Wie steil sich die Werte eines beleuchteten Volumens ändern müssen, in Einheiten der Werte je Längeneinheit, um so deckend zu sein, wie die Transferfunktion sagt; wo sie sich weniger ändern, ist die Deckkraft im selben Verhältnis geringer, sodass Grenzen hervortreten. 0: Die Deckkraft hängt davon nicht ab.</translation>
    </message>
    <message>
        <source>%1 of %2 bookmarks cannot be shown as they were saved.</source>
        <translation>%1 von %2 Lesezeichen können nicht so gezeigt werden, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>The look is one of &apos;%1&apos;, and these values are &apos;%2&apos;: title and names are left out, and colours and isovalues are spread over the range of these.</source>
        <translation>Das Aussehen ist eines von „%1“, und diese Werte sind „%2“: Titel und Namen werden weggelassen, Farben und Isowerte über den Bereich dieser Werte gespreizt.</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isoflächen</translation>
    </message>
    <message>
        <source>Shows the isosurfaces beside the slices.</source>
        <translation>Zeigt neben den Schnitten die Isoflächen.</translation>
    </message>
    <message>
        <source>its meshes do not grow with their accuracy</source>
        <translation>seine Netze wachsen nicht mit ihrer Genauigkeit</translation>
    </message>
    <message>
        <source>work files %1</source>
        <translation>Arbeitsdateien %1</translation>
    </message>
    <message>
        <source>A build is cut into parts where its blocks are. Choose the edge of a block, such as 32 cells.</source>
        <translation>Ein Bau wird an seinen Blöcken geteilt. Wählen Sie die Kantenlänge eines Blocks, etwa 32 Zellen.</translation>
    </message>
    <message>
        <source>Waiting for part %1</source>
        <translation>Warte auf Teil %1</translation>
    </message>
    <message>
        <source>Part %1 of %2 has done what it can until part %3 has found out what it needs of their common faces. Start it again after that: it goes on from here.</source>
        <translation>Teil %1 von %2 hat getan, was er kann, bis Teil %3 herausgefunden hat, was er an den gemeinsamen Flächen braucht. Starten Sie ihn danach noch einmal: Er macht von hier an weiter.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another build: of other data, with other options, or by another version of TAn. Remove it, or choose another folder.</source>
        <translation>„%1“ gehört zu einem anderen Bau: mit anderen Daten, mit anderen Optionen oder von einer anderen Version von TAn. Entfernen Sie die Datei, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Checking what is done already</source>
        <translation>Prüfe, was schon fertig ist</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged. Build that part again: it keeps what is whole.</source>
        <translation>„%1“ ist beschädigt. Bauen Sie diesen Teil noch einmal: Was unversehrt ist, bleibt erhalten.</translation>
    </message>
    <message>
        <source>No part of the build in &apos;%1&apos; is finished yet.</source>
        <translation>Noch ist kein Teil des Baus in „%1“ fertig.</translation>
    </message>
    <message>
        <source>Parts of the build in &apos;%1&apos; are missing, and those that are there are of different divisions. Build all parts of one of them.</source>
        <translation>Es fehlen Teile des Baus in „%1“, und die vorhandenen gehören zu verschiedenen Aufteilungen. Bauen Sie alle Teile einer von ihnen.</translation>
    </message>
    <message>
        <source>Of the %1 parts of the build in &apos;%2&apos; these are not finished yet: %3%4.</source>
        <translation>Von den %1 Teilen des Baus in „%2“ sind diese noch nicht fertig: %3%4.</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, which this build wrote, is not what was written. Start the same command again.</source>
        <translation>„%1“ enthält nicht mehr, was dieser Bau geschrieben hat. Starten Sie denselben Befehl noch einmal.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; has no parameter &apos;%2&apos;, which the plan of this build sets. Use one version of it for all parts.</source>
        <translation>„%1“ hat keinen Parameter „%2“, den der Plan dieses Baus setzt. Verwenden Sie für alle Teile dieselbe Version.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since the build was prepared. Prepare it anew, in another folder.</source>
        <translation>„%1“ hat sich geändert, seit der Bau vorbereitet wurde. Bereiten Sie ihn in einem anderen Ordner neu vor.</translation>
    </message>
    <message>
        <source>This builder does not build in parts.</source>
        <translation>Dieses Verfahren baut nicht in Teilen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be built in parts with these options: that takes a regular lattice or a curvilinear grid, refined in blocks. Build it as a whole.</source>
        <translation>„%1“ kann mit diesen Optionen nicht in Teilen gebaut werden: Das setzt ein regelmäßiges oder ein krummliniges Gitter voraus, das in Blöcken verfeinert wird. Bauen Sie das Modell als Ganzes.</translation>
    </message>
    <message>
        <source>There is no part %1 of %2. Parts are numbered from 1.</source>
        <translation>Es gibt keinen Teil %1 von %2. Die Teile sind ab 1 nummeriert.</translation>
    </message>
    <message>
        <source>Cannot use the plan &apos;%1&apos;: %2</source>
        <translation>Der Plan „%1“ kann nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>There is no build to share in &apos;%1&apos;. Prepare one there first.</source>
        <translation>In „%1“ gibt es keinen Bau, der geteilt werden soll. Bereiten Sie dort zuerst einen vor.</translation>
    </message>
    <message>
        <source>it was made by TAn %1, and this is TAn %2. Use one version for all parts.</source>
        <translation>Er stammt von TAn %1, und dies ist TAn %2. Verwenden Sie für alle Teile dieselbe Version.</translation>
    </message>
    <message>
        <source>it is damaged. Prepare the build again.</source>
        <translation>Er ist beschädigt. Bereiten Sie den Bau noch einmal vor.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not empty. The processes that share a build need a folder of their own: name another one.</source>
        <translation>„%1“ ist nicht leer. Prozesse, die sich einen Bau teilen, brauchen einen eigenen Ordner: Geben Sie einen anderen an.</translation>
    </message>
    <message>
        <source>A build of &apos;%1&apos; cannot be shared, as its name or a folder&apos;s is no text in UTF-8. Rename it.</source>
        <translation>Ein Bau aus „%1“ kann nicht geteilt werden, da der Name der Datei oder eines Ordners kein Text in UTF-8 ist. Benennen Sie ihn um.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds another build: of other data, with other options, or by another version of TAn. Remove it, or name another folder.</source>
        <translation>„%1“ enthält einen anderen Bau: mit anderen Daten, mit anderen Optionen oder von einer anderen Version von TAn. Entfernen Sie den Ordner, oder geben Sie einen anderen an.</translation>
    </message>
</context>
<context>
    <name>tetra::MessageBar</name>
    <message>
        <source>Show or hide the older messages</source>
        <translation>Zeigt oder verbirgt die älteren Meldungen</translation>
    </message>
    <message>
        <source>Close All</source>
        <translation>Alle schließen</translation>
    </message>
    <message>
        <source>Dismiss all messages</source>
        <translation>Schließt alle Meldungen</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>Weniger zeigen</translation>
    </message>
    <message>
        <source>Show %1 more</source>
        <translation>%1 weitere zeigen</translation>
    </message>
</context>
<context>
    <name>tetra::MessageRow</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
</context>
<context>
    <name>tetra::ModeActions</name>
    <message>
        <source>Show %1 (%2)</source>
        <translation>%1 zeigen (%2)</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
</context>
<context>
    <name>tetra::Opening</name>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelle (*.tan)</translation>
    </message>
    <message>
        <source>All supported files (%1)</source>
        <translation>Alles, was sich öffnen lässt (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sitzungen (*.tansession)</translation>
    </message>
    <message>
        <source>Pictures saved by TAn (*.png)</source>
        <translation>Bilder mit ihren Sitzungen (*.png)</translation>
    </message>
    <message>
        <source>Datasets compressed with gzip (*.gz)</source>
        <translation>Mit gzip gepackte Datensätze (*.gz)</translation>
    </message>
</context>
<context>
    <name>tetra::OrientationActions</name>
    <message>
        <source>Turn Upside Down</source>
        <translation>Auf den Kopf stellen</translation>
    </message>
    <message>
        <source>Flip the up axis</source>
        <translation>Die Achse nach oben umkehren</translation>
    </message>
    <message>
        <source>Roll Clockwise</source>
        <translation>Im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the picture by 90° clockwise</source>
        <translation>Das Bild um 90° im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Roll Anticlockwise</source>
        <translation>Gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn the picture by 90° anticlockwise</source>
        <translation>Das Bild um 90° gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Waagrecht ausrichten</translation>
    </message>
    <message>
        <source>Remove the roll: make the up axis vertical</source>
        <translation>Neigung aufheben: Die Achse nach oben steht senkrecht</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging turns the model freely in any direction, instead of around the up axis</source>
        <translation>Ziehen dreht das Modell frei in jede Richtung, statt um die Achse, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Show the model with this axis upright</source>
        <translation>Das Modell so zeigen, dass diese Achse senkrecht steht</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>The picture is not rolled</source>
        <translation>Das Bild ist nicht geneigt</translation>
    </message>
</context>
<context>
    <name>tetra::ParameterForm</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>for example %1</source>
        <translation>zum Beispiel %1</translation>
    </message>
</context>
<context>
    <name>tetra::PickActions</name>
    <message>
        <source>&amp;Pick</source>
        <translation>W&amp;ählen</translation>
    </message>
    <message>
        <source>Pick the value at the pointer, or in the centre of the picture</source>
        <translation>Wählt den Wert am Zeiger oder in der Bildmitte</translation>
    </message>
    <message>
        <source>&amp;Isosurface at This Value</source>
        <translation>&amp;Isofläche bei diesem Wert</translation>
    </message>
    <message>
        <source>Add an isosurface of the picked value</source>
        <translation>Fügt eine Isofläche des gewählten Wertes hinzu</translation>
    </message>
    <message>
        <source>Add &amp;Transfer-Function Point</source>
        <translation>Punkt der &amp;Transferfunktion hinzufügen</translation>
    </message>
    <message>
        <source>Add a point to the transfer function at the picked value</source>
        <translation>Fügt der Transferfunktion beim gewählten Wert einen Punkt hinzu</translation>
    </message>
    <message>
        <source>&amp;Clear Mark</source>
        <translation>&amp;Markierung löschen</translation>
    </message>
    <message>
        <source>Clear the picked value</source>
        <translation>Entfernt den gewählten Wert</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>Click or pick a place in the picture first</source>
        <translation>Erst eine Stelle im Bild anklicken oder wählen</translation>
    </message>
</context>
<context>
    <name>tetra::PictureDialog</name>
    <message>
        <source>Store &amp;how it was made in the file</source>
        <translation>&amp;Entstehung in der Datei vermerken</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>Copy it to the clipboard</source>
        <translation>In die Zwischenablage legen</translation>
    </message>
    <message>
        <source>Program, model, accuracy, camera, transfer function and isovalues, so that the picture can be reproduced: opening it as PNG offers its view</source>
        <translation>Programm, Modell, Genauigkeit, Kamera, Transferfunktion und Isowerte, sodass das Bild noch einmal gemacht werden kann: Als PNG bietet es beim Öffnen seine Ansicht an</translation>
    </message>
</context>
<context>
    <name>tetra::PictureForm</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Trans&amp;parent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice the screen size</source>
        <translation>Doppelte Bildschirmgröße</translation>
    </message>
    <message>
        <source>HD</source>
        <translation>HD</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Annotations and lines take up the same share of the picture as of the view</source>
        <translation>Beschriftung und Linien nehmen so viel vom Bild ein wie von der Ansicht</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>Leave out the background, to place the picture over something else</source>
        <translation>Den Hintergrund weglassen, um das Bild über etwas anderes zu legen</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Pixe&amp;ls</source>
        <translation>Pi&amp;xel</translation>
    </message>
    <message>
        <source>&amp;Keep proportions</source>
        <translation>&amp;Proportionen beibehalten</translation>
    </message>
    <message>
        <source>Width and height change together, so that nothing is added or cut off</source>
        <translation>Breite und Höhe folgen einander, sodass nichts hinzukommt oder abgeschnitten wird</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Printed width</source>
        <translation>Gedruckte Breite</translation>
    </message>
    <message>
        <source>Width of the print in centimetres; the pixels follow from it and the resolution</source>
        <translation>Breite des Drucks in Zentimetern; daraus und aus der Auflösung folgen die Pixel</translation>
    </message>
    <message>
        <source>Printed height</source>
        <translation>Gedruckte Höhe</translation>
    </message>
    <message>
        <source>Height of the print in centimetres; the pixels follow from it and the resolution</source>
        <translation>Höhe des Drucks in Zentimetern; daraus und aus der Auflösung folgen die Pixel</translation>
    </message>
    <message>
        <source>Pri&amp;nt size</source>
        <translation>Druckg&amp;röße</translation>
    </message>
    <message>
        <source>Print resolution in pixels per inch; the number of pixels changes only after a size in centimetres was entered</source>
        <translation>Druckauflösung in Pixeln pro Zoll; die Zahl der Pixel ändert sich nur, wenn zuvor eine Größe in Zentimetern eingegeben wurde</translation>
    </message>
    <message>
        <source>Print &amp;resolution</source>
        <translation>Druckau&amp;flösung</translation>
    </message>
</context>
<context>
    <name>tetra::PluginWindow</name>
    <message>
        <source>Plugins</source>
        <translation>Plugins</translation>
    </message>
    <message>
        <source>Plugin</source>
        <translation>Plugin</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>The plugin %1 cannot be used. %2</source>
        <translation>Das Plugin %1 kann nicht benutzt werden. %2</translation>
    </message>
    <message>
        <source>The plugins found, and why some are not used. Space turns a plugin on or off.</source>
        <translation>Was gefunden wurde, und warum etwas nicht benutzt wird. Die Leertaste schaltet ein Plugin ein oder aus.</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Changes take effect when TAn is restarted.</source>
        <translation>Änderungen gelten ab dem nächsten Start von TAn.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Für einen Fehlerbericht kopieren</translation>
    </message>
    <message>
        <source>Searched in: %1</source>
        <translation>Gesucht in: %1</translation>
    </message>
</context>
<context>
    <name>tetra::PointNumbers</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Value of the selection, in data units; selected points move together</source>
        <translation>Wert der Auswahl, in den Einheiten der Daten; ausgewählte Punkte bewegen sich gemeinsam</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the selected points: percentage of light absorbed per unit distance</source>
        <translation>Deckkraft der ausgewählten Punkte: Prozent des Lichts, das auf der Einheitslänge verschluckt wird</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>Farbe der Auswahl</translation>
    </message>
    <message>
        <source>Unit distance</source>
        <translation>Einheitslänge</translation>
    </message>
    <message>
        <source>The thickness of a layer to which the opacities apply, in data units: a smaller one makes everything denser</source>
        <translation>Die Dicke, in den Einheiten der Daten, bei der eine Schicht die Deckkraft hat: weniger macht alles dichter</translation>
    </message>
    <message>
        <source>Val&amp;ue</source>
        <translation>&amp;Wert</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>&amp;Deckkraft</translation>
    </message>
    <message>
        <source>U&amp;nit distance</source>
        <translation>Ein&amp;heitslänge</translation>
    </message>
</context>
<context>
    <name>tetra::PointTable</name>
    <message>
        <source>Points of the transfer function</source>
        <translation>Punkte der Transferfunktion</translation>
    </message>
    <message>
        <source>Double click or F2 edits a cell; Del removes the selected points</source>
        <translation>Doppelklick oder F2 bearbeitet eine Zelle; Entf entfernt die ausgewählten Punkte</translation>
    </message>
</context>
<context>
    <name>tetra::PointTableModel</name>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity, %</source>
        <translation>Deckkraft, %</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>In data units</source>
        <translation>In den Einheiten der Daten</translation>
    </message>
    <message>
        <source>Fraction absorbed per unit distance</source>
        <translation>Anteil, der je Einheitslänge absorbiert wird</translation>
    </message>
    <message>
        <source>As a name or as #rrggbb</source>
        <translation>Als Name oder als #rrggbb</translation>
    </message>
    <message>
        <source>0 to 9, or empty</source>
        <translation>0 bis 9, oder leer</translation>
    </message>
</context>
<context>
    <name>tetra::PresetPopup</name>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>Als Vorlage &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Search for a preset</source>
        <translation>Nach einer Vorlage suchen</translation>
    </message>
    <message>
        <source>Parts of a preset to apply</source>
        <translation>Anzuwendende Teile einer Vorlage</translation>
    </message>
    <message>
        <source>Colours and opacities</source>
        <translation>Farben und Deckkraft</translation>
    </message>
    <message>
        <source>Colours alone</source>
        <translation>Nur die Farben</translation>
    </message>
    <message>
        <source>Opacities alone</source>
        <translation>Nur die Deckkraft</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Keep the current transfer function for this and other models</source>
        <translation>Die Transferfunktion, wie sie jetzt ist, für dieses und andere Modelle behalten</translation>
    </message>
    <message>
        <source>Delete the selected preset, if it is one of your own</source>
        <translation>Die gewählte Vorlage löschen, wenn es eine eigene ist</translation>
    </message>
    <message>
        <source>Your own preset</source>
        <translation>Eine eigene</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Als Vorlage speichern</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Name der Vorlage:</translation>
    </message>
    <message>
        <source>Search: bone, lung, metal, plasma…</source>
        <translation>Suchen: Knochen, Lunge, Metall, Plasma …</translation>
    </message>
    <message>
        <source>Values in Hounsfield units (HU)</source>
        <translation>Werte in Hounsfield-Einheiten (HU)</translation>
    </message>
    <message>
        <source>No preset with opacities matches “%1”.</source>
        <translation>Keine Vorlage mit Deckkraft passt zu „%1“.</translation>
    </message>
    <message>
        <source>No preset matches “%1”.</source>
        <translation>Keine Vorlage passt zu „%1“.</translation>
    </message>
</context>
<context>
    <name>tetra::RegionActions</name>
    <message>
        <source>Focus: &amp;Sphere</source>
        <translation>Fokus: &amp;Kugel</translation>
    </message>
    <message>
        <source>More accurate in a sphere</source>
        <translation>Genauer in einer Kugel</translation>
    </message>
    <message>
        <source>Focus: &amp;Box</source>
        <translation>Fokus: &amp;Quader</translation>
    </message>
    <message>
        <source>More accurate in a box</source>
        <translation>Genauer in einem Quader</translation>
    </message>
    <message>
        <source>Focus to &amp;Centre of View</source>
        <translation>Fokus zur Bild&amp;mitte</translation>
    </message>
    <message>
        <source>Move the focus to the camera&apos;s target</source>
        <translation>Den Fokus zum Zielpunkt der Kamera bewegen</translation>
    </message>
    <message>
        <source>Crop Bo&amp;x</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>Show only the part of the domain in a box</source>
        <translation>Nur den Teil des Gebiets in einem Quader zeigen</translation>
    </message>
    <message>
        <source>Turn on a focus first</source>
        <translation>Erst einen Fokus einschalten</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Erst ein Modell öffnen</translation>
    </message>
    <message>
        <source>&amp;Lens</source>
        <translation>&amp;Lupe</translation>
    </message>
    <message>
        <source>Enlarge a part of the picture, at its own accuracy</source>
        <translation>Einen Teil des Bildes vergrößern, mit eigener Genauigkeit</translation>
    </message>
</context>
<context>
    <name>tetra::RegionPanel</name>
    <message>
        <source>&amp;Only a crop box</source>
        <translation>Nur ein &amp;Fenster</translation>
    </message>
    <message>
        <source>Show only the part of the domain in a box (W)</source>
        <translation>Nur den Teil des Gebiets in einem Quader zeigen (W)</translation>
    </message>
    <message>
        <source>Corners of the crop box, in data coordinates</source>
        <translation>Grenzen des Fensters, in den Koordinaten der Daten</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>B&amp;is</translation>
    </message>
    <message>
        <source>Cut exactly</source>
        <translation>Genau abschneiden</translation>
    </message>
    <message>
        <source>Keep tetrahedra that touch it</source>
        <translation>Berührende Tetraeder behalten</translation>
    </message>
    <message>
        <source>Keep tetrahedra inside</source>
        <translation>Nur Tetraeder innerhalb</translation>
    </message>
    <message>
        <source>Tetrahedra at the border</source>
        <translation>Tetraeder am Rand</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>Make the crop box as large as the domain</source>
        <translation>Das Fenster so groß machen wie das Gebiet</translation>
    </message>
    <message>
        <source>In data units: %1 to %2</source>
        <translation>In der Einheit der Daten: %1 bis %2</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>Largest value</source>
        <translation>Größter Wert</translation>
    </message>
    <message>
        <source>&amp;Limit to a range of values</source>
        <translation>Auf einen Wertebereich &amp;beschränken</translation>
    </message>
    <message>
        <source>Fro&amp;m</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>&amp;Reset to Whole Domain</source>
        <translation>Auf das ganze Gebiet zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>&amp;Kleinster</translation>
    </message>
    <message>
        <source>&amp;Largest</source>
        <translation>&amp;Größter</translation>
    </message>
    <message>
        <source>Show only tetrahedra that can contain a value in a range. Isosurfaces of other values disappear, or are shown only in part.</source>
        <translation>Nur Tetraeder zeigen, die einen Wert eines Bereichs enthalten können. Isoflächen anderer Werte sind nicht oder nur teilweise zu sehen.</translation>
    </message>
    <message>
        <source>How tetrahedra at the border of the crop box are treated: cut exactly there, or kept or left out whole</source>
        <translation>Wie das Fenster endet: Tetraeder an seiner Grenze werden genau dort geschnitten oder ganz behalten oder ganz weggelassen</translation>
    </message>
    <message>
        <source>All tetrahedra in a range of &amp;errors</source>
        <translation>Alle Tetraeder in einem Bereich von &amp;Fehlern</translation>
    </message>
    <message>
        <source>Overlay the tetrahedra of every mesh between two errors, as surfaces. The crop box does not cut them.</source>
        <translation>Statt eines Netzes die Tetraeder aller Netze zwischen zwei Fehlern zeigen, übereinander, als Flächen. Ein Fenster lässt sie ganz.</translation>
    </message>
    <message>
        <source>in percent of the value range; 100 means no limit</source>
        <translation>in Prozent des Wertebereichs; 100 ist keine Grenze</translation>
    </message>
    <message>
        <source>F&amp;inest</source>
        <translation>F&amp;einster</translation>
    </message>
    <message>
        <source>Smallest error of the range</source>
        <translation>Kleinster Fehler des Bereichs</translation>
    </message>
    <message>
        <source>The mesh of this error is the finest of the range, in percent of the value range</source>
        <translation>Das Netz dieses Fehlers ist das feinste des Bereichs, in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>&amp;Coarsest</source>
        <translation>&amp;Gröbster</translation>
    </message>
    <message>
        <source>Largest error of the range</source>
        <translation>Größter Fehler des Bereichs</translation>
    </message>
    <message>
        <source>The mesh of this error is the coarsest of the range, in percent of the value range</source>
        <translation>Das Netz dieses Fehlers ist das gröbste des Bereichs, in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>&amp;Appear above</source>
        <translation>E&amp;ntstanden über</translation>
    </message>
    <message>
        <source>Appear above</source>
        <translation>Entstanden über</translation>
    </message>
    <message>
        <source>Only tetrahedra that first appear above this error, in percent of the value range</source>
        <translation>Nur Tetraeder, die ab einem Fehler über diesem in Netzen sind, in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>Appear &amp;up to</source>
        <translation>Entstanden &amp;bis</translation>
    </message>
    <message>
        <source>Appear up to</source>
        <translation>Entstanden bis</translation>
    </message>
    <message>
        <source>Only tetrahedra that first appear at or below this error, %1</source>
        <translation>Nur Tetraeder, die in keinem Netz eines größeren Fehlers sind, %1</translation>
    </message>
    <message>
        <source>&amp;Disappear from</source>
        <translation>Ersetzt a&amp;b</translation>
    </message>
    <message>
        <source>Disappear from</source>
        <translation>Ersetzt ab</translation>
    </message>
    <message>
        <source>Only tetrahedra that are replaced at this error or a larger one, in percent of the value range</source>
        <translation>Nur Tetraeder, die bei diesem Fehler oder vorher ersetzt werden, in Prozent des Wertebereichs</translation>
    </message>
    <message>
        <source>Disap&amp;pear up to</source>
        <translation>Erset&amp;zt bis</translation>
    </message>
    <message>
        <source>Disappear up to</source>
        <translation>Ersetzt bis</translation>
    </message>
    <message>
        <source>Only tetrahedra that are still in the mesh of this error, %1</source>
        <translation>Nur Tetraeder, die noch im Netz dieses Fehlers sind, %1</translation>
    </message>
</context>
<context>
    <name>tetra::RenderingPanel</name>
    <message>
        <source>Rendering mode</source>
        <translation>Darstellungsart</translation>
    </message>
    <message>
        <source>Automatic (%1 frames/s)</source>
        <translation>Automatisch (%1 Bilder/s)</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> Bilder/s</translation>
    </message>
    <message>
        <source>The frame rate to keep while something moves. If the machine is too slow, frames are drawn smaller and with fewer tetrahedra; the still picture is always complete.</source>
        <translation>Die Bildrate, die in Bewegung gehalten wird. Ist der Rechner zu langsam, werden die Bilder kleiner und aus weniger Tetraedern gezeichnet; das ruhende Bild ist immer vollständig.</translation>
    </message>
    <message>
        <source>Frame rate while moving</source>
        <translation>Bildrate in Bewegung</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Frame r&amp;ate</source>
        <translation>Bildr&amp;ate</translation>
    </message>
    <message>
        <source>What to draw while moving</source>
        <translation>Was bei Bewegung gezeichnet wird</translation>
    </message>
    <message>
        <source>What to draw while something moves. The still picture is always complete.</source>
        <translation>Was gezeichnet wird, während sich etwas bewegt. Das Bild in Ruhe ist immer vollständig.</translation>
    </message>
    <message>
        <source>As the frame rate allows</source>
        <translation>Was die Bildrate erlaubt</translation>
    </message>
    <message>
        <source>A mesh of a fixed error</source>
        <translation>Ein Netz mit festem Fehler</translation>
    </message>
    <message>
        <source>A share of the tetrahedra</source>
        <translation>Ein Teil der Tetraeder</translation>
    </message>
    <message>
        <source>Always full quality</source>
        <translation>Immer volle Qualität</translation>
    </message>
    <message>
        <source>Error while moving</source>
        <translation>Fehler bei Bewegung</translation>
    </message>
    <message>
        <source>The error of the mesh that is drawn while something moves, in percent of the value range.</source>
        <translation>Der Fehler des Netzes, das gezeichnet wird, während sich etwas bewegt, in Prozent des Wertebereichs.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Share of the tetrahedra while moving</source>
        <translation>Anteil der Tetraeder bei Bewegung</translation>
    </message>
    <message>
        <source>How many of the tetrahedra are drawn while something moves, in percent.</source>
        <translation>Wie viele der Tetraeder gezeichnet werden, während sich etwas bewegt, in Prozent.</translation>
    </message>
    <message>
        <source>Time until the full picture</source>
        <translation>Zeit bis zum vollen Bild</translation>
    </message>
    <message>
        <source>The full picture is drawn when nothing has moved for this long, in milliseconds.</source>
        <translation>Wenn sich so lange nichts bewegt hat, in Millisekunden, wird das volle Bild gezeichnet.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>While &amp;moving</source>
        <translation>Bei &amp;Bewegung</translation>
    </message>
    <message>
        <source>&amp;Error</source>
        <translation>&amp;Fehler</translation>
    </message>
    <message>
        <source>&amp;Tetrahedra</source>
        <translation>&amp;Tetraeder</translation>
    </message>
    <message>
        <source>&amp;Full picture after</source>
        <translation>&amp;Volles Bild nach</translation>
    </message>
</context>
<context>
    <name>tetra::ScaleInput</name>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Linear uses the values as they are. Logarithmic uses their logarithms to base 10, for values spanning many powers of ten: errors are then factors, the same for large and small values</source>
        <translation>Linear nimmt die Werte, wie sie sind. Logarithmisch nimmt ihre Logarithmen zur Basis 10, für Werte über viele Zehnerpotenzen: Fehler sind dann Faktoren, dieselben bei großen und bei kleinen Werten</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Kleinster Wert</translation>
    </message>
    <message>
        <source>all values are positive</source>
        <translation>alle Werte sind positiv</translation>
    </message>
    <message>
        <source>Values smaller than this are replaced by it, including zero and negative ones, which have no logarithm. Leave empty if all values are positive</source>
        <translation>Der Wert, als der kleinere genommen werden, auch null und negative: Sie haben keinen Logarithmus. Leer: Alle Werte müssen positiv sein</translation>
    </message>
</context>
<context>
    <name>tetra::SceneService</name>
    <message>
        <source>No renderer plugin could be loaded, so models cannot be shown. %1</source>
        <translation>Kein Plugin zur Darstellung konnte geladen werden; so lässt sich kein Modell zeigen. %1</translation>
    </message>
</context>
<context>
    <name>tetra::SessionFile</name>
    <message>
        <source>Not all of the session could be kept.</source>
        <translation>Die Sitzung konnte nicht ganz beibehalten werden.</translation>
    </message>
    <message>
        <source>The session %1 is not changed; saving will ask for another file name.</source>
        <translation>Die Sitzung %1 bleibt, wie sie ist; beim Speichern wird nach einem anderen Dateinamen gefragt.</translation>
    </message>
    <message>
        <source>The view saved in the session is applied.</source>
        <translation>Es wird so gezeigt, wie die Sitzung sagt.</translation>
    </message>
    <message>
        <source>It will be offered again the next time.</source>
        <translation>Sie wird beim nächsten Start wieder angeboten.</translation>
    </message>
</context>
<context>
    <name>tetra::SessionOpening</name>
    <message>
        <source>Apply Look</source>
        <translation>Aussehen übernehmen</translation>
    </message>
    <message>
        <source>Not all of the look of %1 could be applied.</source>
        <translation>Das Aussehen von %1 konnte nicht vollständig übernommen werden.</translation>
    </message>
</context>
<context>
    <name>tetra::SlicePreview</name>
    <message>
        <source>Preview of a layer</source>
        <translation>Vorschau einer Schicht</translation>
    </message>
    <message>
        <source>Axis of the layers</source>
        <translation>Achse der Schichten</translation>
    </message>
    <message>
        <source>Axis perpendicular to the layer</source>
        <translation>Achse senkrecht zur Schicht</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Quer zu %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Layer shown, counted from 0</source>
        <translation>Die gezeigte Schicht, von 0 an gezählt</translation>
    </message>
    <message>
        <source>No preview: the layout is incomplete</source>
        <translation>Keine Vorschau: Die Anordnung ist unvollständig</translation>
    </message>
    <message>
        <source>%1 to the right, %2 up; black %3, white %4</source>
        <translation>%1 nach rechts, %2 nach oben; schwarz %3, weiß %4</translation>
    </message>
</context>
<context>
    <name>tetra::SolidDialog</name>
    <message>
        <source>&amp;Largest part only</source>
        <translation>Nur den &amp;größten Teil</translation>
    </message>
    <message>
        <source>&amp;Measure the deviation</source>
        <translation>Die &amp;Abweichung messen</translation>
    </message>
    <message>
        <source>Save Solids</source>
        <translation>Körper speichern</translation>
    </message>
    <message>
        <source>The displayed isosurfaces are closed where they meet the boundary of the mesh, so that each is the surface of a solid, as 3D printing requires.</source>
        <translation>Die gezeigten Isoflächen werden dort geschlossen, wo sie auf die Berandung des Netzes treffen, sodass jede die Fläche eines Körpers ist, wie ein 3D-Drucker sie braucht.</translation>
    </message>
    <message>
        <source>Values above the isovalue</source>
        <translation>Werte über dem Isowert</translation>
    </message>
    <message>
        <source>Values below the isovalue</source>
        <translation>Werte unter dem Isowert</translation>
    </message>
    <message>
        <source>None: leave them open</source>
        <translation>Keiner: offen lassen</translation>
    </message>
    <message>
        <source>Where the solid lies: on which side of the isosurface</source>
        <translation>Wo der Körper liegt: auf welcher Seite der Isofläche</translation>
    </message>
    <message>
        <source>Save only the part of each surface with the largest area</source>
        <translation>Von jeder Fläche nur den Teil mit dem größten Flächeninhalt speichern</translation>
    </message>
    <message>
        <source>Also measure how far the surfaces are from those of the finest mesh; this takes as long as showing the model at error 0</source>
        <translation>Auch messen, wie weit die Flächen von denen des feinsten Netzes entfernt sind; das dauert so lange, wie das Modell bei Fehler 0 zu zeigen</translation>
    </message>
    <message>
        <source>S&amp;olid:</source>
        <translation>K&amp;örper:</translation>
    </message>
</context>
<context>
    <name>tetra::StatisticsPanel</name>
    <message>
        <source>Mesh sizes</source>
        <translation>Netzgrößen</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>Copy as text, with tabs between the columns</source>
        <translation>Kopiert als Text, mit Tabulatoren zwischen den Spalten</translation>
    </message>
    <message>
        <source>Save the table as CSV or JSON (percent, decimal point)</source>
        <translation>Speichert die Tabelle als CSV oder JSON (Prozent, Dezimalpunkt)</translation>
    </message>
    <message>
        <source>Show &amp;faulty cells</source>
        <translation>&amp;Fehlerhafte Zellen zeigen</translation>
    </message>
    <message>
        <source>Outline, over the picture, the cells that were left out because something is wrong with them, and the cells of a grid that are folded or have no volume</source>
        <translation>Über dem Bild die Zellen umreißen, die weggelassen wurden, weil mit ihnen etwas nicht stimmt, und die eines Gitters, die gefaltet sind oder kein Volumen haben</translation>
    </message>
    <message>
        <source>This model lists no faulty cells: its data have none, or an earlier version of TAn built it</source>
        <translation>Dieses Modell führt keine fehlerhaften Zellen auf: Seine Daten haben keine, oder eine frühere Version von TAn hat es gebaut</translation>
    </message>
    <message>
        <source>What the mesh of each error costs: its error in percent of the value range and in units of the values or as a factor, its size, the time to extract it, measured on this computer, and the memory that it occupies. Choose a row to see that mesh.</source>
        <translation>Was das Netz jedes Fehlers kostet: der Fehler in Prozent des Wertebereichs und in den Einheiten der Werte oder als Faktor, die Größe, die Zeit für die Extraktion, wie hier gemessen, und der Speicher, den es belegt. Eine Zeile wählen, um dieses Netz zu sehen.</translation>
    </message>
</context>
<context>
    <name>tetra::StatusLine</name>
    <message>
        <source>Drawing the picture at the chosen accuracy</source>
        <translation>Das Bild in der gewählten Genauigkeit wird gezeichnet</translation>
    </message>
    <message>
        <source>Vertices of the mesh shown</source>
        <translation>Knoten des gezeigten Netzes</translation>
    </message>
    <message>
        <source>Tetrahedra of the mesh shown</source>
        <translation>Tetraeder des gezeigten Netzes</translation>
    </message>
    <message>
        <source>Triangles of all surfaces shown</source>
        <translation>Dreiecke aller gezeigten Flächen</translation>
    </message>
    <message>
        <source>Time to extract the mesh from the model</source>
        <translation>Zeit, um das Netz dem Modell zu entnehmen</translation>
    </message>
    <message>
        <source>Memory used by the program, including mapped files</source>
        <translation>Speicher, den das Programm belegt, eingeblendete Dateien eingeschlossen</translation>
    </message>
    <message>
        <source>Rendering back end: OpenGL or the CPU</source>
        <translation>Gezeichnet von: OpenGL oder dem Prozessor</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Knoten</translation>
    </message>
    <message>
        <source>%1 tetrahedra</source>
        <translation>%1 Tetraeder</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>extracted in %1</source>
        <translation>extrahiert in %1</translation>
    </message>
    <message>
        <source>%1 per frame</source>
        <translation>%1 je Bild</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>size 1/%1</source>
        <translation>Größe 1/%1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Picked value and its position, in data units. Click elsewhere to pick another; Esc clears the mark.</source>
        <translation>Gewählter Wert und sein Ort, in den Einheiten der Daten. Ein Klick anderswo wählt einen anderen, Esc nimmt die Markierung weg.</translation>
    </message>
    <message>
        <source>Time to draw the last picture; during movement, the frame rate, and the reduced size and number of tetrahedra</source>
        <translation>Zeit für das Zeichnen des letzten Bildes; in Bewegung die Bildrate, die verringerte Bildgröße und die verringerte Zahl der Tetraeder</translation>
    </message>
    <message>
        <source>The server is extracting the mesh, or the picture is being drawn</source>
        <translation>Der Server bestimmt das Netz, oder das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>part may be error</source>
        <translation>ein Teil kann Fehler sein</translation>
    </message>
</context>
<context>
    <name>tetra::TaskLine</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>tetra::ToolActions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>tetra::ToolPanel</name>
    <message>
        <source>No tool plugin could be loaded.</source>
        <translation>Kein Werkzeug-Plugin konnte geladen werden.</translation>
    </message>
    <message>
        <source>Choose a tool in the menu Tools: to measure, say, or to cut.</source>
        <translation>Wählen Sie im Menü Werkzeuge ein Werkzeug, etwa zum Messen oder Schneiden.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>What the tool tells of the places in the picture</source>
        <translation>Was das Werkzeug über die Stellen im Bild sagt</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the readings as text, for a table</source>
        <translation>Die Messwerte als Text kopieren, für eine Tabelle</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>tetra::TransferCanvas</name>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>Point %1 of %2: value %3, opacity %4</source>
        <translation>Punkt %1 von %2: Wert %3, Deckkraft %4</translation>
    </message>
    <message>
        <source>Opacity against value. Drag points, click the curve or double click to add one, Delete removes; arrow keys move (finer with Ctrl, farther with Shift), Tab goes to the next. A frame or Ctrl+click selects several. The wheel zooms the values, with Ctrl the opacities; Home shows all. Ctrl+digit makes a group, the digit selects it. Behind: how often the values occur in the mesh.</source>
        <translation>Deckkraft über dem Wert. Punkte ziehen, mit Klick auf die Kurve oder Doppelklick einen hinzufügen, Entf entfernt; Pfeiltasten bewegen (feiner mit Strg, weiter mit Umschalt), Tab geht zum nächsten. Ein Rahmen oder Strg+Klick wählt mehrere aus. Das Rad vergrößert die Werte, mit Strg die Deckkraft; Pos1 zeigt alles. Strg+Ziffer bildet eine Gruppe, die Ziffer wählt sie aus. Dahinter: wie oft die Werte im Netz vorkommen.</translation>
    </message>
    <message>
        <source>%1 points are selected</source>
        <translation>%1 Punkte sind ausgewählt</translation>
    </message>
    <message>
        <source>Value %1, opacity %2</source>
        <translation>Wert %1, Deckkraft %2</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>Isovalue %1 of %2: %3</source>
        <translation>Isowert %1 von %2: %3</translation>
    </message>
    <message>
        <source>Lower end of the mask: %1</source>
        <translation>Unteres Ende der Maske: %1</translation>
    </message>
    <message>
        <source>Upper end of the mask: %1</source>
        <translation>Oberes Ende der Maske: %1</translation>
    </message>
</context>
<context>
    <name>tetra::TransferPanel</name>
    <message>
        <source>S&amp;tep</source>
        <translation>S&amp;tufe</translation>
    </message>
    <message>
        <source>Lo&amp;garithmic</source>
        <translation>Lo&amp;garithmisch</translation>
    </message>
    <message>
        <source>Give the point two sides: one colour and opacity for the values below it, another for those above</source>
        <translation>Dem Punkt zwei Seiten geben: was unter seinem Wert liegt, endet dort, und was darüber liegt, beginnt</translation>
    </message>
    <message>
        <source>Show how often values occur on a logarithmic scale, so that rare ones are visible</source>
        <translation>Die Häufigkeit der Werte logarithmisch zeigen, damit man auch seltene sieht</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Transfer-function presets</source>
        <translation>Vorlagen für Transferfunktionen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden …</translation>
    </message>
    <message>
        <source>Load a transfer function: TAn&apos;s own, or ParaView presets (JSON or XML)</source>
        <translation>Eine Transferfunktion aus einer Datei nehmen: eine von TAn oder Vorlagen von ParaView (JSON oder XML)</translation>
    </message>
    <message>
        <source>The file holds several presets:</source>
        <translation>Die Datei enthält mehrere Vorlagen:</translation>
    </message>
    <message>
        <source>Save for &amp;ParaView…</source>
        <translation>Für &amp;ParaView speichern …</translation>
    </message>
    <message>
        <source>Save Transfer Function for ParaView</source>
        <translation>Transferfunktion für ParaView speichern</translation>
    </message>
    <message>
        <source>ParaView presets (*.json)</source>
        <translation>ParaView-Vorlagen (*.json)</translation>
    </message>
    <message>
        <source>Transfer functions (*.json *.xml)</source>
        <translation>Transferfunktionen (*.json *.xml)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save the transfer function as a JSON file, which “tan render” also accepts</source>
        <translation>Die Transferfunktion als JSON-Datei speichern, die auch „tan render“ nimmt</translation>
    </message>
    <message>
        <source>Load Transfer Function</source>
        <translation>Transferfunktion laden</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Transferfunktionen (*.json)</translation>
    </message>
    <message>
        <source>Save Transfer Function</source>
        <translation>Transferfunktion speichern</translation>
    </message>
    <message>
        <source>Axis of opacities</source>
        <translation>Achse der Deckkraft</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linear</translation>
    </message>
    <message>
        <source>S&amp;quare root</source>
        <translation>&amp;Quadratwurzel</translation>
    </message>
    <message>
        <source>L&amp;ogarithmic: fine near zero</source>
        <translation>L&amp;ogarithmisch: fein nahe null</translation>
    </message>
    <message>
        <source>Zoom to the &amp;selected points</source>
        <translation>Auf die &amp;ausgewählten Punkte vergrößern</translation>
    </message>
    <message>
        <source>Zoom to the &amp;values of the data</source>
        <translation>Auf die &amp;Werte der Daten vergrößern</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>A&amp;lles zeigen</translation>
    </message>
    <message>
        <source>Value, opacity, colour and frequency of occurrence, at the pointer</source>
        <translation>Wert, Deckkraft, Farbe und Häufigkeit unter dem Mauszeiger</translation>
    </message>
    <message>
        <source>Add a point after the selected one; or click the curve, or double-click the plot</source>
        <translation>Einen Punkt nach dem ausgewählten hinzufügen; oder auf die Kurve klicken, oder doppelt in das Diagramm</translation>
    </message>
    <message>
        <source>Remove the selection (Del)</source>
        <translation>Auswahl entfernen (Entf)</translation>
    </message>
    <message>
        <source>Change the selected points, or all</source>
        <translation>Die ausgewählten Punkte ändern, oder alle</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>How the plot is shown</source>
        <translation>Wie das Diagramm gezeigt wird</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Show only the values between two draggable lines</source>
        <translation>Nur die Werte zwischen zwei verschiebbaren Linien zeigen</translation>
    </message>
    <message>
        <source>Edit all points in a table</source>
        <translation>Alle Punkte in einer Tabelle bearbeiten</translation>
    </message>
    <message>
        <source>Read-out</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Einen Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove the selection</source>
        <translation>Auswahl entfernen</translation>
    </message>
    <message>
        <source>Axis of values</source>
        <translation>Achse der Werte</translation>
    </message>
    <message>
        <source>Li&amp;near</source>
        <translation>Li&amp;near</translation>
    </message>
    <message>
        <source>Logarithmic: by &amp;factors</source>
        <translation>Logarithmisch: nach &amp;Faktoren</translation>
    </message>
    <message>
        <source>Transfer function to edit</source>
        <translation>Zu bearbeitende Transferfunktion</translation>
    </message>
    <message>
        <source>Fun&amp;ction</source>
        <translation>Fun&amp;ktion</translation>
    </message>
</context>
<context>
    <name>tetra::ValuePick</name>
    <message>
        <source>%1 at (%2, %3, %4)</source>
        <translation>%1 bei (%2, %3, %4)</translation>
    </message>
</context>
<context>
    <name>tetra::ViewPanel</name>
    <message>
        <source>&amp;Load Camera…</source>
        <translation>Kamera &amp;laden …</translation>
    </message>
    <message>
        <source>Sa&amp;ve Camera…</source>
        <translation>Kamera spei&amp;chern …</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>From the camera to the target, in data units</source>
        <translation>Von der Kamera zum Ziel, in Einheiten der Daten</translation>
    </message>
    <message>
        <source>View angle</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>View angle along the shorter side of the picture, in degrees</source>
        <translation>Bildwinkel entlang der kürzeren Bildseite, in Grad</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektivisch</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Perspective: distant parts look smaller (Ctrl+P)</source>
        <translation>Perspektive: Fernes erscheint kleiner (Strg+P)</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>The camera&apos;s target, in data units</source>
        <translation>Der Zielpunkt der Kamera, in den Einheiten der Daten</translation>
    </message>
    <message>
        <source>A&amp;zimuth</source>
        <translation>A&amp;zimut</translation>
    </message>
    <message>
        <source>E&amp;levation</source>
        <translation>H&amp;öhe</translation>
    </message>
    <message>
        <source>D&amp;istance</source>
        <translation>Abs&amp;tand</translation>
    </message>
    <message>
        <source>View &amp;angle</source>
        <translation>Bildw&amp;inkel</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>Pro&amp;jektion</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Von dieser Seite blicken</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Background colour, also in saved pictures</source>
        <translation>Hintergrundfarbe, auch in gespeicherten Bildern</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Hintergrundfarbe</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Load the camera from a JSON file</source>
        <translation>Die Kamera aus einer JSON-Datei laden</translation>
    </message>
    <message>
        <source>Save the camera as a JSON file, which “tan render --camera” also accepts</source>
        <translation>Die Kamera als JSON-Datei speichern, die auch „tan render --camera“ nimmt</translation>
    </message>
    <message>
        <source>Bac&amp;kground</source>
        <translation>Hinter&amp;grund</translation>
    </message>
    <message>
        <source>Load Camera</source>
        <translation>Kamera laden</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Kameras (*.json)</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Kamera speichern</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Direction around the up axis, in degrees</source>
        <translation>Richtung um die senkrechte Achse, in Grad</translation>
    </message>
    <message>
        <source>Height above the plane perpendicular to the up axis, in degrees</source>
        <translation>Höhe über der Ebene quer zur senkrechten Achse, in Grad</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Clockwise roll of the picture, in degrees</source>
        <translation>Neigung des Bildes im Uhrzeigersinn, in Grad</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Achse nach oben</translation>
    </message>
    <message>
        <source>Which axis of the data points up</source>
        <translation>Welche Achse der Daten nach oben zeigt</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Whether dragging turns the model around the up axis, or freely in any direction (Ctrl+T)</source>
        <translation>Ob Ziehen das Modell um die senkrechte Achse dreht oder frei in jede Richtung (Strg+T)</translation>
    </message>
    <message>
        <source>&amp;Roll</source>
        <translation>&amp;Neigung</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Dra&amp;gging</source>
        <translation>&amp;Ziehen</translation>
    </message>
    <message>
        <source>Frame what is shown, or the focus; press again for the whole domain (Home)</source>
        <translation>Einpassen, was gezeigt wird, oder den Fokus; noch einmal: das ganze Gebiet (Pos1)</translation>
    </message>
    <message>
        <source>The colour that fits the window, light or dark; dark behind a shaded volume</source>
        <translation>Die Farbe, die zum Fenster passt, hell oder dunkel; dunkel hinter einem beleuchteten Volumen</translation>
    </message>
</context>
<context>
    <name>tetra::Viewport</name>
    <message>
        <source>OpenGL cannot be used; the CPU draws the picture instead. %1</source>
        <translation>OpenGL ist nicht benutzbar, stattdessen zeichnet der Prozessor das Bild. %1</translation>
    </message>
</context>
</TS>
