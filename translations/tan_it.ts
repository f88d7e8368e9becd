<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it">
<context>
    <name>Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Apre un insieme di dati o un modello</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Apri &amp;recente</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>Salva &amp;immagine…</translation>
    </message>
    <message>
        <source>Save the view as a PNG picture</source>
        <translation>Salva la vista come immagine PNG</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>C&amp;hiudi</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Esci</translation>
    </message>
    <message>
        <source>Quit TAn</source>
        <translation>Esce da TAn</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ripeti</translation>
    </message>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>A&amp;ggiungi isovalore</translation>
    </message>
    <message>
        <source>Add an isosurface at another value</source>
        <translation>Aggiunge un&apos;isosuperficie a un altro valore</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Fronte</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Retro</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Sinistra</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Destra</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Alto</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Basso</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>Angol&amp;o</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Guarda da questo lato</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Adatta</translation>
    </message>
    <message>
        <source>&amp;Look From</source>
        <translation>&amp;Guarda da</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Prospettiva</translation>
    </message>
    <message>
        <source>Perspective, or parallel projection</source>
        <translation>Proiezione prospettica o parallela</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pa&amp;nnelli</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>&amp;Ripristina disposizione</translation>
    </message>
    <message>
        <source>Restore the default layout</source>
        <translation>Ripristina la disposizione predefinita</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>Schermo &amp;intero</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Usa l&apos;intero schermo</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>&amp;Plugins…</source>
        <translation>&amp;Plugin…</translation>
    </message>
    <message>
        <source>Installed plugins</source>
        <translation>Plugin installati</translation>
    </message>
    <message>
        <source>&amp;About TAn</source>
        <translation>&amp;Informazioni su TAn</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versione e licenza</translation>
    </message>
    <message>
        <source>Save &amp;Mesh…</source>
        <translation>Salva &amp;mesh…</translation>
    </message>
    <message>
        <source>Save the displayed mesh for VTK, ParaView and other programs</source>
        <translation>Salva la mesh mostrata, per VTK, ParaView e altri</translation>
    </message>
    <message>
        <source>Save S&amp;urfaces…</source>
        <translation>Salva s&amp;uperfici…</translation>
    </message>
    <message>
        <source>Save the displayed isosurfaces for 3D printing, Blender, ParaView and other programs</source>
        <translation>Salva le isosuperfici mostrate, per stampanti 3D, Blender, ParaView e altri</translation>
    </message>
    <message>
        <source>Save Stat&amp;istics…</source>
        <translation>Salva s&amp;tatistiche…</translation>
    </message>
    <message>
        <source>Save the mesh size at each accuracy as a table</source>
        <translation>Salva come tabella la dimensione della mesh per ogni accuratezza</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>&amp;Regione</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>&amp;Save Session</source>
        <translation>&amp;Salva sessione</translation>
    </message>
    <message>
        <source>Save the open model and its view, to continue later</source>
        <translation>Salva ciò che è aperto con la sua vista, per continuare più tardi</translation>
    </message>
    <message>
        <source>Save Session &amp;As…</source>
        <translation>Salva sessione &amp;con nome…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Salva la sessione in un altro file</translation>
    </message>
    <message>
        <source>Import with Op&amp;tions…</source>
        <translation>Importa con &amp;opzioni…</translation>
    </message>
    <message>
        <source>Open a part of a dataset, or choose how its file is read</source>
        <translation>Apre una parte di un insieme di dati, o sceglie come leggere il suo file</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>&amp;Trova comando…</translation>
    </message>
    <message>
        <source>Search all commands</source>
        <translation>Cerca fra tutti i comandi</translation>
    </message>
    <message>
        <source>Reduced &amp;Motion</source>
        <translation>Movimento ri&amp;dotto</translation>
    </message>
    <message>
        <source>Disable camera animation</source>
        <translation>Disattiva l&apos;animazione della camera</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Lingua</translation>
    </message>
    <message>
        <source>&amp;Help on This Control</source>
        <translation>&amp;Guida a questo controllo</translation>
    </message>
    <message>
        <source>Explain the control that has the focus</source>
        <translation>Spiega il controllo attivo</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>&amp;Che cos&apos;è?</translation>
    </message>
    <message>
        <source>Click a control to read what it does</source>
        <translation>Fare clic su un controllo per leggere che cosa fa</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Non c&apos;è nulla da annullare</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Non c&apos;è nulla da ripetere</translation>
    </message>
    <message>
        <source>Save &amp;Film…</source>
        <translation>Salva &amp;filmato…</translation>
    </message>
    <message>
        <source>Save the animation as pictures or a video</source>
        <translation>Salva l&apos;animazione come immagini o come video</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>&amp;Copia immagine</translation>
    </message>
    <message>
        <source>Copy the view to the clipboard</source>
        <translation>Copia la vista negli appunti</translation>
    </message>
    <message>
        <source>&amp;Annotations</source>
        <translation>Annota&amp;zioni</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuale</translation>
    </message>
    <message>
        <source>Open the manual in the browser</source>
        <translation>Apre il manuale nel browser</translation>
    </message>
    <message>
        <source>Picked &amp;Value</source>
        <translation>&amp;Valore scelto</translation>
    </message>
    <message>
        <source>Close the model and its dataset</source>
        <translation>Chiude il modello e il suo insieme di dati</translation>
    </message>
    <message>
        <source>Reset &amp;View</source>
        <translation>Reimposta &amp;vista</translation>
    </message>
    <message>
        <source>Restore the default accuracy, colours, isovalues and camera</source>
        <translation>Ripristina accuratezza, colori, isovalori e camera iniziali</translation>
    </message>
    <message>
        <source>There is nothing to close</source>
        <translation>Non c&apos;è nulla da chiudere</translation>
    </message>
    <message>
        <source>Open Samp&amp;le</source>
        <translation>Apri esem&amp;pio</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>&amp;Orientamento</translation>
    </message>
    <message>
        <source>Ope&amp;n URL…</source>
        <translation>Apri UR&amp;L…</translation>
    </message>
    <message>
        <source>Open a model on a server</source>
        <translation>Apre un modello che si trova su un server</translation>
    </message>
    <message>
        <source>Model Cac&amp;he…</source>
        <translation>Cache &amp;dei modelli…</translation>
    </message>
    <message>
        <source>Manage the cache of downloaded and unpacked models</source>
        <translation>Dove vanno i modelli che vengono decompressi o scaricati</translation>
    </message>
    <message>
        <source>Save Pac&amp;ked Model…</source>
        <translation>Sal&amp;va modello compresso…</translation>
    </message>
    <message>
        <source>Save the model at a fraction of its size, for archiving or for a server</source>
        <translation>Salva il modello in una piccola parte della dimensione, per archivi e server</translation>
    </message>
    <message>
        <source>Open a whole model first</source>
        <translation>Aprire prima un modello intero</translation>
    </message>
    <message>
        <source>Appl&amp;y Look From…</source>
        <translation>Applica aspetto da u&amp;n file…</translation>
    </message>
    <message>
        <source>Apply the colours, isovalues, camera and settings of another session or picture to the open model</source>
        <translation>Mostra il modello aperto come un&apos;altra sessione o un&apos;immagine mostra il proprio: con i suoi colori, isovalori, camera e impostazioni</translation>
    </message>
    <message>
        <source>Frame what is shown, or the focus; press again for the whole domain</source>
        <translation>Inquadra ciò che si mostra, o il focus; ancora una volta: l&apos;intero dominio</translation>
    </message>
    <message>
        <source>Fit &amp;Whole Domain</source>
        <translation>Adatta &amp;tutto il dominio</translation>
    </message>
    <message>
        <source>Frame the whole domain</source>
        <translation>Inquadra l&apos;intero dominio</translation>
    </message>
    <message>
        <source>Save the displayed isosurfaces as closed surfaces of solids, for 3D printing</source>
        <translation>Salva le isosuperfici mostrate come superfici chiuse di solidi, per stampanti 3D</translation>
    </message>
    <message>
        <source>Save Soli&amp;ds…</source>
        <translation>Salva &amp;geometrie solide…</translation>
    </message>
    <message>
        <source>Tool Bar</source>
        <translation>Barra degli strumenti</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>Str&amp;umenti</translation>
    </message>
    <message>
        <source>&amp;Bookmarks</source>
        <translation>&amp;Segnalibri</translation>
    </message>
</context>
<context>
    <name>Annotations</name>
    <message>
        <source>Colour &amp;bar</source>
        <translation>&amp;Barra dei colori</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;ssi</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>Barra &amp;di scala</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titolo</translation>
    </message>
    <message>
        <source>A&amp;ccuracy</source>
        <translation>A&amp;ccuratezza</translation>
    </message>
    <message>
        <source>Values and their colours, in data units; on the right their opacity, with marks at the isovalues</source>
        <translation>I valori e i loro colori, nelle unità dei dati; a destra l&apos;opacità, con segni agli isovalori</translation>
    </message>
    <message>
        <source>The directions of x, y and z</source>
        <translation>Le direzioni di x, y e z</translation>
    </message>
    <message>
        <source>A length in data units; in perspective it applies at the distance of the target</source>
        <translation>Una lunghezza nelle unità dei dati; in prospettiva quella delle cose distanti quanto il punto mirato</translation>
    </message>
    <message>
        <source>The error bound of the displayed mesh, in % of the value range</source>
        <translation>L&apos;errore che ciò che si vede non supera, in % dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>The name of the model, or a text of your own</source>
        <translation>Il nome del modello o un testo proprio</translation>
    </message>
    <message>
        <source>Axes with &amp;numbers</source>
        <translation>Assi con &amp;numeri</translation>
    </message>
    <message>
        <source>Coordinates along the edges of the box around the data, in data units</source>
        <translation>Coordinate lungo gli spigoli del parallelepipedo attorno ai dati, nelle unità dei dati</translation>
    </message>
</context>
<context>
    <name>Bookmarks</name>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Add Bookmark</source>
        <translation>Aggiungi segnalibro</translation>
    </message>
    <message>
        <source>Show Bookmark</source>
        <translation>Mostra segnalibro</translation>
    </message>
</context>
<context>
    <name>Camera</name>
    <message>
        <source>%1 Up</source>
        <translation>%1 in alto</translation>
    </message>
    <message>
        <source>%1 Down</source>
        <translation>%1 in basso</translation>
    </message>
</context>
<context>
    <name>ChangeView</name>
    <message>
        <source>Add Isovalue</source>
        <translation>Aggiungi isovalore</translation>
    </message>
    <message>
        <source>Change Animation</source>
        <translation>Modifica animazione</translation>
    </message>
    <message>
        <source>Change Annotations</source>
        <translation>Modifica annotazioni</translation>
    </message>
    <message>
        <source>Change Isovalue</source>
        <translation>Modifica isovalore</translation>
    </message>
    <message>
        <source>Change Rendering Mode</source>
        <translation>Modifica modalità di resa</translation>
    </message>
    <message>
        <source>Change Transfer Function</source>
        <translation>Modifica funzione di trasferimento</translation>
    </message>
    <message>
        <source>Change Rendering</source>
        <translation>Modifica resa</translation>
    </message>
    <message>
        <source>Change Focus</source>
        <translation>Modifica focus</translation>
    </message>
    <message>
        <source>Change Crop Box</source>
        <translation>Modifica finestra</translation>
    </message>
    <message>
        <source>Change Values</source>
        <translation>Modifica valori</translation>
    </message>
    <message>
        <source>Change Budget</source>
        <translation>Modifica budget</translation>
    </message>
    <message>
        <source>Change Accuracy</source>
        <translation>Modifica accuratezza</translation>
    </message>
    <message>
        <source>Change Background</source>
        <translation>Modifica sfondo</translation>
    </message>
    <message>
        <source>Move Camera</source>
        <translation>Sposta la camera</translation>
    </message>
    <message>
        <source>Remove Isovalue</source>
        <translation>Rimuovi isovalore</translation>
    </message>
    <message>
        <source>Change Range</source>
        <translation>Modifica intervallo</translation>
    </message>
    <message>
        <source>Change Warping</source>
        <translation>Modifica deformazione</translation>
    </message>
    <message>
        <source>Change Lens</source>
        <translation>Modifica lente</translation>
    </message>
    <message>
        <source>Change Tool</source>
        <translation>Modifica strumento</translation>
    </message>
    <message>
        <source>Change Bookmarks</source>
        <translation>Modifica segnalibri</translation>
    </message>
</context>
<context>
    <name>Desktop</name>
    <message>
        <source>There is no display for the window: neither DISPLAY nor WAYLAND_DISPLAY is set. “tan render” draws pictures into files instead; “tan --help” lists what else works without a window.</source>
        <translation>Non c&apos;è uno schermo per la finestra: né DISPLAY né WAYLAND_DISPLAY è impostata. «tan render» disegna invece le immagini in file; «tan --help» dice che cos&apos;altro funziona senza finestra.</translation>
    </message>
    <message>
        <source>Shows volume data at any accuracy.</source>
        <translation>Mostra dati di volume con qualsiasi accuratezza.</translation>
    </message>
    <message>
        <source>Rendering back end: auto, cpu or gl.</source>
        <translation>Che cosa disegna l&apos;immagine: auto, cpu o gl.</translation>
    </message>
    <message>
        <source>A dataset, a .tan model or a session to open; each opens in its own window.</source>
        <translation>Un insieme di dati, un modello .tan o una sessione da aprire; ciascuno in una finestra propria.</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Build</source>
        <translation>Costruzione</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Accuratezza</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Rendering</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isovalori</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Focus</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Regione</translation>
    </message>
    <message>
        <source>How far the mesh may deviate from the data, in percent of the value range; or how many tetrahedra it may have. The curve shows what each error costs.</source>
        <translation>Di quanto la mesh può scostarsi dai dati, in percento dell&apos;intervallo dei valori, oppure quanti tetraedri può avere. La curva mostra quanto costa ogni errore.</translation>
    </message>
    <message>
        <source>Rendering mode and its settings: surfaces, volume or both.</source>
        <translation>Modo di rendering e impostazioni: superfici, volume o entrambi.</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistiche</translation>
    </message>
    <message>
        <source>What each accuracy costs in vertices, tetrahedra, time and memory, and the figures of the displayed mesh.</source>
        <translation>Quanto costa ogni accuratezza in vertici, tetraedri, tempo e memoria, e la mesh mostrata in numeri.</translation>
    </message>
    <message>
        <source>Surfaces on which the field has a given value, in data units.</source>
        <translation>Superfici su ciascuna delle quali il campo ha un solo valore, nelle unità dei dati.</translation>
    </message>
    <message>
        <source>A sphere or a box in which the mesh is more accurate than outside.</source>
        <translation>Una sfera o un parallelepipedo in cui la mesh è più accurata che all&apos;esterno.</translation>
    </message>
    <message>
        <source>Which part of the domain is shown: a crop box, and a range of values.</source>
        <translation>Quale parte del dominio si mostra: un parallelepipedo e un intervallo di valori.</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animazione</translation>
    </message>
    <message>
        <source>Films of the model: a turntable, or a path through key frames of your choice.</source>
        <translation>Filmati del modello: un giro completo, o un percorso tra fotogrammi chiave a scelta.</translation>
    </message>
    <message>
        <source>Transfer</source>
        <translation>Trasferimento</translation>
    </message>
    <message>
        <source>Build a model from a dataset once; a mesh is then available at any accuracy. Choose a builder and a file, and press Build.</source>
        <translation>Il modello si costruisce una volta sola da un insieme di dati; la sua mesh è poi disponibile con qualsiasi accuratezza. Scegliere un metodo e un file, e premere «Costruisci».</translation>
    </message>
    <message>
        <source>The camera settings as numbers. In the picture: drag to turn, Shift+drag to move, use the wheel to zoom.</source>
        <translation>La camera in numeri. Nell&apos;immagine: trascinare per ruotare, Maiusc e trascinare per spostare, la rotella ingrandisce.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Strumenti</translation>
    </message>
    <message>
        <source>What the chosen tool can do and what it measures. In the picture: click a place, drag a handle; Return selects the next handle, and arrow keys move it.</source>
        <translation>Ciò che lo strumento scelto può fare e ciò che misura. Nell&apos;immagine: fare clic su un punto, trascinare una maniglia; Invio seleziona la maniglia successiva e i tasti freccia la muovono.</translation>
    </message>
</context>
<context>
    <name>EditorPage</name>
    <message>
        <source>The editor cannot be used. %1</source>
        <translation>L&apos;editor non si può usare. %1</translation>
    </message>
    <message>
        <source>Help › Plugins lists all plugins and the folders that are searched for them.</source>
        <translation>Aiuto › Plugin elenca tutti i plugin e dove vengono cercati.</translation>
    </message>
    <message>
        <source>The mode %1 does not use a transfer function. Changes appear in other modes.</source>
        <translation>La modalità %1 non mostra alcuna funzione di trasferimento. Le modifiche si vedono in altre modalità.</translation>
    </message>
    <message>
        <source>The mode %1 has nothing to edit here. Choose another mode.</source>
        <translation>La modalità %1 non ha nulla da modificare qui. Scegliere un&apos;altra modalità.</translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Open a Dataset or a Model</source>
        <translation>Apri un insieme di dati o un modello</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Salva immagine</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Immagini PNG (*.png)</translation>
    </message>
    <message>
        <source>Save Statistics</source>
        <translation>Salva statistiche</translation>
    </message>
    <message>
        <source>Tables of comma-separated values (*.csv)</source>
        <translation>Tabelle di valori separati da virgole (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>TIFF pictures (*.tif *.tiff)</source>
        <translation>Immagini TIFF (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>JPEG pictures (*.jpg *.jpeg)</source>
        <translation>Immagini JPEG (*.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>File PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>HelpActions</name>
    <message>
        <source>Restart TAn to change the language.</source>
        <translation>Riavviare TAn per cambiare lingua.</translation>
    </message>
    <message>
        <source>&amp;As the System</source>
        <translation>&amp;Come il sistema</translation>
    </message>
</context>
<context>
    <name>ImportForm</name>
    <message>
        <source>%1 (of the cells)</source>
        <translation>%1 (delle celle)</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Modulo</translation>
    </message>
    <message>
        <source>%1: t = %2</source>
        <translation>%1: t = %2</translation>
    </message>
    <message>
        <source>All that go together</source>
        <translation>Tutti quelli compatibili fra loro</translation>
    </message>
    <message>
        <source>%1, %2 components</source>
        <translation>%1, %2 componenti</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatico</translation>
    </message>
</context>
<context>
    <name>ImportTexts</name>
    <message>
        <source>%1 = %2 bytes: exactly the size of the file.</source>
        <translation>%1 = %2 byte: il file ne ha esattamente tanti.</translation>
    </message>
    <message>
        <source>All %1 = %2 points.</source>
        <translation>Tutti i %1 = %2 punti.</translation>
    </message>
    <message>
        <source>%1 = %2 of %3 points.</source>
        <translation>%1 = %2 di %3 punti.</translation>
    </message>
    <message>
        <source>The build takes about %1 of memory, %2 of disk and %3.</source>
        <translation>La costruzione richiede circa %1 di memoria, %2 di disco e %3.</translation>
    </message>
    <message>
        <source>The build takes up to %1 of memory, %2 of disk and %3.</source>
        <translation>La costruzione richiede fino a %1 di memoria, %2 di disco e %3.</translation>
    </message>
    <message>
        <source>This machine has %1 of memory.</source>
        <translation>Questo computer ha %1 di memoria.</translation>
    </message>
    <message>
        <source>A volume needs at least two points along each axis. Choose a larger region or a smaller stride.</source>
        <translation>Un volume richiede almeno due punti lungo ogni asse. Prendere una regione più grande o un passo più piccolo.</translation>
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
        <translation>%1 = %2 byte; il file ne ha %3 (%4 mancanti).</translation>
    </message>
    <message>
        <source>%1 = %2 bytes; the file has %3 (%4 too many).</source>
        <translation>%1 = %2 byte; il file ne ha %3 (%4 in più).</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>en</source>
        <translation>it</translation>
    </message>
</context>
<context>
    <name>LogarithmText</name>
    <message>
        <source>a factor of %1</source>
        <translation>fattore %1</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>No web browser was found on this computer. Install one, or read %1.</source>
        <translation>Qui nessun programma apre pagine web. Installare un browser, oppure leggere %1.</translation>
    </message>
    <message>
        <source>The manual is not installed. Reinstall the package tan with its documentation, or build TAn on a system that has Sphinx (python3-sphinx, python3-myst-parser, furo); the same texts are in the folder docs of the source code.</source>
        <translation>Il manuale non è installato. Installare di nuovo il pacchetto tan con la sua documentazione, oppure compilare TAn dove Sphinx è installato (python3-sphinx, python3-myst-parser, furo); gli stessi testi sono nella cartella docs dei sorgenti.</translation>
    </message>
</context>
<context>
    <name>MeshText</name>
    <message>
        <source>Limited by the budget of %1 tetrahedra.</source>
        <translation>Limitato dal budget di %1 tetraedri.</translation>
    </message>
    <message>
        <source>Full resolution of the model.</source>
        <translation>Risoluzione piena del modello.</translation>
    </message>
    <message>
        <source>The model contains no finer level.</source>
        <translation>Il modello non contiene livelli più fini.</translation>
    </message>
    <message>
        <source>%1 of its %2 tetrahedra are shown.</source>
        <translation>Si mostrano %1 dei suoi %2 tetraedri.</translation>
    </message>
    <message>
        <source>Shown: %1, and the same warping.</source>
        <translation>Mostrato: %1, deformazione uguale.</translation>
    </message>
    <message>
        <source>Shown: %1.</source>
        <translation>Mostrato: %1.</translation>
    </message>
    <message>
        <source>%1 tetrahedra in %2 pieces, cut by the crop box</source>
        <translation>%1 tetraedri in %2 pezzi, tagliati dalla finestra</translation>
    </message>
    <message>
        <source>Shown: tetrahedra of the meshes of %1. %2 of %3 are selected.</source>
        <translation>Mostrati: tetraedri delle mesh (%1). Scelti %2 su %3.</translation>
    </message>
    <message>
        <source>Shown: %1, warping %2.</source>
        <translation>Mostrato: %1, deformazione %2.</translation>
    </message>
    <message>
        <source>Shown: %1, with any warping.</source>
        <translation>Mostrato: %1, qualunque sia la deformazione.</translation>
    </message>
    <message>
        <source>in the grid; in space up to %1</source>
        <translation>nella griglia; nello spazio fino a %1</translation>
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
        <translation>Arancione</translation>
    </message>
    <message>
        <source>Sky blue</source>
        <translation>Celeste</translation>
    </message>
    <message>
        <source>Bluish green</source>
        <translation>Verde bluastro</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Vermiglio</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blu</translation>
    </message>
    <message>
        <source>Reddish purple</source>
        <translation>Porpora rossastro</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Giallo</translation>
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
        <translation>Ora non è possibile</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Pannello</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Accuratezza</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>Only in %1</source>
        <translation>Solo con %1</translation>
    </message>
</context>
<context>
    <name>Places</name>
    <message>
        <source>%1, at its server</source>
        <translation>%1, sul suo server</translation>
    </message>
</context>
<context>
    <name>PluginChoice</name>
    <message>
        <source>Boundary: %1</source>
        <translation>Contorno: %1</translation>
    </message>
</context>
<context>
    <name>PresetNames</name>
    <message>
        <source>Cool to warm</source>
        <translation>Da freddo a caldo</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grigi</translation>
    </message>
    <message>
        <source>Sequential: opaque where values are large</source>
        <translation>Crescente: opaca dove i valori sono grandi</translation>
    </message>
    <message>
        <source>Diverging: opaque at both ends</source>
        <translation>Divergente: opaca ai due estremi</translation>
    </message>
    <message>
        <source>CT: bone</source>
        <translation>TC: ossa</translation>
    </message>
    <message>
        <source>CT: skin and bone</source>
        <translation>TC: pelle e ossa</translation>
    </message>
    <message>
        <source>CT: skin</source>
        <translation>TC: pelle</translation>
    </message>
    <message>
        <source>CT: muscle and soft tissue</source>
        <translation>TC: muscoli e tessuti molli</translation>
    </message>
    <message>
        <source>CT: fat</source>
        <translation>TC: grasso</translation>
    </message>
    <message>
        <source>CT: lung</source>
        <translation>TC: polmoni</translation>
    </message>
    <message>
        <source>CT: vessels with contrast medium</source>
        <translation>TC: vasi con mezzo di contrasto</translation>
    </message>
    <message>
        <source>CT: heart with contrast medium</source>
        <translation>TC: cuore con mezzo di contrasto</translation>
    </message>
    <message>
        <source>CT: organs of the abdomen</source>
        <translation>TC: organi dell&apos;addome</translation>
    </message>
    <message>
        <source>CT: teeth</source>
        <translation>TC: denti</translation>
    </message>
    <message>
        <source>CT: metal and implants</source>
        <translation>TC: metallo e impianti</translation>
    </message>
    <message>
        <source>CT: like an X-ray picture</source>
        <translation>TC: come una radiografia</translation>
    </message>
    <message>
        <source>MR: head</source>
        <translation>RM: testa</translation>
    </message>
    <message>
        <source>MR: brain</source>
        <translation>RM: cervello</translation>
    </message>
    <message>
        <source>MR: vessels (angiography)</source>
        <translation>RM: vasi (angiografia)</translation>
    </message>
    <message>
        <source>MR: bright tissue</source>
        <translation>RM: tessuto chiaro</translation>
    </message>
    <message>
        <source>Metal part</source>
        <translation>Pezzo di metallo</translation>
    </message>
    <message>
        <source>Metal and pores</source>
        <translation>Metallo e pori</translation>
    </message>
    <message>
        <source>Stone and pores</source>
        <translation>Pietra e pori</translation>
    </message>
    <message>
        <source>Fire: glowing where values are large</source>
        <translation>Fuoco: ardente dove i valori sono grandi</translation>
    </message>
    <message>
        <source>Smoke and clouds</source>
        <translation>Fumo e nuvole</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Acqua</translation>
    </message>
    <message>
        <source>Layers: five shells</source>
        <translation>Strati: cinque gusci</translation>
    </message>
    <message>
        <source>Sequential: opaque where values are small</source>
        <translation>Sequenziale: opaca dove i valori sono piccoli</translation>
    </message>
    <message>
        <source>Blue to orange</source>
        <translation>Da blu ad arancione</translation>
    </message>
    <message>
        <source>Categories</source>
        <translation>Categorie</translation>
    </message>
    <message>
        <source>Plasma: opaque where values are large</source>
        <translation>Plasma: opaca dove i valori sono grandi</translation>
    </message>
    <message>
        <source>Turbo: opaque where values are large</source>
        <translation>Turbo: opaca dove i valori sono grandi</translation>
    </message>
    <message>
        <source>Categories: seven colours, evenly opaque</source>
        <translation>Categorie: sette colori, opacità uniforme</translation>
    </message>
</context>
<context>
    <name>RescaleDialog</name>
    <message>
        <source>Rescale Transfer Function</source>
        <translation>Riscala funzione di trasferimento</translation>
    </message>
    <message>
        <source>Value of the first point, in data units</source>
        <translation>Valore del primo punto, nelle unità dei dati</translation>
    </message>
    <message>
        <source>Value of the last point, in data units</source>
        <translation>Valore dell&apos;ultimo punto, nelle unità dei dati</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Da</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;A</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>%1 points</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>%1 × %1 × %1 points</source>
        <translation>%1 × %1 × %1 punti</translation>
    </message>
    <message>
        <source>Buckyball</source>
        <translation>Fullerene</translation>
    </message>
    <message>
        <source>Electron density of a C60 molecule; regular grid, %1, computed by TAn. See the cage of atoms as an isosurface, and how few tetrahedra are enough for an error of 1 %.</source>
        <translation>Densità elettronica di una molecola C60; reticolo regolare, %1, calcolato da TAn. Da guardare: la gabbia di atomi come isosuperficie, e quanti pochi tetraedri bastano per un errore dell&apos;1 %.</translation>
    </message>
    <message>
        <source>Hydrogen atom</source>
        <translation>Atomo di idrogeno</translation>
    </message>
    <message>
        <source>Probability density of the 3d electron; regular grid, %1, computed by TAn. See the two lobes and the ring, as a volume or as isosurfaces.</source>
        <translation>Densità di probabilità dell&apos;elettrone 3d; reticolo regolare, %1, calcolato da TAn. Da guardare: i due lobi e l&apos;anello, come volume o come isosuperfici.</translation>
    </message>
    <message>
        <source>Supersonic flow</source>
        <translation>Flusso supersonico</translation>
    </message>
    <message>
        <source>Density in front of a hemisphere; curvilinear grid, %1, computed by TAn. See the bow shock, and how the grid follows the body.</source>
        <translation>Densità davanti a una semisfera; griglia curvilinea, %1, calcolata da TAn. Da guardare: l&apos;onda d&apos;urto, e la griglia che segue il corpo.</translation>
    </message>
    <message>
        <source>Flow around a cylinder</source>
        <translation>Flusso su cilindro</translation>
    </message>
    <message>
        <source>Pressure of the flow; curvilinear grid that closes on itself, %1, computed by TAn. See the front, where the flow is stopped, and the sides, where it is fastest.</source>
        <translation>Pressione del flusso; griglia curvilinea chiusa su sé stessa, %1, calcolata da TAn. Da guardare: il fronte, dove il flusso si arresta, e i lati, dove è più veloce.</translation>
    </message>
    <message>
        <source>Flow in a duct</source>
        <translation>Flusso in un condotto</translation>
    </message>
    <message>
        <source>Speed in a bent duct; curvilinear grid, %1, computed by TAn. See how the flow keeps to the outer wall of the bend.</source>
        <translation>Velocità in un condotto curvo; griglia curvilinea, %1, calcolata da TAn. Da guardare: come il flusso resta sulla parete esterna della curva.</translation>
    </message>
    <message>
        <source>Plate with holes</source>
        <translation>Piastra forata</translation>
    </message>
    <message>
        <source>Stress in a plate with five holes and a closed cavity; irregular mesh, computed by TAn. See how the boundary keeps its holes at every accuracy.</source>
        <translation>Tensione in una piastra con cinque fori e una cavità chiusa; mesh irregolare, calcolata da TAn. Da guardare: il contorno, che conserva i fori a ogni accuratezza.</translation>
    </message>
    <message>
        <source>Scattered points</source>
        <translation>Punti sparsi</translation>
    </message>
    <message>
        <source>Waves that become finer outwards, sampled at random points in a ball; %1, computed by TAn. See the volume: it needs no grid.</source>
        <translation>Onde sempre più fini verso l&apos;esterno, campionate in punti casuali di una sfera; %1, calcolati da TAn. Da guardare: il volume, che non ha bisogno di griglia.</translation>
    </message>
    <message>
        <source>Ripples</source>
        <translation>Increspature</translation>
    </message>
    <message>
        <source>The test signal of Marschner and Lobb; regular grid, %1, computed by TAn. See the fine ripples, which vanish first as the error grows.</source>
        <translation>Il segnale di prova di Marschner e Lobb; reticolo regolare, %1, calcolato da TAn. Da guardare: le increspature fini, le prime a sparire quando l&apos;errore cresce.</translation>
    </message>
    <message>
        <source>Boundary layer</source>
        <translation>Strato limite</translation>
    </message>
    <message>
        <source>A layer at a wall; rectilinear grid with growing spacing, %1, computed by TAn. See how the tetrahedra crowd at the wall.</source>
        <translation>Uno strato presso una parete; griglia rettilinea a passo crescente, %1, calcolata da TAn. Da guardare: come i tetraedri si addensano alla parete.</translation>
    </message>
    <message>
        <source>White noise</source>
        <translation>Rumore bianco</translation>
    </message>
    <message>
        <source>Random values, the worst case for any method; regular grid, %1, computed by TAn. See the statistics: even at a large error nearly all points are needed.</source>
        <translation>Valori casuali, il caso peggiore per ogni metodo; reticolo regolare, %1, calcolato da TAn. Da guardare: le statistiche, perché anche con un errore grande servono quasi tutti i punti.</translation>
    </message>
</context>
<context>
    <name>Statistics</name>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>± value</source>
        <translation>± valore</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vertici</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedri</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Quota</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memoria</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>Total vertices</source>
        <translation>Vertici in totale</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Mostrato</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 vertici, %2 tetraedri</translation>
    </message>
    <message>
        <source>Guaranteed</source>
        <translation>Garantito</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangoli</translation>
    </message>
    <message>
        <source>Extraction</source>
        <translation>Estrazione</translation>
    </message>
    <message>
        <source>Preparation</source>
        <translation>Preparazione</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Un fotogramma</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Tagliati</translation>
    </message>
    <message>
        <source>Visibility cycles</source>
        <translation>Cicli di visibilità</translation>
    </message>
    <message>
        <source>tetrahedra cut: %1</source>
        <translation>tetraedri tagliati: %1</translation>
    </message>
    <message>
        <source>tetrahedra cut: %1; overlapping groups, drawn by distance: %2</source>
        <translation>tetraedri tagliati: %1; gruppi sovrapposti, disegnati per distanza: %2</translation>
    </message>
    <message>
        <source>Faulty cells</source>
        <translation>Celle difettose</translation>
    </message>
    <message>
        <source>Faulty cells outlined</source>
        <translation>Celle difettose contornate</translation>
    </message>
    <message>
        <source>Used from the file</source>
        <translation>Preso dal file</translation>
    </message>
    <message>
        <source>Not used from the file</source>
        <translation>Non usato del file</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Fattore</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>logarithmic; an error of 1 % is %1</source>
        <translation>logaritmica; un errore dell&apos;1 % corrisponde al %1</translation>
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
        <translation>%1 vertici</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 vertice</translation>
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
        <translation>Errore in percento dell&apos;intervallo dei valori</translation>
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
        <translation>Tetraedri rispetto all&apos;errore</translation>
    </message>
    <message>
        <source>Number of tetrahedra needed for each error. Click, drag or use the arrow keys to choose the accuracy.</source>
        <translation>Numero di tetraedri necessari per ogni errore. Fare clic, trascinare o usare i tasti freccia per scegliere l&apos;accuratezza.</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedri</translation>
    </message>
    <message>
        <source>%1 tetrahedra at an %2 of %3</source>
        <translation>%1 tetraedri con un %2 di %3</translation>
    </message>
    <message>
        <source>%1, % of the value range</source>
        <translation>%1, % dell&apos;intervallo dei valori</translation>
    </message>
</context>
<context>
    <name>tetra::AccuracyPanel</name>
    <message>
        <source>%1 of all</source>
        <translation>%1 del totale</translation>
    </message>
    <message>
        <source>Error of %1 of the value range</source>
        <translation>Errore di %1 dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Every sample exact</source>
        <translation>Ogni campione esatto</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vertici</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedri</translation>
    </message>
    <message>
        <source>Bu&amp;dget</source>
        <translation>&amp;Budget</translation>
    </message>
    <message>
        <source>The smallest mesh with this error</source>
        <translation>La mesh più piccola con questo errore</translation>
    </message>
    <message>
        <source>The best mesh with at most this number of tetrahedra. A focus keeps its ratio to the rest.</source>
        <translation>La mesh migliore con tanti tetraedri. Un focus conserva la sua proporzione col resto.</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tetraedri</translation>
    </message>
    <message>
        <source>Err&amp;or</source>
        <translation>Err&amp;ore</translation>
    </message>
    <message>
        <source>War&amp;ping</source>
        <translation>&amp;Deformazione</translation>
    </message>
    <message>
        <source>Same as the error</source>
        <translation>Come l&apos;errore</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Propria</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuna</translation>
    </message>
    <message>
        <source>Limit of the warping</source>
        <translation>Limite della deformazione</translation>
    </message>
    <message>
        <source>Limit on the warping, the distance of the mesh from the data: the same percentage as the error, but of the diagonal; a percentage of its own; or none, for the smallest mesh whose values are within the error</source>
        <translation>Limite della deformazione, cioè della distanza della mesh dai dati: la percentuale dell&apos;errore, riferita alla diagonale; una propria; oppure nessuno, per la mesh più piccola i cui valori rientrano nell&apos;errore</translation>
    </message>
    <message>
        <source>Warping in percent of the diagonal</source>
        <translation>Deformazione in percento della diagonale</translation>
    </message>
    <message>
        <source>Warping in percent of the diagonal of the data&apos;s bounding box</source>
        <translation>Deformazione in percento della diagonale del parallelepipedo attorno ai dati</translation>
    </message>
    <message>
        <source>The percentages in data units. The warping of curvilinear and irregular data is the distance of the mesh from the data, in percent of the diagonal of the data&apos;s bounding box. Samples just outside the mesh, of irregular data and of grids decimated as a mesh, are compared with a place on its boundary within the warping; at the nearest place the error may be larger, and &apos;tan verify&apos; measures it.</source>
        <translation>Che cosa significano le percentuali nelle unità dei dati. La deformazione di dati curvilinei e irregolari è la distanza della mesh dai dati, in percento della diagonale del parallelepipedo attorno a essi. I campioni di dati irregolari, e di griglie decimate come mesh, che si trovano appena fuori dalla mesh si confrontano con un punto del suo contorno entro la deformazione; nel punto più vicino l&apos;errore può essere maggiore, e «tan verify» lo misura.</translation>
    </message>
    <message>
        <source>This model was built down to an %1 of %2; it contains nothing finer.</source>
        <translation>Questo modello è stato costruito fino a un %1 di %2; non ha nulla di più fine.</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>%1 in value
any warping</source>
        <translation>%1 nel valore
deformazione qualsiasi</translation>
    </message>
    <message>
        <source>%1 in value
warping %2</source>
        <translation>%1 nel valore
deformazione %2</translation>
    </message>
    <message>
        <source>of the range
%1</source>
        <translation>dell&apos;intervallo
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
        <translation>Errore in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Error in percent of the value range: coarse on the left, every sample exact on the right</source>
        <translation>Errore in percento dell&apos;intervallo dei valori: grossolano a sinistra, ogni campione esatto a destra</translation>
    </message>
</context>
<context>
    <name>tetra::AddressDialog</name>
    <message>
        <source>Access token issued by the server&apos;s operator; forgotten when TAn quits</source>
        <translation>Quello stabilito da chi gestisce il server; viene conservato fino alla chiusura del programma</translation>
    </message>
    <message>
        <source>&amp;Token:</source>
        <translation>&amp;Token:</translation>
    </message>
    <message>
        <source>&amp;Fetch the model</source>
        <translation>&amp;Scaricare il modello</translation>
    </message>
    <message>
        <source>&amp;Leave the model at the server</source>
        <translation>&amp;Lasciare il modello sul server</translation>
    </message>
    <message>
        <source>Open URL</source>
        <translation>Apri URL</translation>
    </message>
    <message>
        <source>&amp;Address of a model on a server:</source>
        <translation>&amp;Indirizzo di un modello su un server:</translation>
    </message>
    <message>
        <source>Address of the model, packed or not: http:// or https://</source>
        <translation>Dove si trova il modello, compresso o no: http:// o https://</translation>
    </message>
    <message>
        <source>The server extracts each mesh and sends only that: for models too large for this computer. Every change waits for the network.</source>
        <translation>Il server trova ogni mesh e invia solo quella: per modelli troppo grandi per questo computer. Ogni modifica aspetta la rete.</translation>
    </message>
    <message>
        <source>Requires a TAn server: &apos;tan serve&apos;</source>
        <translation>Se il server è uno di TAn: «tan serve»</translation>
    </message>
    <message>
        <source>This server requires a token.</source>
        <translation>Questo server risponde solo a chi ha il suo token.</translation>
    </message>
    <message>
        <source>Wrong token.</source>
        <translation>Questo non è il token del server.</translation>
    </message>
    <message>
        <source>%L1 vertices, %2.</source>
        <translation>%L1 vertici, %2.</translation>
    </message>
    <message>
        <source>%1 packed, %2 unpacked</source>
        <translation>%1 compressi, %2 decompressi</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>The server of %1 requires its &amp;token:</source>
        <translation>Il server di %1 risponde solo a chi ha il suo &amp;token:</translation>
    </message>
    <message>
        <source>Downloads only what is needed; cached afterwards.</source>
        <translation>Arriva su questo computer per quanto serve, e da lì in poi è veloce.</translation>
    </message>
    <message>
        <source>An address begins with http:// or https://.</source>
        <translation>Un indirizzo comincia con http:// o https://.</translation>
    </message>
    <message>
        <source>Asking the server…</source>
        <translation>Richiesta al server…</translation>
    </message>
    <message>
        <source>This server only delivers files, so the model must be downloaded.</source>
        <translation>Questo server fornisce soltanto file: il modello va scaricato.</translation>
    </message>
    <message>
        <source>%1 That is more than this computer has room for: leave it at the server.</source>
        <translation>%1 È più di quanto stia in questo computer: lasciarlo sul server.</translation>
    </message>
</context>
<context>
    <name>tetra::AnimationPanel</name>
    <message>
        <source>&amp;Save Film…</source>
        <translation>&amp;Salva filmato…</translation>
    </message>
    <message>
        <source>Kind of film</source>
        <translation>Tipo di filmato</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Giro completo</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Fotogrammi chiave</translation>
    </message>
    <message>
        <source>Turntable, or a camera path through key frames</source>
        <translation>Giro completo, o percorso della camera per fotogrammi chiave</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fotogrammi/s</translation>
    </message>
    <message>
        <source>Frames per second of the film</source>
        <translation>Fotogrammi al secondo del filmato</translation>
    </message>
    <message>
        <source>Write it as pictures or a video</source>
        <translation>Lo scrive come immagini o come video</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Tipo</translation>
    </message>
    <message>
        <source>Ra&amp;te</source>
        <translation>&amp;Cadenza</translation>
    </message>
    <message>
        <source>Axis to turn around</source>
        <translation>Asse di rotazione</translation>
    </message>
    <message>
        <source>Around the vertical axis</source>
        <translation>Attorno all&apos;asse verticale</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>In su e in giù</translation>
    </message>
    <message>
        <source>Angle to turn by</source>
        <translation>Angolo di rotazione</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Number of frames</source>
        <translation>Numero di fotogrammi</translation>
    </message>
    <message>
        <source>Number of frames of the film</source>
        <translation>Numero di fotogrammi del filmato</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>A&amp;sse</translation>
    </message>
    <message>
        <source>An&amp;gle</source>
        <translation>An&amp;golo</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Fotogrammi</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotogramma</translation>
    </message>
    <message>
        <source>Frame shown</source>
        <translation>Fotogramma mostrato</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 fotogrammi, %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ferma</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Riproduci</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Fotogrammi al secondo</translation>
    </message>
    <message>
        <source>Up and down: the camera returns to its start and stops at the poles</source>
        <translation>In su e in giù: la camera torna al punto di partenza, e si ferma ai poli</translation>
    </message>
    <message>
        <source>Angle to turn by, in degrees; negative turns the other way</source>
        <translation>Angolo di rotazione, in gradi; se negativo, nel verso opposto</translation>
    </message>
    <message>
        <source>Add at least two views.</source>
        <translation>Aggiungere almeno due viste.</translation>
    </message>
</context>
<context>
    <name>tetra::AnnotationRows</name>
    <message>
        <source>Top left</source>
        <translation>In alto a sinistra</translation>
    </message>
    <message>
        <source>Top right</source>
        <translation>In alto a destra</translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation>In basso a sinistra</translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation>In basso a destra</translation>
    </message>
    <message>
        <source>Corner of the picture</source>
        <translation>Angolo dell&apos;immagine</translation>
    </message>
    <message>
        <source>%1: corner</source>
        <translation>%1: angolo</translation>
    </message>
    <message>
        <source>Fixed ends</source>
        <translation>Estremi fissi</translation>
    </message>
    <message>
        <source>The colour bar covers a chosen range, so that several pictures can share it; otherwise it covers all values of the data</source>
        <translation>La barra dei colori va da un valore scelto a un altro, così che più immagini abbiano la stessa; altrimenti copre tutti i valori dei dati</translation>
    </message>
    <message>
        <source>Colour bar: smaller end</source>
        <translation>Barra dei colori: estremo minore</translation>
    </message>
    <message>
        <source>Value at the lower end of the colour bar</source>
        <translation>Valore all&apos;estremo inferiore della barra dei colori</translation>
    </message>
    <message>
        <source>Colour bar: larger end</source>
        <translation>Barra dei colori: estremo maggiore</translation>
    </message>
    <message>
        <source>Value at the upper end of the colour bar</source>
        <translation>Valore all&apos;estremo superiore della barra dei colori</translation>
    </message>
    <message>
        <source>Text of the title</source>
        <translation>Testo del titolo</translation>
    </message>
    <message>
        <source>The title; if empty, the name of the model</source>
        <translation>Il titolo; se vuoto, il nome del modello</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandezza</translation>
    </message>
    <message>
        <source>Colour bar: quantity</source>
        <translation>Barra dei colori: grandezza</translation>
    </message>
    <message>
        <source>What the colour bar shows, such as density; if empty, the name of the values in the data</source>
        <translation>Che cosa mostra la barra dei colori, per esempio la densità; se vuoto, il nome dei valori nei dati</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Colour bar: unit</source>
        <translation>Barra dei colori: unità</translation>
    </message>
    <message>
        <source>The unit of the values, such as HU or K, written in brackets behind the quantity</source>
        <translation>L&apos;unità dei valori, per esempio HU o K, scritta tra parentesi dopo la grandezza</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Numeri</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatico</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Per esteso</translation>
    </message>
    <message>
        <source>Powers of ten</source>
        <translation>Potenze di dieci</translation>
    </message>
    <message>
        <source>Colour bar: format of the numbers</source>
        <translation>Barra dei colori: formato dei numeri</translation>
    </message>
    <message>
        <source>How the numbers at the colour bar are written: as short as tells them apart, or with a chosen number of decimals, plain or in powers of ten</source>
        <translation>Come si scrivono i numeri sulla barra dei colori: tanto brevi quanto basta a distinguerli, o con un numero scelto di decimali, per esteso o in potenze di dieci</translation>
    </message>
    <message>
        <source>Colour bar: decimals</source>
        <translation>Barra dei colori: decimali</translation>
    </message>
    <message>
        <source>Number of digits behind the decimal point</source>
        <translation>Numero di cifre dopo la virgola</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>Grassetto</translation>
    </message>
    <message>
        <source>Lengths: format of the numbers</source>
        <translation>Lunghezze: formato dei numeri</translation>
    </message>
    <message>
        <source>How the numbers of the scale bar and of the axes are written: as short as tells them apart, or with a chosen number of decimals, plain or in powers of ten</source>
        <translation>Come si scrivono i numeri della barra di scala e degli assi: tanto brevi quanto basta a distinguerli, o con un numero scelto di decimali, per esteso o in potenze di dieci</translation>
    </message>
    <message>
        <source>Lengths: decimals</source>
        <translation>Lunghezze: decimali</translation>
    </message>
    <message>
        <source>Annotations: size of the text</source>
        <translation>Annotazioni: dimensione del testo</translation>
    </message>
    <message>
        <source>How large the texts of all annotations are; bars, arrows and lines grow with them</source>
        <translation>Quanto sono grandi i testi di tutte le annotazioni; barre, frecce e linee crescono con essi</translation>
    </message>
    <message>
        <source>Write all annotations in bold letters</source>
        <translation>Scrive tutte le annotazioni in grassetto</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Lunghezze</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Dimensione testo</translation>
    </message>
</context>
<context>
    <name>tetra::BookmarkActions</name>
    <message>
        <source>&amp;Add Bookmark</source>
        <translation>&amp;Aggiungi segnalibro</translation>
    </message>
    <message>
        <source>Keep the current view as a bookmark, which the session saves</source>
        <translation>Conserva la vista attuale come segnalibro, che la sessione salva</translation>
    </message>
    <message>
        <source>&amp;Edit Bookmarks…</source>
        <translation>&amp;Modifica segnalibri…</translation>
    </message>
    <message>
        <source>Show, rename, replace, move and remove bookmarks</source>
        <translation>Mostra, rinomina, sostituisce, sposta ed elimina i segnalibri</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>Show this bookmark</source>
        <translation>Mostra questo segnalibro</translation>
    </message>
</context>
<context>
    <name>tetra::BookmarkDialog</name>
    <message>
        <source>Bookmarks</source>
        <translation>Segnalibri</translation>
    </message>
    <message>
        <source>Enter shows a bookmark, F2 renames it, Delete removes it, Alt with an arrow moves it</source>
        <translation>Invio mostra un segnalibro, F2 lo rinomina, Canc lo elimina, Alt con una freccia lo sposta</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Aggiungi</translation>
    </message>
    <message>
        <source>Add the current view as a bookmark</source>
        <translation>Aggiunge la vista attuale come segnalibro</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>Show this bookmark (Enter)</source>
        <translation>Mostra questo segnalibro (Invio)</translation>
    </message>
    <message>
        <source>Re&amp;place</source>
        <translation>&amp;Sostituisci</translation>
    </message>
    <message>
        <source>Replace this bookmark with the current view</source>
        <translation>Sostituisce questo segnalibro con la vista attuale</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Rinomina</translation>
    </message>
    <message>
        <source>Rename this bookmark (F2)</source>
        <translation>Rinomina questo segnalibro (F2)</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Sposta s&amp;u</translation>
    </message>
    <message>
        <source>Swap with the previous bookmark (Alt+Up)</source>
        <translation>Scambia con il segnalibro precedente (Alt+Su)</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Sposta &amp;giù</translation>
    </message>
    <message>
        <source>Swap with the next bookmark (Alt+Down)</source>
        <translation>Scambia con il segnalibro successivo (Alt+Giù)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Elimina</translation>
    </message>
    <message>
        <source>Remove this bookmark (Delete)</source>
        <translation>Elimina questo segnalibro (Canc)</translation>
    </message>
</context>
<context>
    <name>tetra::BudgetBox</name>
    <message>
        <source>Most tetrahedra</source>
        <translation>Massimo di tetraedri</translation>
    </message>
    <message>
        <source>The best mesh with at most this number of tetrahedra</source>
        <translation>La mesh migliore entro questo numero di tetraedri</translation>
    </message>
</context>
<context>
    <name>tetra::BuildPanel</name>
    <message>
        <source>Open a dataset to build a model of it.</source>
        <translation>Aprire un insieme di dati per costruirne il modello.</translation>
    </message>
    <message>
        <source>Builder</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>How the model is built</source>
        <translation>Come si costruisce il modello</translation>
    </message>
    <message>
        <source>B&amp;uilder</source>
        <translation>Met&amp;odo</translation>
    </message>
    <message>
        <source>Model file</source>
        <translation>File del modello</translation>
    </message>
    <message>
        <source>Model file to write</source>
        <translation>File del modello da scrivere</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Sfoglia…</translation>
    </message>
    <message>
        <source>&amp;Model file</source>
        <translation>Fi&amp;le del modello</translation>
    </message>
    <message>
        <source>Progress of the build</source>
        <translation>Avanzamento della costruzione</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnulla</translation>
    </message>
    <message>
        <source>Stop the build and discard the result</source>
        <translation>Ferma la costruzione e scarta il risultato</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>F&amp;erma e conserva</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annullamento…</translation>
    </message>
    <message>
        <source>Keeping what is finished…</source>
        <translation>Si conserva ciò che è pronto…</translation>
    </message>
    <message>
        <source>&amp;Build and Replace</source>
        <translation>&amp;Costruisci e sostituisci</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Costruisci</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Avvio…</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, ancora %2</translation>
    </message>
    <message>
        <source>Model File</source>
        <translation>File del modello</translation>
    </message>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelli (*.tan)</translation>
    </message>
    <message>
        <source>%1 scattered points</source>
        <translation>%1 punti sparsi</translation>
    </message>
    <message>
        <source>irregular mesh of %1 points, %2 tetrahedra</source>
        <translation>mesh irregolare di %1 punti, %2 tetraedri</translation>
    </message>
    <message>
        <source>curvilinear grid of %1 points, %2 cells</source>
        <translation>griglia curvilinea di %1 punti, %2 celle</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 campioni</translation>
    </message>
    <message>
        <source>%1, %2, values %3 to %4</source>
        <translation>%1, %2, valori da %3 a %4</translation>
    </message>
    <message>
        <source>&amp;Import Options…</source>
        <translation>Opzioni di &amp;importazione…</translation>
    </message>
    <message>
        <source>Estimated from a few thousand samples of the dataset; it may be off by a factor of two</source>
        <translation>Stimato da qualche migliaio di campioni; può discostarsi di un fattore due</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Qui&amp;ck look, error 1 %</source>
        <translation>&amp;Rapido, errore 1 %</translation>
    </message>
    <message>
        <source>Keeps enough for an error of 1 % of the value range: enough for a first look</source>
        <translation>Conserva ciò che serve per un errore dell&apos;1 % dell&apos;intervallo dei valori: basta per un primo sguardo</translation>
    </message>
    <message>
        <source>&amp;Good, error 0.1 %</source>
        <translation>&amp;Buono, errore 0,1 %</translation>
    </message>
    <message>
        <source>Keeps enough for an error of 0.1 % of the value range: pictures can hardly be told from those of the full data</source>
        <translation>Conserva ciò che serve per un errore dello 0,1 % dell&apos;intervallo dei valori: le immagini si distinguono appena da quelle dei dati completi</translation>
    </message>
    <message>
        <source>&amp;Everything</source>
        <translation>&amp;Tutto</translation>
    </message>
    <message>
        <source>Keeps every value of the dataset, so that any accuracy can be shown later</source>
        <translation>Conserva ogni valore dell&apos;insieme di dati, così poi si può mostrare qualsiasi accuratezza</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Dettaglio</translation>
    </message>
    <message>
        <source>Detail (model size, build time)</source>
        <translation>Dettaglio (dimensione del modello, tempo di costruzione)</translation>
    </message>
    <message>
        <source>rectilinear grid of %1 points, %2 cells</source>
        <translation>griglia rettilinea di %1 punti, %2 celle</translation>
    </message>
    <message>
        <source>Re&amp;sume if interrupted</source>
        <translation>Ri&amp;prendibile se interrotta</translation>
    </message>
    <message>
        <source>Save checkpoints so that the build can be paused and resumed, even after a crash. Short builds take up to 20 % longer, and until the build ends it needs up to three times the model&apos;s size on disk</source>
        <translation>Annota di tanto in tanto a che punto è la costruzione, così che si possa mettere in pausa e riprenda da dove era se il programma o il computer si arresta. Le costruzioni brevi durano fino a un quinto in più e, fino alla fine della costruzione, su disco si occupa fino al triplo della dimensione del modello</translation>
    </message>
    <message>
        <source>St&amp;art Over</source>
        <translation>Ricomincia &amp;da capo</translation>
    </message>
    <message>
        <source>Delete the interrupted build</source>
        <translation>Elimina ciò che la costruzione interrotta ha lasciato</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>Pa&amp;usa</translation>
    </message>
    <message>
        <source>Stop the build; it can be resumed later, even after TAn has been closed</source>
        <translation>Ferma la costruzione; più tardi riprende da lì, anche se intanto il programma viene chiuso</translation>
    </message>
    <message>
        <source>Resume &amp;Build</source>
        <translation>Riprendi &amp;costruzione</translation>
    </message>
    <message>
        <source>An interrupted build of these data was found: it will continue where it stopped.</source>
        <translation>È stata trovata una costruzione interrotta di questi dati: riprende da dove si era fermata.</translation>
    </message>
    <message>
        <source>Found an interrupted build of different data or with different options. Restore those options, or start over.</source>
        <translation>È stata trovata una costruzione interrotta di altri dati o con altre opzioni. Indicare gli stessi, oppure ricominciare da capo.</translation>
    </message>
    <message>
        <source>Pausing…</source>
        <translation>Messa in pausa…</translation>
    </message>
    <message>
        <source>&amp;Open the Existing Model</source>
        <translation>Apri il modello &amp;già esistente</translation>
    </message>
    <message>
        <source>Open the existing model; nothing is built or replaced</source>
        <translation>Apre il modello che c&apos;è già; nulla viene costruito o sostituito</translation>
    </message>
    <message>
        <source>Stop the build and keep what is finished as a model, with the accuracy reached so far. A finished model of the same name is not changed.</source>
        <translation>Ferma la costruzione e conserva ciò che è pronto come modello, con l&apos;accuratezza raggiunta. Un modello finito con lo stesso nome resta com&apos;è.</translation>
    </message>
    <message>
        <source>This file exists. You can open it; if you build, it is replaced when the build is complete.</source>
        <translation>Questo file esiste. Si può aprirlo; se si costruisce, viene sostituito a costruzione finita.</translation>
    </message>
    <message>
        <source>This exists and is not a model. Choose another name.</source>
        <translation>Esiste già e non è un modello. Scegliere un altro nome.</translation>
    </message>
    <message>
        <source>spacing %1</source>
        <translation>spaziatura %1</translation>
    </message>
    <message>
        <source>Scale: logarithmic; an error of 1 % is %1</source>
        <translation>Scala: logaritmica; un errore dell&apos;1 % corrisponde al %1</translation>
    </message>
    <message>
        <source>Scale: linear. The values span several powers of ten: with the logarithmic scale in Import Options, errors are factors.</source>
        <translation>Scala: lineare. I valori coprono più potenze di dieci: con la scala logaritmica nelle opzioni di importazione gli errori sono fattori.</translation>
    </message>
    <message>
        <source>Read the file again with other options: other values, another scale, a part of it, or fewer points</source>
        <translation>Rilegge il file con altre opzioni: altri valori, un&apos;altra scala, una sua parte, meno punti</translation>
    </message>
</context>
<context>
    <name>tetra::CacheDialog</name>
    <message>
        <source>C&amp;lear Now</source>
        <translation>S&amp;vuota ora</translation>
    </message>
    <message>
        <source>Model Cache</source>
        <translation>Cache dei modelli</translation>
    </message>
    <message>
        <source>Packed models and models on servers are unpacked or downloaded into this folder, and opened from there the next time. When room is needed, those unused for longest are removed.</source>
        <translation>I modelli compressi o che si trovano su un server vengono decompressi o scaricati in questa cartella, e la volta successiva aperti da lì. Quando serve spazio si elimina ciò che non è stato usato da più tempo.</translation>
    </message>
    <message>
        <source>Cache folder (leave empty for the default)</source>
        <translation>La cartella; vuoto per quella consueta</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>Sceg&amp;li…</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>Scegliere un&apos;altra cartella</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>Maximum size of the cache</source>
        <translation>Quanto spazio su disco può occupare</translation>
    </message>
    <message>
        <source>Remove all models in the folder that are not open</source>
        <translation>Elimina tutti i modelli della cartella che non sono aperti</translation>
    </message>
    <message>
        <source>&amp;Folder:</source>
        <translation>&amp;Cartella:</translation>
    </message>
    <message>
        <source>At &amp;most:</source>
        <translation>Al &amp;massimo:</translation>
    </message>
    <message>
        <source>In use:</source>
        <translation>Occupato:</translation>
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
        <translation>OpenGL non può disegnare questa immagine; la disegna invece il processore. %1</translation>
    </message>
</context>
<context>
    <name>tetra::ColourButton</name>
    <message>
        <source>Colour</source>
        <translation>Colore</translation>
    </message>
    <message>
        <source>Other Colour…</source>
        <translation>Altro colore…</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiali</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Bianco</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Nero</translation>
    </message>
</context>
<context>
    <name>tetra::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Scrivere che cosa si vuole fare</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandi</translation>
    </message>
    <message>
        <source>Type the beginnings of words to find a command or a setting. Enter runs it, Esc closes the list.</source>
        <translation>Scrivere gli inizi delle sue parole per trovare un comando o un&apos;impostazione. Invio lo esegue, Esc chiude.</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nessun risultato</translation>
    </message>
</context>
<context>
    <name>tetra::EditMenu</name>
    <message>
        <source>&amp;More opaque</source>
        <translation>&amp;Più opaca</translation>
    </message>
    <message>
        <source>&amp;Less opaque</source>
        <translation>&amp;Meno opaca</translation>
    </message>
    <message>
        <source>Swap &amp;ends</source>
        <translation>Scambia gli &amp;estremi</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>Più &amp;larga</translation>
    </message>
    <message>
        <source>Na&amp;rrower</source>
        <translation>Più st&amp;retta</translation>
    </message>
    <message>
        <source>Select &amp;all points</source>
        <translation>Seleziona &amp;tutti i punti</translation>
    </message>
    <message>
        <source>&amp;Copy points</source>
        <translation>&amp;Copia punti</translation>
    </message>
    <message>
        <source>&amp;Paste points</source>
        <translation>&amp;Incolla punti</translation>
    </message>
    <message>
        <source>D&amp;uplicate points</source>
        <translation>D&amp;uplica punti</translation>
    </message>
    <message>
        <source>&amp;Remove points</source>
        <translation>&amp;Elimina punti</translation>
    </message>
    <message>
        <source>&amp;Distribute values evenly</source>
        <translation>&amp;Distribuisci i valori uniformemente</translation>
    </message>
    <message>
        <source>&amp;Flip left to right</source>
        <translation>&amp;Capovolgi da sinistra a destra</translation>
    </message>
    <message>
        <source>&amp;Invert opacities</source>
        <translation>Inverti le o&amp;pacità</translation>
    </message>
    <message>
        <source>Ramp from first to last</source>
        <translation>Rampa dal primo all&apos;ultimo</translation>
    </message>
    <message>
        <source>&amp;Simplify: fewer points, same look</source>
        <translation>&amp;Semplifica: meno punti, stesso aspetto</translation>
    </message>
    <message>
        <source>Add a pea&amp;k</source>
        <translation>Aggiungi un picc&amp;o</translation>
    </message>
    <message>
        <source>Ali&amp;gn</source>
        <translation>Alli&amp;nea</translation>
    </message>
    <message>
        <source>Opacities to the &amp;first</source>
        <translation>Opacità come la &amp;prima</translation>
    </message>
    <message>
        <source>Opacities to the &amp;mean</source>
        <translation>Opacità alla &amp;media</translation>
    </message>
    <message>
        <source>Opacities to the &amp;least</source>
        <translation>Opacità alla mi&amp;nima</translation>
    </message>
    <message>
        <source>Opacities to the l&amp;argest</source>
        <translation>Opacità alla mas&amp;sima</translation>
    </message>
    <message>
        <source>&amp;Values of two neighbours: a step</source>
        <translation>&amp;Valori di due vicini: un gradino</translation>
    </message>
    <message>
        <source>Make a gr&amp;oup</source>
        <translation>Forma un &amp;gruppo</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>Seleziona un gruppo</translation>
    </message>
    <message>
        <source>Group &amp;%1</source>
        <translation>Gruppo &amp;%1</translation>
    </message>
    <message>
        <source>&amp;No group</source>
        <translation>&amp;Nessun gruppo</translation>
    </message>
    <message>
        <source>When points meet neighbouri&amp;ng points</source>
        <translation>Se incontra altri pu&amp;nti</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Fermarsi</translation>
    </message>
    <message>
        <source>&amp;Push them along</source>
        <translation>&amp;Spingerli</translation>
    </message>
    <message>
        <source>Move p&amp;ast them</source>
        <translation>Su&amp;perarli</translation>
    </message>
    <message>
        <source>Mas&amp;k: show some values only</source>
        <translation>&amp;Maschera: mostra solo alcuni valori</translation>
    </message>
    <message>
        <source>Add an iso&amp;value</source>
        <translation>Aggiungi un iso&amp;valore</translation>
    </message>
    <message>
        <source>Add a &amp;point</source>
        <translation>Aggiungi un &amp;punto</translation>
    </message>
    <message>
        <source>Add an &amp;isovalue</source>
        <translation>Aggiungi un &amp;isovalore</translation>
    </message>
    <message>
        <source>Cl&amp;ear mark</source>
        <translation>&amp;Cancella segno</translation>
    </message>
    <message>
        <source>Follow the logarit&amp;hm of the value</source>
        <translation>Segui il &amp;logaritmo del valore</translation>
    </message>
    <message>
        <source>From &amp;the picked value</source>
        <translation>&amp;Dal valore scelto</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Colore…</translation>
    </message>
    <message>
        <source>Rescale</source>
        <translation>Riscala</translation>
    </message>
    <message>
        <source>To the values of the &amp;data</source>
        <translation>Sui valori dei &amp;dati</translation>
    </message>
    <message>
        <source>To the values &amp;shown in the plot</source>
        <translation>Sui valori &amp;mostrati nel grafico</translation>
    </message>
    <message>
        <source>To &amp;numbers…</source>
        <translation>Su &amp;numeri dati…</translation>
    </message>
</context>
<context>
    <name>tetra::EmptyPage</name>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>File recenti</translation>
    </message>
    <message>
        <source>Open a dataset or a model</source>
        <translation>Aprire un insieme di dati o un modello</translation>
    </message>
    <message>
        <source>Drop a file: a dataset (a volume, a grid, a mesh or points), a .tan model or a session. TAn shows large data at any accuracy, with a known error.</source>
        <translation>Trascinare un file: un insieme di dati (un volume, una griglia, una mesh o punti), un modello .tan o una sessione. TAn mostra dati grandi con qualsiasi accuratezza e con errore noto.</translation>
    </message>
    <message>
        <source>Open a dataset, a model or a session (Ctrl+O)</source>
        <translation>Apre un insieme di dati, un modello o una sessione (Ctrl+O)</translation>
    </message>
    <message>
        <source>Or try a sample</source>
        <translation>Oppure provare un esempio</translation>
    </message>
    <message>
        <source>Samples are computed when you choose them; nothing is downloaded.</source>
        <translation>Gli esempi si calcolano quando se ne sceglie uno; non si scarica nulla.</translation>
    </message>
</context>
<context>
    <name>tetra::Exporting</name>
    <message>
        <source>Nothing was saved: the model was closed in the meantime.</source>
        <translation>Non è stato salvato nulla: nel frattempo il modello è stato chiuso.</translation>
    </message>
</context>
<context>
    <name>tetra::FilmDialog</name>
    <message>
        <source>Numbered PNG pictures</source>
        <translation>Immagini PNG numerate</translation>
    </message>
    <message>
        <source>MP4 video (H.264)</source>
        <translation>Video MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebM video (VP9)</source>
        <translation>Video WebM (VP9)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Sfoglia…</translation>
    </message>
    <message>
        <source>Save Film</source>
        <translation>Salva filmato</translation>
    </message>
    <message>
        <source>Videos require the program ffmpeg</source>
        <translation>I video si possono fare dove è installato il programma ffmpeg</translation>
    </message>
    <message>
        <source>Videos are made by %1</source>
        <translation>I video sono fatti da %1</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>Fil&amp;e</source>
        <translation>Fil&amp;e</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Filmato</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnulla</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>&amp;Chiudi</translation>
    </message>
    <message>
        <source>A film that is being written continues</source>
        <translation>Un filmato che si sta scrivendo continua</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Salvato.</translation>
    </message>
    <message>
        <source>It has no frames yet: add at least two views in the Animation panel.</source>
        <translation>Non ha ancora fotogrammi: aggiungere due viste o più nel pannello Animazione.</translation>
    </message>
    <message>
        <source>%1 frames, %2</source>
        <translation>%1 fotogrammi, %2</translation>
    </message>
    <message>
        <source>%1; writing takes about %2</source>
        <translation>%1; la scrittura richiede circa %2</translation>
    </message>
    <message>
        <source>%1, …</source>
        <translation>%1, …</translation>
    </message>
    <message>
        <source>Files with this name already exist and will be replaced: %1.</source>
        <translation>Esistono già file con questo nome e verranno sostituiti: %1.</translation>
    </message>
    <message>
        <source>&amp;Replace and Save</source>
        <translation>Sostituisci e &amp;salva</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Si comincia…</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotogramma %1 di %2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, restano circa %2</translation>
    </message>
    <message>
        <source>Video file, or base name of the numbered pictures</source>
        <translation>File video, o nome di base delle immagini numerate</translation>
    </message>
</context>
<context>
    <name>tetra::FocusPanel</name>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
    <message>
        <source>The same error everywhere</source>
        <translation>Lo stesso errore ovunque</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Box</translation>
    </message>
    <message>
        <source>A box with its own error (B)</source>
        <translation>Un parallelepipedo con un errore proprio (B)</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sfera</translation>
    </message>
    <message>
        <source>A sphere with its own error (F)</source>
        <translation>Una sfera con un errore proprio (F)</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Centro</translation>
    </message>
    <message>
        <source>Centre of the focus, in the coordinates of the data</source>
        <translation>Centro del focus, nelle coordinate dei dati</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Lati</translation>
    </message>
    <message>
        <source>Edges of the box, in data units</source>
        <translation>Lati del parallelepipedo, nelle unità dei dati</translation>
    </message>
    <message>
        <source>Radius of the sphere</source>
        <translation>Raggio della sfera</translation>
    </message>
    <message>
        <source>Radius of the sphere, in data units</source>
        <translation>Raggio della sfera, nelle unità dei dati</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Transizione</translation>
    </message>
    <message>
        <source>The distance over which the error grows from its value in the focus to that outside, in data units; 0 gives a sharp border</source>
        <translation>La distanza su cui l&apos;errore cresce da quello nel focus a quello esterno, nelle unità dei dati; 0 è un bordo netto</translation>
    </message>
    <message>
        <source>Error in the focus</source>
        <translation>Errore nel focus</translation>
    </message>
    <message>
        <source>Error in the focus, in percent of the value range</source>
        <translation>Errore nel focus, in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Move the focus to the camera&apos;s target (C)</source>
        <translation>Sposta il focus al punto mirato dalla camera (C)</translation>
    </message>
    <message>
        <source>Reset position, size, error and fall-off</source>
        <translation>Reimposta posizione, dimensioni, errore e transizione</translation>
    </message>
    <message>
        <source>Outside %1, as chosen under Accuracy.</source>
        <translation>All&apos;esterno %1, come scelto in Accuratezza.</translation>
    </message>
    <message>
        <source>Between %1 and %2 tetrahedra.</source>
        <translation>Fra %1 e %2 tetraedri.</translation>
    </message>
    <message>
        <source>Rad&amp;ius</source>
        <translation>Ragg&amp;io</translation>
    </message>
    <message>
        <source>Error i&amp;nside</source>
        <translation>Errore i&amp;nterno</translation>
    </message>
    <message>
        <source>Fa&amp;ll-off</source>
        <translation>Trans&amp;izione</translation>
    </message>
    <message>
        <source>&amp;Move to Centre of View</source>
        <translation>Al &amp;centro della vista</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>With the budget, the error outside is %1 times the error inside.</source>
        <translation>Con il budget l&apos;errore esterno è %1 volte questo.</translation>
    </message>
    <message>
        <source>A focus is never coarser than its surroundings, so it gets the same error.</source>
        <translation>Un focus non è più grossolano di ciò che lo circonda, quindi riceve lo stesso errore.</translation>
    </message>
    <message>
        <source>A focus is never coarser than its surroundings, so it gets %1.</source>
        <translation>Un focus non è più grossolano di ciò che lo circonda, quindi riceve %1.</translation>
    </message>
    <message>
        <source>A&amp;dd</source>
        <translation>A&amp;ggiungi</translation>
    </message>
    <message>
        <source>Remo&amp;ve</source>
        <translation>Rimuo&amp;vi</translation>
    </message>
    <message>
        <source>Dis&amp;tance</source>
        <translation>Dis&amp;tanza</translation>
    </message>
    <message>
        <source>Value ran&amp;ge</source>
        <translation>Intervallo di va&amp;lori</translation>
    </message>
    <message>
        <source>Where the mesh is more accurate than elsewhere. Choose a box or a sphere, then drag its handles in the picture; double-click a surface to move it there. Or let the error grow with the distance from the viewer or from the isovalues, or where little is visible.</source>
        <translation>Dove la mesh è più accurata che altrove. Scegliere un parallelepipedo o una sfera, poi trascinarne le maniglie nell&apos;immagine; un doppio clic su una superficie li sposta lì. Oppure far crescere l&apos;errore con la distanza dall&apos;osservatore o dagli isovalori, o dove si vede poco.</translation>
    </message>
    <message>
        <source>Accuracy varies with</source>
        <translation>L&apos;accuratezza varia con</translation>
    </message>
    <message>
        <source>Viewer</source>
        <translation>Osservatore</translation>
    </message>
    <message>
        <source>The error grows with the distance from the viewer. While you move the camera, the mesh stays as it is.</source>
        <translation>L&apos;errore cresce con la distanza dall&apos;osservatore. Mentre si muove la camera, la mesh resta com&apos;è.</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isovalori</translation>
    </message>
    <message>
        <source>The error grows with the distance from the displayed isovalues</source>
        <translation>L&apos;errore cresce con la distanza dagli isovalori mostrati</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>The error is smaller where the transfer function is more opaque</source>
        <translation>L&apos;errore è minore dove la funzione di trasferimento è più opaca</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Regione</translation>
    </message>
    <message>
        <source>Selected region. All regions share one error and fall-off.</source>
        <translation>La regione a cui si riferiscono posizione e dimensione; tutte hanno lo stesso errore e la stessa transizione</translation>
    </message>
    <message>
        <source>Add another region of the same size</source>
        <translation>Aggiunge un&apos;altra regione della stessa dimensione</translation>
    </message>
    <message>
        <source>Remove this region</source>
        <translation>Rimuove questa regione</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>The distance over which the error grows from its value inside, at the part of the data nearest to the viewer, to that outside, in data units</source>
        <translation>La distanza su cui l&apos;errore cresce da quello interno, nella parte dei dati più vicina all&apos;osservatore, a quello esterno, nelle unità dei dati</translation>
    </message>
    <message>
        <source>Range of values</source>
        <translation>Intervallo di valori</translation>
    </message>
    <message>
        <source>The difference from an isovalue over which the error grows from its value inside to that outside, in the units of the values</source>
        <translation>La differenza da un isovalore su cui l&apos;errore cresce da quello interno a quello esterno, nelle unità dei valori</translation>
    </message>
    <message>
        <source>%1: sphere</source>
        <translation>%1: sfera</translation>
    </message>
    <message>
        <source>%1: box</source>
        <translation>%1: parallelepipedo</translation>
    </message>
    <message>
        <source>There is no isovalue, so the error is %1 everywhere.</source>
        <translation>Non c&apos;è nessun isovalore, quindi l&apos;errore è %1 ovunque.</translation>
    </message>
    <message>
        <source>%1 tetrahedra; %2 without the focus and with its error everywhere %3.</source>
        <translation>%1 tetraedri; senza il focus %2, con il suo errore ovunque %3.</translation>
    </message>
</context>
<context>
    <name>tetra::HelpTexts</name>
    <message>
        <source>More in the manual (F1)</source>
        <translation>Altro nel manuale (F1)</translation>
    </message>
</context>
<context>
    <name>tetra::HistogramView</name>
    <message>
        <source>Histogram</source>
        <translation>Istogramma</translation>
    </message>
    <message>
        <source>How often the values of the displayed mesh occur, on a logarithmic scale; from the smallest to the largest value, in data units</source>
        <translation>Quanto spesso si presentano i valori della mesh mostrata, in scala logaritmica, dal valore minimo al massimo, nelle unità dei dati</translation>
    </message>
</context>
<context>
    <name>tetra::ImportDialog</name>
    <message>
        <source>&amp;Read</source>
        <translation>&amp;Leggi</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Reader</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Reader used for this file</source>
        <translation>Plugin di lettura usato per questo file</translation>
    </message>
    <message>
        <source>R&amp;eader</source>
        <translation>L&amp;ettura</translation>
    </message>
    <message>
        <source>Import options</source>
        <translation>Opzioni di importazione</translation>
    </message>
    <message>
        <source>Subset</source>
        <translation>Sottoinsieme</translation>
    </message>
    <message>
        <source>Matching layouts</source>
        <translation>Formati adatti</translation>
    </message>
    <message>
        <source>Sizes and types that fit the file exactly, the most likely first</source>
        <translation>Dimensioni e tipi che riempirebbero esattamente il file, i più probabili per primi</translation>
    </message>
    <message>
        <source>Progress of reading</source>
        <translation>Avanzamento della lettura</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importa %1</translation>
    </message>
    <message>
        <source>%1, %2 bytes</source>
        <translation>%1, %2 byte</translation>
    </message>
    <message>
        <source>None found</source>
        <translation>Nessuno noto</translation>
    </message>
    <message>
        <source>Enter the number of points along x, y and z, as in 64x64x32.</source>
        <translation>Dare il numero di punti lungo x, y e z, come in 64x64x32.</translation>
    </message>
    <message>
        <source>Size check</source>
        <translation>Controllo della dimensione</translation>
    </message>
    <message>
        <source>&amp;Suggestion</source>
        <translation>&amp;Proposta</translation>
    </message>
    <message>
        <source>Open with these options</source>
        <translation>Apre con queste opzioni</translation>
    </message>
    <message>
        <source>Stops reading, or closes this window</source>
        <translation>Ferma la lettura, o chiude questa finestra</translation>
    </message>
    <message>
        <source>An upper bound; a model with less detail takes less.</source>
        <translation>Un limite superiore; un modello con meno dettaglio richiede meno.</translation>
    </message>
    <message>
        <source>What these options take from the file, and what else it states that is not used</source>
        <translation>Che cosa si prenderebbe del file con queste opzioni, e che cosa il file dichiara e non viene usato</translation>
    </message>
</context>
<context>
    <name>tetra::ImportRegion</name>
    <message>
        <source>&amp;All Points</source>
        <translation>Tutti i pu&amp;nti</translation>
    </message>
    <message>
        <source>Only a &amp;box in space</source>
        <translation>Solo un &amp;box nello spazio</translation>
    </message>
    <message>
        <source>Takes every point of the dataset</source>
        <translation>Prende ogni punto dell&apos;intero insieme di dati</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Primo</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Ultimo</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>First point along %1</source>
        <translation>Primo punto lungo %1</translation>
    </message>
    <message>
        <source>First point taken, counted from 0</source>
        <translation>Il primo punto preso, contando da 0</translation>
    </message>
    <message>
        <source>Last point along %1</source>
        <translation>Ultimo punto lungo %1</translation>
    </message>
    <message>
        <source>Last point taken, counted from 0</source>
        <translation>L&apos;ultimo punto preso, contando da 0</translation>
    </message>
    <message>
        <source>Stride along %1</source>
        <translation>Passo lungo %1</translation>
    </message>
    <message>
        <source>Keep every n-th point</source>
        <translation>Mantiene un punto ogni n</translation>
    </message>
    <message>
        <source>Takes only what lies in a box; for irregular meshes, whole tetrahedra</source>
        <translation>Prende solo ciò che sta in un parallelepipedo; di mesh irregolari tetraedri interi</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Da %1</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>A %1</translation>
    </message>
    <message>
        <source>A corner of the box, in the coordinates of the data</source>
        <translation>Un vertice del parallelepipedo, nelle coordinate dei dati</translation>
    </message>
</context>
<context>
    <name>tetra::IsovaluePanel</name>
    <message>
        <source>&amp;Add Isovalue</source>
        <translation>A&amp;ggiungi isovalore</translation>
    </message>
    <message>
        <source>No isovalue: there is nothing to draw but the outline.</source>
        <translation>Nessun isovalore: non c&apos;è nulla da disegnare tranne il contorno.</translation>
    </message>
    <message>
        <source>Add an isosurface at another value (Ctrl+I)</source>
        <translation>Aggiunge un&apos;isosuperficie a un altro valore (Ctrl+I)</translation>
    </message>
</context>
<context>
    <name>tetra::IsovalueRow</name>
    <message>
        <source>Isovalue</source>
        <translation>Isovalore</translation>
    </message>
    <message>
        <source>Isovalue, in the units of the data: %1 to %2</source>
        <translation>Isovalore, nelle unità dei dati: da %1 a %2</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>Opacity in percent; below 100 % what lies behind it shows through</source>
        <translation>Opacità in percento; sotto il 100 % traspare ciò che sta dietro</translation>
    </message>
    <message>
        <source>Show this isosurface</source>
        <translation>Mostra questa isosuperficie</translation>
    </message>
    <message>
        <source>Remove this isovalue (Del)</source>
        <translation>Rimuove questo isovalore (Canc)</translation>
    </message>
    <message>
        <source>Remove this isovalue</source>
        <translation>Rimuove questo isovalore</translation>
    </message>
    <message>
        <source> sd</source>
        <translation> sd</translation>
    </message>
    <message>
        <source>Isovalue in standard deviations above the mean</source>
        <translation>Isovalore in deviazioni standard sopra la media</translation>
    </message>
    <message>
        <source>The isovalue in standard deviations above the mean. The mean of all samples is %1, their standard deviation %2. In the box above, 2.5sd can be typed, too.</source>
        <translation>L&apos;isovalore in deviazioni standard sopra la media. La media di tutti i campioni è %1, la loro deviazione standard %2. Nel campo sopra si può scrivere anche 2,5sd.</translation>
    </message>
    <message>
        <source>Above the mean</source>
        <translation>Sopra la media</translation>
    </message>
</context>
<context>
    <name>tetra::KeepSession</name>
    <message>
        <source>Save Session</source>
        <translation>Salva sessione</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sessioni (*.tansession)</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Ripristina</translation>
    </message>
    <message>
        <source>Saved automatically on %1. Model: %2</source>
        <translation>Salvata automaticamente il %1. Modello: %2</translation>
    </message>
    <message>
        <source>%1 contains the session it was made with, which can be restored.</source>
        <translation>%1 contiene la sessione con cui è stata fatta, che si può ripristinare.</translation>
    </message>
    <message>
        <source>%1 had unsaved changes when TAn was ended.</source>
        <translation>%1 aveva modifiche non salvate quando TAn è stato terminato.</translation>
    </message>
    <message>
        <source>TAn ended unexpectedly while %1 was open.</source>
        <translation>TAn è terminato inaspettatamente mentre %1 era aperto.</translation>
    </message>
    <message>
        <source>Its view can be restored.</source>
        <translation>La sua vista si può ripristinare.</translation>
    </message>
    <message>
        <source>The model %1 was not found where it was, in %2.</source>
        <translation>Il modello %1 non è stato trovato dov&apos;era, in %2.</translation>
    </message>
    <message>
        <source>The model %1 of %2 was not found where it was, in %3, nor near the session.</source>
        <translation>Il modello %1 di %2 non è stato trovato né dov&apos;era, in %3, né vicino alla sessione.</translation>
    </message>
    <message>
        <source>&amp;Locate Model…</source>
        <translation>&amp;Trova modello…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>Trova %1</translation>
    </message>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelli (*.tan)</translation>
    </message>
</context>
<context>
    <name>tetra::KeyFrameList</name>
    <message>
        <source>%1°, %2° at %3</source>
        <translation>%1°, %2° a %3</translation>
    </message>
    <message>
        <source>%1, %2 tetrahedra</source>
        <translation>%1, %2 tetraedri</translation>
    </message>
    <message>
        <source>%1, error %2</source>
        <translation>%1, errore %2</translation>
    </message>
    <message>
        <source>Key frames</source>
        <translation>Fotogrammi chiave</translation>
    </message>
    <message>
        <source>Enter shows a key frame, Delete removes it, Alt with an arrow moves it</source>
        <translation>Invio mostra un fotogramma chiave, Canc lo elimina, Alt con una freccia lo sposta</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Tempo (s)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Azimuth and elevation, distance in the units of the data, accuracy</source>
        <translation>Azimut ed elevazione, distanza nelle unità dei dati, accuratezza</translation>
    </message>
    <message>
        <source>&amp;Add View</source>
        <translation>&amp;Aggiungi vista</translation>
    </message>
    <message>
        <source>Add the current view as the next key frame</source>
        <translation>Aggiunge la vista attuale come prossimo fotogramma chiave</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Sostituisci</translation>
    </message>
    <message>
        <source>Replace this key frame with the current view</source>
        <translation>Sostituisce questo fotogramma chiave con la vista attuale</translation>
    </message>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>Show this key frame (Enter)</source>
        <translation>Mostra questo fotogramma chiave (Invio)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>&amp;Elimina</translation>
    </message>
    <message>
        <source>Remove this key frame (Delete)</source>
        <translation>Elimina questo fotogramma chiave (Canc)</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>&amp;Prima</translation>
    </message>
    <message>
        <source>Swap with the previous key frame (Alt+Up)</source>
        <translation>Scambia con il fotogramma chiave precedente (Alt+Su)</translation>
    </message>
    <message>
        <source>La&amp;ter</source>
        <translation>&amp;Dopo</translation>
    </message>
    <message>
        <source>Swap with the next key frame (Alt+Down)</source>
        <translation>Scambia con il fotogramma chiave successivo (Alt+Giù)</translation>
    </message>
    <message>
        <source>Show Key Frame</source>
        <translation>Mostra fotogramma chiave</translation>
    </message>
</context>
<context>
    <name>tetra::Leaving</name>
    <message>
        <source>It can continue in the background.</source>
        <translation>Può continuare in secondo piano.</translation>
    </message>
    <message>
        <source>If you stop now, you can keep what is finished as %1, a model of lower accuracy.</source>
        <translation>Fermandola ora si può conservare la parte finita come %1, un modello meno accurato.</translation>
    </message>
    <message>
        <source>Nothing can be kept yet.</source>
        <translation>Non si può ancora conservarne nulla.</translation>
    </message>
    <message>
        <source>Build in Progress</source>
        <translation>Costruzione in corso</translation>
    </message>
    <message>
        <source>The model of %1 is still being built.</source>
        <translation>Il modello di %1 è ancora in costruzione.</translation>
    </message>
    <message>
        <source>&amp;Continue Building</source>
        <translation>&amp;Continua a costruire</translation>
    </message>
    <message>
        <source>Stop and &amp;Keep</source>
        <translation>Ferma e co&amp;nserva</translation>
    </message>
    <message>
        <source>&amp;Discard Build</source>
        <translation>&amp;Scarta costruzione</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>If you stop it, nothing is kept.</source>
        <translation>Fermandolo non ne resta nulla.</translation>
    </message>
    <message>
        <source>Film in Progress</source>
        <translation>Filmato in corso</translation>
    </message>
    <message>
        <source>The film %1 is still being written.</source>
        <translation>Il filmato %1 è ancora in scrittura.</translation>
    </message>
    <message>
        <source>&amp;Continue Writing</source>
        <translation>&amp;Continua a scrivere</translation>
    </message>
    <message>
        <source>&amp;Discard Film</source>
        <translation>&amp;Scarta filmato</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Modifiche non salvate</translation>
    </message>
    <message>
        <source>The session %1 has unsaved changes.</source>
        <translation>La sessione %1 ha modifiche non salvate.</translation>
    </message>
    <message>
        <source>Your changes will be lost if you do not save them.</source>
        <translation>Le modifiche andranno perse se non vengono salvate.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>S&amp;carta</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Salvataggio</translation>
    </message>
    <message>
        <source>A file is still being saved.</source>
        <translation>È ancora in corso il salvataggio di un file.</translation>
    </message>
    <message>
        <source>TAn will quit when this is done.</source>
        <translation>TAn si chiuderà al termine.</translation>
    </message>
    <message>
        <source>&amp;Do Not Quit</source>
        <translation>&amp;Non uscire</translation>
    </message>
    <message>
        <source>&amp;Quit Without Saving</source>
        <translation>&amp;Esci senza salvare</translation>
    </message>
    <message>
        <source>%1 % done, about %2 left.</source>
        <translation>Fatto il %1 %, mancano circa %2.</translation>
    </message>
    <message>
        <source>%1 % done.</source>
        <translation>Fatto il %1 %.</translation>
    </message>
    <message>
        <source>TAn will continue when this is done.</source>
        <translation>TAn continuerà al termine.</translation>
    </message>
    <message>
        <source>&amp;Continue Without Saving</source>
        <translation>&amp;Continua senza salvare</translation>
    </message>
    <message>
        <source>You can resume it when you open these data again.</source>
        <translation>Si può riprendere quando si riaprono questi dati.</translation>
    </message>
    <message>
        <source>Quit and &amp;Resume Later</source>
        <translation>Esci e &amp;riprendi dopo</translation>
    </message>
    <message>
        <source>Stop and Keep</source>
        <translation>Ferma e conserva</translation>
    </message>
    <message>
        <source>Stop the build of %1 and keep what is finished?</source>
        <translation>Fermare la costruzione di %1 e conservare ciò che è pronto?</translation>
    </message>
    <message>
        <source>If you stop now, you can keep what is finished as a separate model, named after its error. The finished model %1 is not changed.</source>
        <translation>Se si ferma ora, ciò che è pronto si può conservare come modello a sé, con il suo errore nel nome. Il modello finito %1 resta com&apos;è.</translation>
    </message>
</context>
<context>
    <name>tetra::LensInputs</name>
    <message>
        <source>Lens over the picture</source>
        <translation>Lente sull&apos;immagine</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuna</translation>
    </message>
    <message>
        <source>No lens</source>
        <translation>Nessuna lente</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cerchio</translation>
    </message>
    <message>
        <source>A round lens with its own error (L). Drag it; turn the wheel over it to change the magnification.</source>
        <translation>Una lente rotonda con un proprio errore (L). Trascinarla per spostarla; la rotella su di essa cambia l&apos;ingrandimento.</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrato</translation>
    </message>
    <message>
        <source>A square lens, with its own error</source>
        <translation>Una lente quadrata con un proprio errore</translation>
    </message>
    <message>
        <source>Magnification</source>
        <translation>Ingrandimento</translation>
    </message>
    <message>
        <source>How much larger the lens shows what is under its centre</source>
        <translation>Quante volte più grande la lente mostra ciò che si trova sotto il suo centro</translation>
    </message>
    <message>
        <source>Size of the lens</source>
        <translation>Dimensione della lente</translation>
    </message>
    <message>
        <source>Half the width of the lens, in percent of the picture&apos;s shorter side</source>
        <translation>Metà della larghezza della lente, in percento del lato minore dell&apos;immagine</translation>
    </message>
    <message>
        <source>Error in the lens</source>
        <translation>Errore nella lente</translation>
    </message>
    <message>
        <source>Error of the mesh in the lens, in percent of the value range; it is never coarser than the mesh of the picture</source>
        <translation>Errore della mesh nella lente, in percento dell&apos;intervallo dei valori; non è mai più grossolana della mesh dell&apos;immagine</translation>
    </message>
    <message>
        <source>Magnificati&amp;on</source>
        <translation>Ingr&amp;andimento</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>Dimen&amp;sione</translation>
    </message>
    <message>
        <source>E&amp;rror inside</source>
        <translation>E&amp;rrore all&apos;interno</translation>
    </message>
</context>
<context>
    <name>tetra::LensTool</name>
    <message>
        <source>Lens</source>
        <translation>Lente</translation>
    </message>
    <message>
        <source>Enlarged %1 times</source>
        <translation>Ingrandito %1 volte</translation>
    </message>
</context>
<context>
    <name>tetra::LostOffers</name>
    <message>
        <source>Sessions to restore</source>
        <translation>Sessioni da ripristinare</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Ripristina</translation>
    </message>
    <message>
        <source>Open the model with its view restored. The saved view is kept until that has succeeded.</source>
        <translation>Apre il modello con la vista ripristinata. La vista salvata resta finché l&apos;operazione non riesce.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>Ripristina %1</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Scarta</translation>
    </message>
    <message>
        <source>Discard the saved view (the model file is kept)</source>
        <translation>Scarta la vista salvata (il file del modello resta)</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>Scarta %1</translation>
    </message>
</context>
<context>
    <name>tetra::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation>Immagine</translation>
    </message>
    <message>
        <source>Only one file can be open at a time; of the files dropped, %1 was opened.</source>
        <translation>Si può aprire un solo file per volta; di quelli trascinati si è aperto %1.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Salvato %1</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>&amp;Svuota elenco</translation>
    </message>
    <message>
        <source>TAn</source>
        <translation>TAn</translation>
    </message>
    <message>
        <source>Dataset loaded. Choose options on the left and press Build to view it.</source>
        <translation>Insieme di dati caricato. Scegliere le opzioni a sinistra e premere «Costruisci» per vederlo.</translation>
    </message>
    <message>
        <source>About TAn</source>
        <translation>Informazioni su TAn</translation>
    </message>
    <message>
        <source>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: multiresolution volume data with a known error.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;TAn %1&lt;/h3&gt;&lt;p&gt;Tetrahedra Analyzer: dati di volume a multirisoluzione con errore noto.&lt;/p&gt;&lt;p&gt;Software libero sotto la GNU General Public License, versione 3 o successiva.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Salvataggio</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Si disegna l&apos;immagine</translation>
    </message>
    <message>
        <source>Drawing the film</source>
        <translation>Si disegna il filmato</translation>
    </message>
    <message>
        <source>Drawing the picture, %1 more waiting</source>
        <translation>Si disegna l&apos;immagine, altre %1 in attesa</translation>
    </message>
    <message>
        <source>Picture copied, %1 × %2 pixels</source>
        <translation>Immagine copiata, %1 × %2 pixel</translation>
    </message>
    <message>
        <source>Reset View</source>
        <translation>Reimposta la vista</translation>
    </message>
    <message>
        <source>The model %1 has been built.</source>
        <translation>Il modello %1 è costruito.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Apri</translation>
    </message>
    <message>
        <source>%1[*] – TAn</source>
        <translation>%1[*] – TAn</translation>
    </message>
    <message>
        <source>Its model is being built. The panel on the left shows the progress.</source>
        <translation>Il suo modello è in costruzione. Il pannello a sinistra mostra l&apos;avanzamento.</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Creazione dell&apos;esempio</translation>
    </message>
    <message>
        <source>%1 has not been built yet. The picture still shows %2.</source>
        <translation>%1 non è ancora costruito. L&apos;immagine mostra ancora %2.</translation>
    </message>
    <message>
        <source>Save Mesh</source>
        <translation>Salva mesh</translation>
    </message>
    <message>
        <source>Save Surfaces</source>
        <translation>Salva superfici</translation>
    </message>
    <message>
        <source>The picture does not show the current settings, which could not be drawn.</source>
        <translation>L&apos;immagine non mostra le impostazioni attuali, che non è stato possibile disegnare.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Showing %L1 of %L2 vertices, more are on the way</source>
        <translation>Mostra %L1 di %L2 vertici, altri stanno arrivando</translation>
    </message>
    <message>
        <source>%1 is shown with %L2 of its %L3 vertices: %4 of %5 were downloaded.</source>
        <translation>%1 è mostrato con %L2 dei suoi %L3 vertici: %4 di %5 sono stati scaricati.</translation>
    </message>
    <message>
        <source>&amp;Fetch All</source>
        <translation>Scarica &amp;tutto</translation>
    </message>
    <message>
        <source>Saved %1: %2 instead of %3</source>
        <translation>%1 salvato: %2 invece di %3</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Compressione</translation>
    </message>
    <message>
        <source>Save Packed Model</source>
        <translation>Salva modello compresso</translation>
    </message>
    <message>
        <source>Packed models (*.tan)</source>
        <translation>Modelli compressi (*.tan)</translation>
    </message>
    <message>
        <source>Apply Look From</source>
        <translation>Applica aspetto da un file</translation>
    </message>
    <message>
        <source>Sessions, and pictures saved by TAn (*.tansession *.png)</source>
        <translation>Sessioni e immagini con le loro sessioni (*.tansession *.png)</translation>
    </message>
    <message>
        <source>What was finished has been kept as %1. The model %2 is unchanged.</source>
        <translation>Ciò che era pronto è conservato come %1. Il modello %2 è com&apos;era.</translation>
    </message>
    <message>
        <source>%1 % shown, more is on the way</source>
        <translation>%1 % mostrato, altro sta arrivando</translation>
    </message>
    <message>
        <source>Saved %1. %2</source>
        <translation>Salvato %1. %2</translation>
    </message>
    <message>
        <source>Save Solids</source>
        <translation>Salva solidi</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>Added bookmark %1</source>
        <translation>Aggiunto il segnalibro %1</translation>
    </message>
    <message>
        <source>The file does not say which way is up; Ctrl+U turns the model upside down</source>
        <translation>Il file non dice qual è l&apos;alto; Ctrl+U capovolge il modello</translation>
    </message>
</context>
<context>
    <name>tetra::Message</name>
    <message>
        <source>The folder &apos;%1&apos; does not exist: create it or choose another.</source>
        <translation>La cartella «%1» non esiste: crearla o sceglierne un&apos;altra.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a folder: choose another.</source>
        <translation>«%1» non è una cartella: sceglierne un&apos;altra.</translation>
    </message>
    <message>
        <source>Name a file in it.</source>
        <translation>Indicare un file al suo interno.</translation>
    </message>
    <message>
        <source>Choose another folder, or change the permissions of this one.</source>
        <translation>Scegliere un&apos;altra cartella, o cambiare i permessi di questa.</translation>
    </message>
    <message>
        <source>Choose a folder on a disk that can be written.</source>
        <translation>Scegliere una cartella su un disco scrivibile.</translation>
    </message>
    <message>
        <source>Choose a shorter name.</source>
        <translation>Scegliere un nome più corto.</translation>
    </message>
    <message>
        <source>Choose another folder or disk.</source>
        <translation>Scegliere un&apos;altra cartella o un altro disco.</translation>
    </message>
    <message>
        <source>Not valid JSON: %1 (%2).</source>
        <translation>JSON non valido: %1 (%2).</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>The runs of the blocks do not fit together. Start the build again.</source>
        <translation>Le sequenze dei blocchi non combaciano. Riavviare la costruzione.</translation>
    </message>
    <message>
        <source>Extracting the mesh</source>
        <translation>Estrazione della mesh</translation>
    </message>
    <message>
        <source>Selecting tetrahedra from the mesh</source>
        <translation>Scelta dalla mesh</translation>
    </message>
    <message>
        <source>The mesh has too many tetrahedra for its boundary to be shown. Lower the accuracy of the mesh.</source>
        <translation>La mesh ha troppi tetraedri perché se ne mostri il contorno. Ridurre la accuratezza della mesh.</translation>
    </message>
    <message>
        <source>the text</source>
        <translation>il testo</translation>
    </message>
    <message>
        <source>The transfer function cannot be read: %1 (%2).</source>
        <translation>La funzione di trasferimento non può essere letta: %1 (%2).</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>esatto</translation>
    </message>
    <message>
        <source>normalised</source>
        <translation>normalizzata</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>articolo</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Scelta</translation>
    </message>
    <message>
        <source>For curvilinear data: &apos;normalised&apos; takes the point that is farthest off in error or warping; &apos;paper&apos; compares the two in the units of the data, as the paper did, for comparison with it. Both keep cells from turning inside out.</source>
        <translation>Per dati curvilinei: «normalizzata» prende il punto più lontano per errore o deformazione; «articolo» confronta i due nelle unità dei dati, come faceva l&apos;articolo, per confrontarsi con esso. Entrambe evitano che le celle si rovescino.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>trovato</translation>
    </message>
    <message>
        <source>loaded</source>
        <translation>caricato</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>disattivato</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rifiutato</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; %2.</source>
        <translation>il vettore «%1» %2.</translation>
    </message>
    <message>
        <source>&apos;%1: %2&apos; in its header %3</source>
        <translation>«%1: %2» nella sua intestazione %3</translation>
    </message>
    <message>
        <source>%1 has %2 bytes, and its header requires %3. It is cut short: copy the file again.</source>
        <translation>%1 ha %2 byte, e la sua intestazione ne chiede %3. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>has no %1 in line %2, but &apos;%3&apos;. It is damaged, or of another version of the format: export it again.</source>
        <translation>non contiene alla riga %2 ciò che ci si aspetta (%1), ma «%3». È danneggiato, o di un&apos;altra versione del formato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>has no %1 in line %2, but &apos;%3&apos;. It is damaged: export it again.</source>
        <translation>non contiene alla riga %2 ciò che ci si aspetta (%1), ma «%3». È danneggiato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>has no %1. It is cut short or damaged.</source>
        <translation>manca di un&apos;indicazione (%1). È troncato o danneggiato.</translation>
    </message>
    <message>
        <source>has a part without a number, in the line &apos;%1&apos;. It is damaged.</source>
        <translation>ha una parte senza numero, nella riga «%1». È danneggiato.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valore</translation>
    </message>
    <message>
        <source>number of values</source>
        <translation>numero di valori</translation>
    </message>
    <message>
        <source>place of a value</source>
        <translation>posto di un valore</translation>
    </message>
    <message>
        <source>It could not be read.</source>
        <translation>Non è stato possibile leggerlo.</translation>
    </message>
    <message>
        <source>The session cannot be read: %1</source>
        <translation>La sessione non può essere letta: %1</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2. %3</source>
        <translation>«%1» non può essere scritto: %2. %3</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>non è un file ordinario</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Scegliere un altro nome.</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>il file è di sola lettura</translation>
    </message>
    <message>
        <source>Choose another name, or make it writable.</source>
        <translation>Scegliere un altro nome, o renderlo scrivibile.</translation>
    </message>
    <message>
        <source>it does not name a file</source>
        <translation>non indica un file</translation>
    </message>
    <message>
        <source>Name a file.</source>
        <translation>Indicare un file.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos;. Close other programs.</source>
        <translation>La memoria non basta per scrivere «%1». Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>Not enough memory to build a model. Close other programs, or take fewer samples.</source>
        <translation>La memoria non basta per costruire un modello. Chiudere altri programmi, o prendere meno campioni.</translation>
    </message>
    <message>
        <source>there is text after the end of the value</source>
        <translation>c&apos;è qualcosa dopo la fine del valore</translation>
    </message>
    <message>
        <source>a byte that is not valid UTF-8</source>
        <translation>un byte che non è di testo UTF-8</translation>
    </message>
    <message>
        <source>too many levels of nesting</source>
        <translation>troppi livelli</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;]&apos;</source>
        <translation>ci si aspetta «,» o «]»</translation>
    </message>
    <message>
        <source>the member &quot;%1&quot; appears twice</source>
        <translation>il membro «%1» compare due volte</translation>
    </message>
    <message>
        <source>expected &apos;:&apos;</source>
        <translation>ci si aspetta «:»</translation>
    </message>
    <message>
        <source>expected &apos;,&apos; or &apos;}&apos;</source>
        <translation>ci si aspetta «,» o «}»</translation>
    </message>
    <message>
        <source>expected a value</source>
        <translation>ci si aspetta un valore</translation>
    </message>
    <message>
        <source>expected four hexadecimal digits</source>
        <translation>ci si aspettano quattro cifre esadecimali</translation>
    </message>
    <message>
        <source>unknown escape</source>
        <translation>sequenza di escape sconosciuta</translation>
    </message>
    <message>
        <source>half of a surrogate pair</source>
        <translation>metà di una coppia di surrogati</translation>
    </message>
    <message>
        <source>expected a name in quotes</source>
        <translation>ci si aspetta un nome tra virgolette</translation>
    </message>
    <message>
        <source>a control character inside quotes</source>
        <translation>un carattere di controllo tra virgolette</translation>
    </message>
    <message>
        <source>the closing quote is missing</source>
        <translation>mancano le virgolette di chiusura</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>riga %1, colonna %2</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: %2</source>
        <translation>«%1» non può essere letto: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. Check its name and folder.</source>
        <translation>%1. Controllare il nome e la cartella.</translation>
    </message>
    <message>
        <source>%1. Ask its owner for permission to read it.</source>
        <translation>%1. Chiedere al proprietario il permesso di leggerlo.</translation>
    </message>
    <message>
        <source>it is a folder. Name a file in it.</source>
        <translation>è una cartella. Indicare un file al suo interno.</translation>
    </message>
    <message>
        <source>it is not a regular file. Copy its content into one first.</source>
        <translation>non è un file ordinario. Copiarne prima il contenuto in uno.</translation>
    </message>
    <message>
        <source>Cannot open &apos;%1&apos;: too many files are open. Close some of them.</source>
        <translation>«%1» non può essere aperto: troppi file sono aperti. Chiuderne alcuni.</translation>
    </message>
    <message>
        <source>Not enough memory: %1 MiB of address space for %2 were refused (%3). Close other programs, or raise the memory limit.</source>
        <translation>La memoria non basta: %1 MiB di spazio di indirizzi per %2 sono stati rifiutati (%3). Chiudere altri programmi, o alzare il limite di memoria.</translation>
    </message>
    <message>
        <source>Cannot make a temporary file in &apos;%1&apos;: %2. %3</source>
        <translation>Impossibile creare un file temporaneo in «%1»: %2. %3</translation>
    </message>
    <message>
        <source>A temporary file in &apos;%1&apos; cannot be used: %2. %3</source>
        <translation>Un file temporaneo in «%1» non può essere usato: %2. %3</translation>
    </message>
    <message>
        <source>This machine cannot start any more threads now. Close other programs, or raise the limit (ulimit).</source>
        <translation>Questo computer non può avviare altri thread in questo momento. Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>This machine does not have enough memory for this. Close other programs, or raise the limit (ulimit).</source>
        <translation>La memoria di questo computer non basta. Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>file o cartella inesistente</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>permesso negato</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>operazione non permessa</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>errore di input/output</translation>
    </message>
    <message>
        <source>Cannot allocate memory</source>
        <translation>memoria insufficiente</translation>
    </message>
    <message>
        <source>Resource temporarily unavailable</source>
        <translation>risorsa temporaneamente non disponibile</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>dispositivo o risorsa occupati</translation>
    </message>
    <message>
        <source>Invalid cross-device link</source>
        <translation>su un altro dispositivo</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>non è una cartella</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>è una cartella</translation>
    </message>
    <message>
        <source>Invalid argument</source>
        <translation>argomento non valido</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>troppi file aperti</translation>
    </message>
    <message>
        <source>Too many open files in system</source>
        <translation>troppi file aperti nel sistema</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>file troppo grande</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>spazio esaurito sul disco</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>file system in sola lettura</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>nome del file troppo lungo</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>troppi livelli di collegamenti simbolici</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>quota disco superata</translation>
    </message>
    <message>
        <source>Stale file handle</source>
        <translation>Il file non esiste più sul server</translation>
    </message>
    <message>
        <source>system error %1</source>
        <translation>errore di sistema %1</translation>
    </message>
    <message>
        <source>Choose a disk that allows larger files, or raise the limit (ulimit -f).</source>
        <translation>Scegliere un disco che permetta file più grandi, o alzare il limite (ulimit -f).</translation>
    </message>
    <message>
        <source>Free some space or choose another disk.</source>
        <translation>Liberare spazio o scegliere un altro disco.</translation>
    </message>
    <message>
        <source>Close other programs, or raise the limit (ulimit).</source>
        <translation>Chiudere altri programmi o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>Cannot work in &apos;%1&apos;: %2. %3</source>
        <translation>Non si può lavorare in «%1»: %2. %3</translation>
    </message>
    <message>
        <source>Choose another folder for the model.</source>
        <translation>Scegliere un&apos;altra cartella per il modello.</translation>
    </message>
    <message>
        <source>another program is building this model</source>
        <translation>un altro programma sta costruendo questo modello</translation>
    </message>
    <message>
        <source>Wait for it, or give the model another name.</source>
        <translation>Aspettarlo, o dare al modello un altro nome.</translation>
    </message>
    <message>
        <source>it is used for something else</source>
        <translation>contiene qualcos&apos;altro</translation>
    </message>
    <message>
        <source>Give the model another name, or move that folder away.</source>
        <translation>Dare al modello un altro nome o spostare quella cartella.</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>è un collegamento</translation>
    </message>
    <message>
        <source>Give the model another name, or move that link away.</source>
        <translation>Dare al modello un altro nome o spostare quel collegamento.</translation>
    </message>
    <message>
        <source>A mesh of %1 points and %2 tetrahedra is too large to be decimated: the limits are %3 points and %4 tetrahedra. Take a region of it or fewer samples.</source>
        <translation>Una mesh di %1 punti e %2 tetraedri è troppo grande per essere decimata: al massimo %3 punti e %4 tetraedri. Prenderne una regione o meno campioni.</translation>
    </message>
    <message>
        <source>Decimation of %1 points and %2 tetrahedra takes about %3 of memory, and this machine has %4. Take a region of it or fewer samples, or, if it is a lattice or grid, refine it instead.</source>
        <translation>La decimazione di %1 punti e %2 tetraedri richiede circa %3 di memoria, e questo computer ne ha %4. Prenderne una regione o meno campioni oppure, per un reticolo o una griglia, usare il raffinamento.</translation>
    </message>
    <message>
        <source>Not enough memory to decimate &apos;%1&apos;. Take a region of it or fewer samples.</source>
        <translation>La memoria non basta per decimare «%1». Prenderne una regione o meno campioni.</translation>
    </message>
    <message>
        <source>The finest error (%1 %) is larger than the error at which to stop (%2 %). Choose a smaller finest error, or 0 to keep everything.</source>
        <translation>L&apos;errore più fine (%1 %) è maggiore dell&apos;errore a cui fermarsi (%2 %). Scegliere un errore più fine minore, o 0 per tenere tutto.</translation>
    </message>
    <message>
        <source>A tetrahedral mesh needs a cell: two points or more along each axis.</source>
        <translation>Una mesh di tetraedri richiede una cella: due o più punti lungo ogni asse.</translation>
    </message>
    <message>
        <source>model about %1, work files %2</source>
        <translation>modello circa %1, file di lavoro %2</translation>
    </message>
    <message>
        <source>The build needs about %1 on the disk of &apos;%2&apos; (%3), and %4 are free. Free some space, choose another disk or a larger error.</source>
        <translation>La costruzione richiede circa %1 sul disco di «%2» (%3), e %4 sono liberi. Liberare spazio, scegliere un altro disco o un errore maggiore.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2.</source>
        <translation>«%1» non può essere letto: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists and is not a TAn model, so it is not overwritten. Give the model another name, or remove that file first.</source>
        <translation>«%1» esiste e non è un modello TAn, perciò non viene sovrascritto. Dare al modello un altro nome, o rimuovere prima quel file.</translation>
    </message>
    <message>
        <source>%1 is not a percentage at which to stop. Give one from 0 to 100.</source>
        <translation>%1 non è una percentuale a cui fermarsi. Indicarne una da 0 a 100.</translation>
    </message>
    <message>
        <source>The build</source>
        <translation>La costruzione</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>This target cannot be built in blocks. Set the block to &quot;none&quot;.</source>
        <translation>In questa destinazione non si può costruire a blocchi. Impostare il blocco su «nessuno».</translation>
    </message>
    <message>
        <source>Point %1 of &apos;%2&apos; has a position or a value that is not a finite number. Leave it out.</source>
        <translation>Il punto %1 di «%2» ha una posizione o un valore che non è un numero finito. Ometterlo.</translation>
    </message>
    <message>
        <source>A lattice of %1 points is too large: a model holds at most 4294967296. Crop or subsample it.</source>
        <translation>Un reticolo di %1 punti è troppo grande: un modello ne contiene al massimo 4294967296. Ritagliarlo o sottocampionarlo.</translation>
    </message>
    <message>
        <source>A tetrahedral mesh needs four points or more.</source>
        <translation>Una mesh di tetraedri richiede quattro punti o più.</translation>
    </message>
    <message>
        <source>Blocks of %1 cells cut this dataset into %2 pieces; the limit is %3. Choose larger blocks.</source>
        <translation>Blocchi di %1 celle dividono questo insieme di dati in %2 pezzi; il massimo è %3. Scegliere blocchi più grandi.</translation>
    </message>
    <message>
        <source>The values belong to cells: each point got the mean of the cells around it.</source>
        <translation>I valori appartengono alle celle: ogni punto ha ricevuto la media delle celle attorno.</translation>
    </message>
    <message>
        <source>1 cell is a vertex, line or polygon without volume and not part of the mesh.</source>
        <translation>1 cella è un vertice, una linea o un poligono senza volume e non fa parte della mesh.</translation>
    </message>
    <message>
        <source>%1 cells are vertices, lines or polygons without volume and not part of the mesh.</source>
        <translation>%1 celle sono vertici, linee o poligoni senza volume e non fanno parte della mesh.</translation>
    </message>
    <message>
        <source>1 cell is blanked out in the file: a hole.</source>
        <translation>1 cella è esclusa nel file: un foro.</translation>
    </message>
    <message>
        <source>%1 cells are blanked out in the file: holes.</source>
        <translation>%1 celle sono escluse nel file: fori.</translation>
    </message>
    <message>
        <source>1 cell has a value that is not finite and became a hole.</source>
        <translation>1 cella ha un valore non finito ed è diventata un foro.</translation>
    </message>
    <message>
        <source>%1 cells have a value that is not finite and became holes.</source>
        <translation>%1 celle hanno un valore non finito e sono diventate fori.</translation>
    </message>
    <message>
        <source>1 cell uses a corner twice, has no volume and was left out.</source>
        <translation>1 cella nomina due volte un vertice, non ha volume ed è stata omessa.</translation>
    </message>
    <message>
        <source>%1 cells use a corner twice, have no volume and were left out.</source>
        <translation>%1 celle nominano due volte un vertice, non hanno volume e sono state omesse.</translation>
    </message>
    <message>
        <source>1 cell without volume was left out.</source>
        <translation>1 cella senza volume è stata omessa.</translation>
    </message>
    <message>
        <source>%1 cells without volume were left out.</source>
        <translation>%1 celle senza volume sono state omesse.</translation>
    </message>
    <message>
        <source>All cells had inverted orientation and were corrected.</source>
        <translation>Tutte le celle avevano orientamento inverso e sono state corrette.</translation>
    </message>
    <message>
        <source>1 cell had inverted orientation and was corrected.</source>
        <translation>1 cella aveva orientamento inverso ed è stata corretta.</translation>
    </message>
    <message>
        <source>%1 cells had inverted orientation and were corrected.</source>
        <translation>%1 celle avevano orientamento inverso e sono state corrette.</translation>
    </message>
    <message>
        <source>1 point at the same place as another was merged with it.</source>
        <translation>1 punto nella posizione di un altro è stato unito ad esso.</translation>
    </message>
    <message>
        <source>%1 points at the same place as another were merged with it.</source>
        <translation>%1 punti nella posizione di un altro sono stati uniti ad esso.</translation>
    </message>
    <message>
        <source>1 place had several different values and got their mean.</source>
        <translation>1 posto aveva valori diversi e ha ricevuto la loro media.</translation>
    </message>
    <message>
        <source>%1 places had several different values and got their mean.</source>
        <translation>%1 posti avevano valori diversi e hanno ricevuto la loro media.</translation>
    </message>
    <message>
        <source>1 node in the middle of an edge or face was left out: not all cells there have it, or the cells bend too much.</source>
        <translation>1 nodo nel mezzo di uno spigolo o di una faccia è stato omesso: non tutte le celle lì lo hanno, o si incurvano troppo.</translation>
    </message>
    <message>
        <source>%1 nodes in the middle of edges and faces were left out: not all cells there have them, or the cells bend too much.</source>
        <translation>%1 nodi nel mezzo di spigoli e facce sono stati omessi: non tutte le celle lì li hanno, o si incurvano troppo.</translation>
    </message>
    <message>
        <source>1 cell was cut along other diagonals, because its faces are not flat.</source>
        <translation>1 cella è stata divisa lungo altre diagonali, perché le sue facce non sono piane.</translation>
    </message>
    <message>
        <source>%1 cells were cut along other diagonals, because their faces are not flat.</source>
        <translation>%1 celle sono state divise lungo altre diagonali, perché le loro facce non sono piane.</translation>
    </message>
    <message>
        <source>1 cell was left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>1 cella è stata omessa: troppo deformata per essere divisa in tetraedri senza un nuovo punto.</translation>
    </message>
    <message>
        <source>%1 cells were left out: too warped to be cut into tetrahedra without a new point.</source>
        <translation>%1 celle sono state omesse: troppo deformate per essere divise in tetraedri senza un nuovo punto.</translation>
    </message>
    <message>
        <source>1 tetrahedron appeared twice.</source>
        <translation>1 tetraedro c&apos;era due volte.</translation>
    </message>
    <message>
        <source>%1 tetrahedra appeared twice.</source>
        <translation>%1 tetraedri c&apos;erano due volte.</translation>
    </message>
    <message>
        <source>The mesh has no cells or no points.</source>
        <translation>La mesh non ha celle o non ha punti.</translation>
    </message>
    <message>
        <source>The mesh has %1 points; at most 4294967294 can be numbered. Take a part of it.</source>
        <translation>La mesh ha %1 punti; se ne possono numerare al massimo 4294967294. Prenderne una parte.</translation>
    </message>
    <message>
        <source>The cells&apos; lists of corners are inconsistent: their offsets do not rise from 0 to the number of corners.</source>
        <translation>Gli elenchi dei vertici delle celle non combaciano: i loro inizi non crescono da 0 al numero dei vertici.</translation>
    </message>
    <message>
        <source>The mesh has %1 cells, but blanking flags for %2.</source>
        <translation>La mesh ha %1 celle, ma dice di %2 se sono escluse.</translation>
    </message>
    <message>
        <source>The mesh has %1 cells, but %2 values.</source>
        <translation>La mesh ha %1 celle, ma %2 valori.</translation>
    </message>
    <message>
        <source>The mesh has %1 points, but %2 values.</source>
        <translation>La mesh ha %1 punti, ma %2 valori.</translation>
    </message>
    <message>
        <source>Cells refer to points that do not exist (%1 in all, the first is cell %2). The mesh has %3 points: the file is damaged.</source>
        <translation>Delle celle nominano punti che non esistono (%1 in tutto, la prima è la cella %2). La mesh ha %3 punti: il file è danneggiato.</translation>
    </message>
    <message>
        <source>Cells do not have the number of corners of their shape (%1 in all, the first is cell %2). The file is damaged.</source>
        <translation>Delle celle hanno un numero di vertici diverso dalla loro forma (%1 in tutto, la prima è la cella %2). Il file è danneggiato.</translation>
    </message>
    <message>
        <source>No cell of the mesh has a volume and finite values: nothing is left.</source>
        <translation>Nessuna cella della mesh ha un volume e valori finiti: non resta nulla.</translation>
    </message>
    <message>
        <source>Cutting the cells</source>
        <translation>Suddivisione delle celle</translation>
    </message>
    <message>
        <source>The cells yield more than %1 tetrahedra. Take a part of the mesh.</source>
        <translation>Le celle danno più di %1 tetraedri. Prendere una parte della mesh.</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>Controllo della mesh</translation>
    </message>
    <message>
        <source>The mesh has %1. Repair the mesh in the program that made it.</source>
        <translation>La mesh ha %1. Correggerla nel programma che l&apos;ha creata.</translation>
    </message>
    <message>
        <source>1 tetrahedron that is flat or inverted, one at %1</source>
        <translation>1 tetraedro piatto o invertito, in %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that are flat or inverted, one at %2</source>
        <translation>%1 tetraedri piatti o invertiti, per esempio in %2</translation>
    </message>
    <message>
        <source>1 tetrahedron at a face that three or more share, one at %1</source>
        <translation>1 tetraedro su una faccia che tre o più condividono, in %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra at faces that three or more share, one at %2</source>
        <translation>%1 tetraedri su facce che tre o più condividono, per esempio in %2</translation>
    </message>
    <message>
        <source>1 tetrahedron that overlaps its neighbour, one at %1</source>
        <translation>1 tetraedro che si sovrappone al vicino, in %1</translation>
    </message>
    <message>
        <source>%1 tetrahedra that overlap a neighbour on the same side of a face, one at %2</source>
        <translation>%1 tetraedri che si sovrappongono a un vicino dallo stesso lato di una faccia, per esempio in %2</translation>
    </message>
    <message>
        <source>The dataset is not an irregular mesh: it has no positions or no tetrahedra.</source>
        <translation>L&apos;insieme di dati non è una mesh irregolare: non ha posizioni o non ha tetraedri.</translation>
    </message>
    <message>
        <source>A tetrahedron of the mesh refers to point %1 of %2.</source>
        <translation>Un tetraedro della mesh nomina il punto %1 di %2.</translation>
    </message>
    <message>
        <source>The mesh has %1 points that no tetrahedron uses.</source>
        <translation>La mesh ha %1 punti che nessun tetraedro usa.</translation>
    </message>
    <message>
        <source>The mesh has more than %1 tetrahedra. Take a part of it.</source>
        <translation>La mesh ha più di %1 tetraedri. Prenderne una parte.</translation>
    </message>
    <message>
        <source>No cell of the mesh has a volume: nothing is left.</source>
        <translation>Nessuna cella della mesh ha un volume: non resta nulla.</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh. Take a part of it.</source>
        <translation>La memoria non basta per la mesh. Prenderne una parte.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open, so that the result would be wrong. Open it again; if that fails, get or make the file again.</source>
        <translation>«%1» è stato troncato o cambiato mentre era aperto, perciò ciò che se ne è ricavato sarebbe sbagliato. Aprirlo di nuovo; se non riesce, procurarsi o creare di nuovo il file.</translation>
    </message>
    <message>
        <source>it has %1 points. A volume needs at least 2 along each axis: stack several slices, or repeat the only one.</source>
        <translation>ha %1 punti. Un volume ne richiede almeno 2 lungo ogni asse: unire più strati, o ripetere quello che c&apos;è.</translation>
    </message>
    <message>
        <source>it claims to have %1 points, more than any machine can hold. Its description is wrong: check the sizes.</source>
        <translation>dichiara %1 punti, più di quanti un computer possa contenere. La descrizione è sbagliata: controllare le dimensioni.</translation>
    </message>
    <message>
        <source>its spacing is %1. The distance between neighbouring points must be a positive number along each axis.</source>
        <translation>la sua spaziatura è %1. La distanza fra punti vicini deve essere un numero positivo lungo ogni asse.</translation>
    </message>
    <message>
        <source>its origin %1 is so far away for the spacing %2 that neighbouring points coincide. Move the origin nearer to 0.</source>
        <translation>la sua origine %1 è così lontana per la spaziatura %2 che punti vicini coincidono. Avvicinare l&apos;origine a 0.</translation>
    </message>
    <message>
        <source>%1 of its %2 samples are NaN or infinite, the first at point (%3, %4, %5). Replace them with numbers first.</source>
        <translation>%1 dei suoi %2 campioni sono NaN o infiniti, il primo nel punto (%3, %4, %5). Sostituirli prima con numeri.</translation>
    </message>
    <message>
        <source>point %1 has an invalid or extremely large position. Repair the file.</source>
        <translation>la posizione del punto %1 non è un numero, o è ben oltre ciò con cui si può calcolare. Riparare il file.</translation>
    </message>
    <message>
        <source>%1 values are too large for single precision, or not numbers. Choose another array.</source>
        <translation>%1 valori sono troppo grandi per la precisione singola, o non sono numeri. Scegliere un altro vettore.</translation>
    </message>
    <message>
        <source>all its points lie in a plane, or so close to one that no cell has a volume. TAn needs volumes.</source>
        <translation>tutti i suoi punti giacciono in un piano o meno, perciò nessuna cella ha volume. TAn accetta volumi.</translation>
    </message>
    <message>
        <source>Cannot use &apos;%1&apos;: %2</source>
        <translation>«%1» non può essere usato: %2</translation>
    </message>
    <message>
        <source>it has %1 values for %2 points. Give one value for each point.</source>
        <translation>ha %1 valori per %2 punti. Darne uno a ogni punto.</translation>
    </message>
    <message>
        <source>it has no points.</source>
        <translation>non ha punti.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than 4294967295 points. Take a part of them.</source>
        <translation>«%1» ha più di 4294967295 punti. Prenderne una parte.</translation>
    </message>
    <message>
        <source>A stride is a whole number of at least 1.</source>
        <translation>Un passo è un numero intero da 1.</translation>
    </message>
    <message>
        <source>The part has %1 points along %2, and a volume needs at least two along each axis. Choose a larger region or a smaller stride.</source>
        <translation>La parte ha %1 punti lungo %2, e un volume ne richiede almeno due lungo ogni asse. Prendere una regione più grande o un passo più piccolo.</translation>
    </message>
    <message>
        <source>No cell of the part has a volume. Choose another region or a smaller stride.</source>
        <translation>Nessuna cella della parte ha un volume. Prendere un&apos;altra regione o un passo più piccolo.</translation>
    </message>
    <message>
        <source>Part of the data: %1 of the %2 points.</source>
        <translation>Una parte di %1 dei %2 punti.</translation>
    </message>
    <message>
        <source>The region holds %1. Choose a larger one; &apos;bounds&apos; of &apos;tan info&apos; tells where the points lie.</source>
        <translation>La regione contiene %1. Prenderne una più grande; «bounds» di «tan info» dice dove stanno i punti.</translation>
    </message>
    <message>
        <source>no whole tetrahedron</source>
        <translation>nessun tetraedro intero</translation>
    </message>
    <message>
        <source>1 tetrahedron inside the region was left out: it touches the others only at a vertex or an edge.</source>
        <translation>1 tetraedro nella regione è stato omesso: tocca gli altri solo in un vertice o uno spigolo.</translation>
    </message>
    <message>
        <source>%1 tetrahedra inside the region were left out: they touch the others only at a vertex or an edge.</source>
        <translation>%1 tetraedri nella regione sono stati omessi: toccano gli altri solo in un vertice o uno spigolo.</translation>
    </message>
    <message>
        <source>%1 points, and a volume needs four</source>
        <translation>%1 punti, e un volume ne richiede quattro</translation>
    </message>
    <message>
        <source>A stride is for points of a grid only. Choose a region.</source>
        <translation>Solo i punti di una griglia si possono prendere con un passo. Prendere una regione.</translation>
    </message>
    <message>
        <source>Not enough memory for this part. Choose a smaller one.</source>
        <translation>La memoria non basta per questa parte. Prenderne una più piccola.</translation>
    </message>
    <message>
        <source>The region &apos;%1&apos; %2</source>
        <translation>La regione «%1» %2</translation>
    </message>
    <message>
        <source>is not understood. Give six numbers separated by commas: the first corner&apos;s and the last one&apos;s, as in 0,0,0,31,31,15.</source>
        <translation>non si capisce. Indicare sei numeri separati da virgole: quelli del primo vertice e quelli dell&apos;ultimo, come in 0,0,0,31,31,15.</translation>
    </message>
    <message>
        <source>holds &apos;%1&apos;, which is not a number.</source>
        <translation>contiene «%1», che non è un numero.</translation>
    </message>
    <message>
        <source>ends before it begins. Give the smaller numbers first.</source>
        <translation>finisce prima di cominciare. Indicare prima i numeri più piccoli.</translation>
    </message>
    <message>
        <source>The stride &apos;%1&apos; is not understood. Give one whole number of at least 1, or three separated by commas, as in 2,2,1.</source>
        <translation>Il passo «%1» non si capisce. Indicare un numero intero da 1, o tre separati da virgole, come in 2,2,1.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>There is no layer %1 along this axis.</source>
        <translation>Non c&apos;è uno strato %1 lungo questo asse.</translation>
    </message>
    <message>
        <source>The preview</source>
        <translation>L&apos;anteprima</translation>
    </message>
    <message>
        <source>Not enough memory: %1 samples of type %2 do not fit into the %3 MiB of this machine. Use a smaller part or a coarser version of the data.</source>
        <translation>La memoria non basta: %1 campioni di tipo %2 non stanno nei %3 MiB di questo computer. Usare una parte più piccola o una versione più grossolana dei dati.</translation>
    </message>
    <message>
        <source>the samples</source>
        <translation>i campioni</translation>
    </message>
    <message>
        <source>Not enough memory for the weights of %1 points. Build without weights, or close other programs.</source>
        <translation>La memoria non basta per i pesi di %1 punti. Costruire senza pesi, o chiudere altri programmi.</translation>
    </message>
    <message>
        <source>Weighting the points</source>
        <translation>Ponderazione dei punti</translation>
    </message>
    <message>
        <source>The weight &apos;%1&apos; cannot be used: %2.</source>
        <translation>Il peso «%1» non è utilizzabile: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>«%1» non è un numero</translation>
    </message>
    <message>
        <source>it has %1 numbers, and the form is %2</source>
        <translation>ha %1 numeri, e la forma è %2</translation>
    </message>
    <message>
        <source>its reach is %1 and must be at least 0</source>
        <translation>la sua portata è %1 e deve essere almeno 0</translation>
    </message>
    <message>
        <source>its reach is %1 and must be above 0</source>
        <translation>la sua portata è %1 e deve essere maggiore di 0</translation>
    </message>
    <message>
        <source>its floor is %1 and must be from %2 to 1</source>
        <translation>il suo minimo è %1 e deve essere da %2 a 1</translation>
    </message>
    <message>
        <source>a weight begins with &apos;point:&apos;, &apos;box:&apos; or &apos;value:&apos;</source>
        <translation>un peso comincia con «point:», «box:» o «value:»</translation>
    </message>
    <message>
        <source>its first corner must be the smaller one along every axis</source>
        <translation>il suo primo vertice deve essere il minore lungo ogni asse</translation>
    </message>
    <message>
        <source>The history has more than 4 billion tetrahedra. Decimate a part of the mesh.</source>
        <translation>La storia ha più di 4 miliardi di tetraedri. Decimare una parte della mesh.</translation>
    </message>
    <message>
        <source>The decimation</source>
        <translation>La decimazione</translation>
    </message>
    <message>
        <source>Writing the history</source>
        <translation>Scrittura della storia</translation>
    </message>
    <message>
        <source>Evaluating vertices</source>
        <translation>Valutazione dei vertici</translation>
    </message>
    <message>
        <source>Collapsing</source>
        <translation>Contrazione</translation>
    </message>
    <message>
        <source>Collapsing in rounds</source>
        <translation>Contrazione a turni</translation>
    </message>
    <message>
        <source>The mesh cannot be decimated: %1</source>
        <translation>La mesh non può essere decimata: %1</translation>
    </message>
    <message>
        <source>Meshes of more than 4294967294 points or 1073741823 tetrahedra cannot be decimated. Take a part.</source>
        <translation>Mesh di più di 4294967294 punti o 1073741823 tetraedri non possono essere decimate. Prenderne una parte.</translation>
    </message>
    <message>
        <source>it has no tetrahedra.</source>
        <translation>non ha tetraedri.</translation>
    </message>
    <message>
        <source>it does not have one value, weight and position for each of its %1 points.</source>
        <translation>non ha un valore, un peso e una posizione per ciascuno dei suoi %1 punti.</translation>
    </message>
    <message>
        <source>point %1 has no finite position.</source>
        <translation>il punto %1 non ha una posizione finita.</translation>
    </message>
    <message>
        <source>point %1 has no finite value.</source>
        <translation>il punto %1 non ha un valore finito.</translation>
    </message>
    <message>
        <source>weights must be above 0 and at most 1.</source>
        <translation>i pesi devono essere sopra 0 e al massimo 1.</translation>
    </message>
    <message>
        <source>a tetrahedron has vertex %1, which does not exist.</source>
        <translation>un tetraedro ha il vertice %1, che non esiste.</translation>
    </message>
    <message>
        <source>point %1 is in no tetrahedron. Leave it out.</source>
        <translation>il punto %1 non è in nessun tetraedro. Ometterlo.</translation>
    </message>
    <message>
        <source>The weight of the warping must be a positive number.</source>
        <translation>Il peso della deformazione deve essere un numero positivo.</translation>
    </message>
    <message>
        <source>The error at which to stop must not be negative.</source>
        <translation>L&apos;errore a cui fermarsi non può essere negativo.</translation>
    </message>
    <message>
        <source>Not enough memory to decimate this mesh. Close other programs, use a machine with more memory, or take a part of the data.</source>
        <translation>La memoria non basta per decimare questa mesh. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>point %1 is not in the dataset</source>
        <translation>il punto %1 non è nell&apos;insieme di dati</translation>
    </message>
    <message>
        <source>the error before it is not a number of at least 0</source>
        <translation>l&apos;errore precedente non è un numero da 0 in su</translation>
    </message>
    <message>
        <source>The history has more than 4294967295 tetrahedra. Choose a larger error, or build in blocks.</source>
        <translation>La storia ha più di 4294967295 tetraedri. Chiedere un errore più grande, o costruire a blocchi.</translation>
    </message>
    <message>
        <source>a tetrahedron of its star has a site that comes after it</source>
        <translation>un tetraedro della sua stella ha un sito che viene dopo di esso</translation>
    </message>
    <message>
        <source>a tetrahedron of its star has a site twice</source>
        <translation>un tetraedro della sua stella ha due volte un sito</translation>
    </message>
    <message>
        <source>a tetrahedron of its star has an error or a warping that is not a number of at least 0</source>
        <translation>un tetraedro della sua stella ha un errore o una deformazione che non è un numero da 0 in su</translation>
    </message>
    <message>
        <source>it destroys tetrahedron %1, which is not in the mesh</source>
        <translation>distrugge il tetraedro %1, che non è nella mesh</translation>
    </message>
    <message>
        <source>it destroys tetrahedron %1 twice</source>
        <translation>distrugge due volte il tetraedro %1</translation>
    </message>
    <message>
        <source>The finest mesh would have about %1 tetrahedra, and a model holds meshes of at most %2. Choose a larger error, or take a part of the dataset.</source>
        <translation>La mesh più fine avrebbe circa %1 tetraedri, e un modello contiene mesh di al massimo %2. Chiedere un errore più grande, o prendere una parte dell&apos;insieme di dati.</translation>
    </message>
    <message>
        <source>Refining the blocks</source>
        <translation>Raffinamento dei blocchi</translation>
    </message>
    <message>
        <source>Not enough memory to refine blocks of this size. Close other programs, use fewer threads or choose smaller blocks.</source>
        <translation>La memoria non basta per raffinare blocchi di queste dimensioni. Chiudere altri programmi, usare meno thread o scegliere blocchi più piccoli.</translation>
    </message>
    <message>
        <source>The model would have more than 4294967294 sites. Choose a larger error, or take a part of the dataset.</source>
        <translation>Il modello avrebbe più di 4294967294 siti. Chiedere un errore più grande, o prendere una parte dell&apos;insieme di dati.</translation>
    </message>
    <message>
        <source>Merging the blocks</source>
        <translation>Unione dei blocchi</translation>
    </message>
    <message>
        <source>Numbering the sites</source>
        <translation>Numerazione dei siti</translation>
    </message>
    <message>
        <source>Not enough memory to merge the blocks. Close other programs, or choose a larger error.</source>
        <translation>La memoria non basta per unire i blocchi. Chiudere altri programmi, o chiedere un errore più grande.</translation>
    </message>
    <message>
        <source>its star offsets do not match its mesh sizes</source>
        <translation>gli inizi delle stelle non corrispondono alle dimensioni delle mesh</translation>
    </message>
    <message>
        <source>the mesh of %1 sites has %2 tetrahedra instead of %3</source>
        <translation>la mesh di %1 siti ha %2 tetraedri invece di %3</translation>
    </message>
    <message>
        <source>a tetrahedron of site %1 or soon after has a site that comes after its creator</source>
        <translation>un tetraedro del sito %1 o poco dopo ha un sito che viene dopo il suo creatore</translation>
    </message>
    <message>
        <source>a tetrahedron of site %1 has a site that comes after its creator</source>
        <translation>un tetraedro del sito %1 ha un sito che viene dopo il suo creatore</translation>
    </message>
    <message>
        <source>the mesh of %1 sites has more than the %2 tetrahedra that it should have</source>
        <translation>la mesh di %1 siti ha più dei %2 tetraedri che dovrebbe avere</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 sites, fewer than the %3 requested.</source>
        <translation>«%1» ha %2 siti, meno dei %3 richiesti.</translation>
    </message>
    <message>
        <source>The first %1 sites of &apos;%2&apos; have no mesh of their own: site %3 enters together with the one before it.</source>
        <translation>I primi %1 siti di «%2» non hanno una mesh propria: il sito %3 entra insieme a quello precedente.</translation>
    </message>
    <message>
        <source>Not enough memory for a mesh of %1 sites. Choose a larger error.</source>
        <translation>La memoria non basta per una mesh di %1 siti. Scegliere un errore più grande.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not end in .csv or .json, the formats of statistics. Choose one of these endings.</source>
        <translation>«%1» non termina né in .csv né in .json, i formati in cui si scrivono le statistiche. Scegliere una di queste estensioni.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2. Copy the file again, or build it again.</source>
        <translation>«%1» è danneggiato: %2. Copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is cut short: it has %2 bytes and should have %3. Copy the file again, or build it again.</source>
        <translation>«%1» è troncato: ha %2 byte e dovrebbe averne %3. Copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. Models are made by &apos;tan build&apos;.</source>
        <translation>«%1» è vuoto. I modelli si costruiscono da insiemi di dati.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a TAn model: it does not begin like one. Models are made by &apos;tan build&apos;.</source>
        <translation>«%1» non è un modello TAn: non comincia come tale. I modelli si costruiscono da insiemi di dati.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was written with the other byte order. Build it again on this machine.</source>
        <translation>«%1» è scritto nell&apos;altro ordine dei byte. Ricostruirlo su questo computer.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has format version %2.%3; this program reads up to version %4. Install a later version of TAn.</source>
        <translation>«%1» ha la versione di formato %2.%3; questo programma legge fino alla versione %4. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>its header is invalid</source>
        <translation>la sua intestazione non ha senso</translation>
    </message>
    <message>
        <source>the checksum of its header is wrong</source>
        <translation>la somma di controllo della sua intestazione è sbagliata</translation>
    </message>
    <message>
        <source>it has %1 bytes and should have %2</source>
        <translation>ha %1 byte e dovrebbe averne %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a model of domain class %2, which this version cannot read. Install a later version of TAn.</source>
        <translation>«%1» è un modello della classe %2, che questa versione non sa leggere. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has samples of type %2, which this version cannot read. Install a later version of TAn.</source>
        <translation>«%1» ha campioni di tipo %2, che questa versione non sa leggere. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>a lattice of %1 x %2 x %3 points is impossible</source>
        <translation>un reticolo di %1 x %2 x %3 punti è impossibile</translation>
    </message>
    <message>
        <source>the spacing or the origin of its lattice is invalid</source>
        <translation>la spaziatura o l&apos;origine del suo reticolo non ha senso</translation>
    </message>
    <message>
        <source>%1 points cannot have %2 sites and %3 tetrahedra</source>
        <translation>%1 punti non possono avere %2 siti e %3 tetraedri</translation>
    </message>
    <message>
        <source>its value range or its final error is invalid</source>
        <translation>il suo intervallo di valori o il suo errore finale non ha senso</translation>
    </message>
    <message>
        <source>its bounding box is invalid</source>
        <translation>il suo parallelepipedo limite non ha senso</translation>
    </message>
    <message>
        <source>its warping weight or its handedness is invalid</source>
        <translation>il suo peso della deformazione o la sua orientazione non ha senso</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; appears twice</source>
        <translation>la sezione «%1» compare due volte</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; cannot begin at byte %2</source>
        <translation>la sezione «%1» non può cominciare al byte %2</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; reaches beyond the end of the file</source>
        <translation>la sezione «%1» va oltre la fine del file</translation>
    </message>
    <message>
        <source>its last section ends at byte %1 of %2</source>
        <translation>la sua ultima sezione finisce al byte %1 di %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs section %2, which this version does not know. Install a later version of TAn.</source>
        <translation>«%1» richiede la sezione %2, che questa versione non conosce. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; packs its section &apos;%2&apos; with codec %3, which this version does not know. Install a later version of TAn.</source>
        <translation>«%1» comprime la sezione «%2» con il codec %3, che questa versione non conosce. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>its text section is missing or too long</source>
        <translation>la sua sezione di testo manca o è troppo lunga</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is missing</source>
        <translation>manca la sezione «%1»</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; has %2 bytes in elements of %3 instead of %4 elements of %5</source>
        <translation>la sezione «%1» ha %2 byte in elementi di %3 invece di %4 elementi di %5</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: the names and parameters of the model are longer than 1 MiB. Shorten them.</source>
        <translation>«%1» non può essere scritto: i nomi e i parametri del modello superano 1 MiB. Accorciarli.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: the checksum of its history kind is wrong. Copy the file again, or build it again.</source>
        <translation>«%1» è danneggiato: la somma di controllo del tipo di storia è sbagliata. Copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has a history of kind %2, which this version cannot read. Install a later version of TAn.</source>
        <translation>«%1» ha una storia di tipo %2, che questa versione non sa leggere. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: the checksum of its text is wrong. Copy the file again, or build it again.</source>
        <translation>«%1» è danneggiato: la somma di controllo del suo testo è sbagliata. Copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>Checking the model&apos;s file</source>
        <translation>Controllo del file del modello</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was open. Open it again; if that fails, copy the file again, or build it again.</source>
        <translation>«%1» è stato troncato o cambiato mentre era aperto. Aprirlo di nuovo; se non riesce, copiare di nuovo il file, o ricostruirlo.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; made a history that differs from the one it announced. Nothing was written; report this to its author.</source>
        <translation>La costruzione «%1» ha fatto una storia diversa da quella annunciata. Nulla è stato scritto; segnalarlo al suo autore.</translation>
    </message>
    <message>
        <source>its warping weight is %1</source>
        <translation>il suo peso della deformazione è %1</translation>
    </message>
    <message>
        <source>meshes of irregular data are not Delaunay meshes</source>
        <translation>le mesh di dati irregolari non sono di Delaunay</translation>
    </message>
    <message>
        <source>its blocks have %1 x %2 x %3 cells</source>
        <translation>i suoi blocchi hanno %1 x %2 x %3 celle</translation>
    </message>
    <message>
        <source>%1 data need a warping weight</source>
        <translation>questi dati (%1) richiedono un peso della deformazione</translation>
    </message>
    <message>
        <source>a model needs at least the sites of its first mesh</source>
        <translation>un modello richiede almeno i siti di una prima mesh</translation>
    </message>
    <message>
        <source>the final error is not a number of at least 0</source>
        <translation>l&apos;errore finale non è un numero da 0 in su</translation>
    </message>
    <message>
        <source>The build was stopped before there was a mesh of known error, so there is nothing to keep.</source>
        <translation>La costruzione è stata fermata prima che ci fosse una mesh di errore noto, perciò non c&apos;è nulla da conservare.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; made a history that is wrong at site %2: %3. Nothing was written; report this to its author.</source>
        <translation>La costruzione «%1» ha fatto una storia sbagliata al sito %2: %3. Nulla è stato scritto; segnalarlo al suo autore.</translation>
    </message>
    <message>
        <source>Not enough memory to write &apos;%1&apos; after %2 sites. Choose a larger error, or close other programs.</source>
        <translation>Dopo %2 siti la memoria non basta per scrivere «%1». Chiedere un errore più grande, o chiudere altri programmi.</translation>
    </message>
    <message>
        <source>A model holds at most 4294967296 points, and &apos;%1&apos; has %2. Take a part of it.</source>
        <translation>Un modello contiene al massimo 4294967296 punti, e «%1» ne ha %2. Prenderne una parte.</translation>
    </message>
    <message>
        <source>a tetrahedron is destroyed before it is created</source>
        <translation>un tetraedro viene distrutto prima di essere creato</translation>
    </message>
    <message>
        <source>Reading the history</source>
        <translation>Esame della storia</translation>
    </message>
    <message>
        <source>its destroyers changed while they were read</source>
        <translation>i suoi distruttori sono cambiati durante la lettura</translation>
    </message>
    <message>
        <source>Selecting the sites</source>
        <translation>Scelta dei siti</translation>
    </message>
    <message>
        <source>The coarsest mesh of &apos;%1&apos; has %2 tetrahedra, more than the budget of %3. Allow at least that many.</source>
        <translation>La mesh più grossolana di «%1» ha %2 tetraedri, più del budget di %3. Permetterne almeno altrettanti.</translation>
    </message>
    <message>
        <source>its running errors do not bound the errors of its tetrahedra</source>
        <translation>i suoi errori correnti non limitano quelli propri dei tetraedri</translation>
    </message>
    <message>
        <source>its tetrahedra do not match its mesh sizes</source>
        <translation>i suoi tetraedri non corrispondono alle dimensioni delle mesh</translation>
    </message>
    <message>
        <source>its mesh sizes are invalid</source>
        <translation>le dimensioni delle sue mesh non hanno senso</translation>
    </message>
    <message>
        <source>a tetrahedron has a site that its creator does not need</source>
        <translation>un tetraedro ha un sito di cui il suo creatore non ha bisogno</translation>
    </message>
    <message>
        <source>its coarse tetrahedra do not fit together</source>
        <translation>i suoi tetraedri grossolani non combaciano</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not made by inserting points into Delaunay meshes, so points cannot be inserted now. Use a closed set, or the automatic choice.</source>
        <translation>«%1» non è stato fatto inserendo punti in mesh di Delaunay, perciò ora non se ne possono inserire. Usare un insieme chiuso, o la scelta automatica.</translation>
    </message>
    <message>
        <source>Examining the mesh</source>
        <translation>Esame della mesh</translation>
    </message>
    <message>
        <source>The mesh of the focus became too large. Choose a larger error or a smaller focus.</source>
        <translation>La mesh del focus è diventata troppo grande. Scegliere un errore maggiore o un focus più piccolo.</translation>
    </message>
    <message>
        <source>a sample lies in no tetrahedron</source>
        <translation>un campione non sta in nessun luogo</translation>
    </message>
    <message>
        <source>a site is not a point of its grid</source>
        <translation>un sito non è un punto della sua griglia</translation>
    </message>
    <message>
        <source>Refining the focus</source>
        <translation>Raffinamento del focus</translation>
    </message>
    <message>
        <source>Not enough memory for the mesh of the focus. Choose a larger error or a smaller focus.</source>
        <translation>La memoria non basta per la mesh del focus. Scegliere un errore maggiore o un focus più piccolo.</translation>
    </message>
    <message>
        <source>the end of the text</source>
        <translation>la fine del testo</translation>
    </message>
    <message>
        <source>fewer fields: at most %1, nested up to %2 levels deep</source>
        <translation>meno campi: al massimo %1, annidati %2 volte</translation>
    </message>
    <message>
        <source>a number or one of %1</source>
        <translation>un numero o uno di %1</translation>
    </message>
    <message>
        <source>a half-space whose first three numbers are not all 0</source>
        <translation>un semispazio i cui primi tre numeri non sono tutti 0</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un numero</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>un numero finito</translation>
    </message>
    <message>
        <source>a number, or the name of a field</source>
        <translation>un numero, o il nome di un campo</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>un numero non negativo</translation>
    </message>
    <message>
        <source>a number of fewer than 308 digits</source>
        <translation>un numero di meno di 308 cifre</translation>
    </message>
    <message>
        <source>The error field cannot be read at character %1: expected %2, but the text ends.</source>
        <translation>Il campo d&apos;errore non può essere letto al carattere %1: ci si aspetta %2, ma il testo finisce.</translation>
    </message>
    <message>
        <source>The error field cannot be read at character %1: expected %2, but found &apos;%3&apos;.</source>
        <translation>Il campo d&apos;errore non può essere letto al carattere %1: ci si aspetta %2, ma c&apos;è «%3».</translation>
    </message>
    <message>
        <source>Extracting a range of meshes</source>
        <translation>Estrazione di un intervallo di mesh</translation>
    </message>
    <message>
        <source>the meshes of %1 and %2 sites do not have the expected %3 and %4 tetrahedra</source>
        <translation>le mesh di %1 e %2 siti non hanno i %3 e %4 tetraedri che dovrebbero avere</translation>
    </message>
    <message>
        <source>a tetrahedron of site %1 is destroyed by a site that does not come after it</source>
        <translation>un tetraedro del sito %1 è distrutto da un sito che non viene dopo di esso</translation>
    </message>
    <message>
        <source>its first sites have an error</source>
        <translation>i suoi primi siti hanno un errore</translation>
    </message>
    <message>
        <source>Clip exactly is not available for meshes of several accuracies. Choose the tetrahedra that intersect the crop box, or those it contains.</source>
        <translation>Mesh di più accuratezze non si possono tagliare a una finestra: ciò che è tagliato non ha vita propria. Chiedere i tetraedri che intersecano la finestra, o che essa contiene.</translation>
    </message>
    <message>
        <source>The coarsest mesh has %1 tetrahedra, more than the budget of %2. Allow at least that many.</source>
        <translation>La mesh più grossolana ha %1 tetraedri, più del budget di %2. Permetterne almeno altrettanti.</translation>
    </message>
    <message>
        <source>%1. Use a closed set, or the automatic choice.</source>
        <translation>%1. Usare un insieme chiuso, o la scelta automatica.</translation>
    </message>
    <message>
        <source>Insertion is for lattices and curvilinear grids, not for scattered points</source>
        <translation>L&apos;inserimento è per reticoli e griglie curvilinee, non per punti sparsi</translation>
    </message>
    <message>
        <source>Insertion needs a model made by refinement, whose meshes are Delaunay meshes</source>
        <translation>L&apos;inserimento richiede un modello fatto per raffinamento, le cui mesh sono di Delaunay</translation>
    </message>
    <message>
        <source>Insertion needs all samples of the dataset, which the file of this model does not hold</source>
        <translation>L&apos;inserimento richiede tutti i campioni dell&apos;insieme di dati, che il file di questo modello non contiene</translation>
    </message>
    <message>
        <source>Insertion into a lattice is for one box, sphere or half-space of smaller error</source>
        <translation>L&apos;inserimento in un reticolo è per un parallelepipedo, una sfera o un semispazio di errore minore</translation>
    </message>
    <message>
        <source>Insertion within a budget needs a sharp border, or an error of at least %1 to fall off from</source>
        <translation>L&apos;inserimento entro un budget richiede un bordo netto, o un errore di almeno %1 da cui decrescere</translation>
    </message>
    <message>
        <source>Insertion cannot tell how this model was built, or its grid is too large</source>
        <translation>L&apos;inserimento non sa come questo modello è stato costruito, o la sua griglia è troppo grande</translation>
    </message>
    <message>
        <source>Searching for the best mesh within the budget</source>
        <translation>Prova di ciò che il budget permette</translation>
    </message>
    <message>
        <source>There is not enough memory for this mesh. Choose a larger error, a smaller focus or a budget.</source>
        <translation>La memoria non basta per questa mesh. Scegliere un errore maggiore, un focus più piccolo o un budget.</translation>
    </message>
    <message>
        <source>The smallest %1 of the crop box, %2, is larger than its largest, %3. Swap them.</source>
        <translation>Il %1 minimo della finestra, %2, è maggiore del massimo, %3. Scambiarli.</translation>
    </message>
    <message>
        <source>The largest error is not a number everywhere. Give it in percent at every place.</source>
        <translation>L&apos;errore massimo in qualche punto non è un numero. Indicarlo ovunque in percentuale.</translation>
    </message>
    <message>
        <source>The largest warping is not a number everywhere. Give it in percent at every place.</source>
        <translation>La deformazione massima in qualche punto non è un numero. Indicarla ovunque in percentuale.</translation>
    </message>
    <message>
        <source>A budget of zero tetrahedra allows no mesh of &apos;%1&apos;.</source>
        <translation>Un budget di zero tetraedri non permette nessuna mesh di «%1».</translation>
    </message>
    <message>
        <source>A range of values goes from a smaller number to a larger one: %1 and %2 do not.</source>
        <translation>Un intervallo di valori va da un numero più piccolo a uno più grande: %1 e %2 no.</translation>
    </message>
    <message>
        <source>a site is not a point of its lattice</source>
        <translation>un sito non è un punto del suo reticolo</translation>
    </message>
    <message>
        <source>The error in the focus is larger than that outside. Swap them.</source>
        <translation>L&apos;errore nel focus è maggiore di quello esterno. Scambiarli.</translation>
    </message>
    <message>
        <source>Cutting at the crop box</source>
        <translation>Taglio alla finestra</translation>
    </message>
    <message>
        <source>The mesh cut at the crop box has too many vertices: choose a larger error or a smaller box.</source>
        <translation>La mesh tagliata alla finestra ha troppi vertici: scegliere un errore più grande o una finestra più piccola.</translation>
    </message>
    <message>
        <source>Not enough memory to cut a mesh of %1 tetrahedra at a crop box. Choose a larger error or a smaller box.</source>
        <translation>La memoria non basta per tagliare a una finestra una mesh di %1 tetraedri. Scegliere un errore più grande o una finestra più piccola.</translation>
    </message>
    <message>
        <source>the checksum of section &apos;%1&apos; is wrong</source>
        <translation>la somma di controllo della sezione «%1» è sbagliata</translation>
    </message>
    <message>
        <source>chunks of %1 bytes are impossible</source>
        <translation>pezzi di %1 byte sono impossibili</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; has %2 bytes instead of %3 elements of 8</source>
        <translation>la sezione «%1» ha %2 byte invece di %3 elementi da 8</translation>
    </message>
    <message>
        <source>its star offsets do not match its tetrahedra</source>
        <translation>gli inizi delle stelle non corrispondono ai tetraedri</translation>
    </message>
    <message>
        <source>the star offsets of site %1 are invalid</source>
        <translation>gli inizi delle stelle del sito %1 non hanno senso</translation>
    </message>
    <message>
        <source>%1 was cancelled.</source>
        <translation>Annullato: %1.</translation>
    </message>
    <message>
        <source>regular</source>
        <translation>regolare</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>curvilineo</translation>
    </message>
    <message>
        <source>irregular</source>
        <translation>irregolare</translation>
    </message>
    <message>
        <source>scattered</source>
        <translation>sparso</translation>
    </message>
    <message>
        <source>Ordering the mesh</source>
        <translation>Ordinamento della mesh</translation>
    </message>
    <message>
        <source>A tetrahedron has a corner that does not exist.</source>
        <translation>Un tetraedro ha un vertice che non esiste.</translation>
    </message>
    <message>
        <source>The mesh and its values do not belong together.</source>
        <translation>La mesh e i suoi valori non vanno insieme.</translation>
    </message>
    <message>
        <source>Not enough memory to put the mesh in spatial order. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per ordinare la mesh nello spazio. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>the state of the refinement&apos;s tetrahedra</source>
        <translation>lo stato dei tetraedri del raffinamento</translation>
    </message>
    <message>
        <source>The mesh grew beyond what was reserved for it.</source>
        <translation>La mesh è cresciuta oltre ciò che era riservato per essa.</translation>
    </message>
    <message>
        <source>The grid has too many points to be refined: its coordinates need more than 32 bits. Crop or subsample it.</source>
        <translation>La griglia ha troppi punti per essere raffinata: le coordinate richiedono più di 32 bit. Ritagliarla o sottocampionarla.</translation>
    </message>
    <message>
        <source>Distributing the points</source>
        <translation>Distribuzione dei punti</translation>
    </message>
    <message>
        <source>Not enough memory to refine this grid. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>La memoria non basta per raffinare questa griglia. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>%1 A tetrahedral mesh needs four points that do not lie in one plane.</source>
        <translation>%1 Una mesh di tetraedri richiede quattro punti che non giacciono in un piano.</translation>
    </message>
    <message>
        <source>There are only %1 points.</source>
        <translation>Ci sono solo %1 punti.</translation>
    </message>
    <message>
        <source>All points lie at one place.</source>
        <translation>Tutti i punti stanno nello stesso luogo.</translation>
    </message>
    <message>
        <source>All points lie on one line.</source>
        <translation>Tutti i punti stanno su una retta.</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>Tutti i punti stanno in un piano.</translation>
    </message>
    <message>
        <source>Points %1 and %2 (counted from 0) lie at the same place. Merge such points first.</source>
        <translation>I punti %1 e %2 (contati da 0) stanno nello stesso luogo. Unire prima tali punti.</translation>
    </message>
    <message>
        <source>Finding the convex hull</source>
        <translation>Ricerca dell&apos;inviluppo convesso</translation>
    </message>
    <message>
        <source>The refinement</source>
        <translation>Il raffinamento</translation>
    </message>
    <message>
        <source>Point %1 lies outside the computed convex hull. Coordinates of such different magnitudes cannot be used; scale them.</source>
        <translation>Il punto %1 è fuori dall&apos;inviluppo convesso calcolato. Coordinate di grandezze così diverse non si possono usare; riscalarle.</translation>
    </message>
    <message>
        <source>The history has more than 4 billion tetrahedra. Choose a larger error.</source>
        <translation>La storia ha più di 4 miliardi di tetraedri. Chiedere un errore più grande.</translation>
    </message>
    <message>
        <source>At most 4294967294 scattered points can be refined. Take a part.</source>
        <translation>Si possono raffinare al massimo 4294967294 punti sparsi. Prenderne una parte.</translation>
    </message>
    <message>
        <source>Not enough memory to refine these points. Close other programs, use a machine with more memory, or take a part of the points.</source>
        <translation>La memoria non basta per raffinare questi punti. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei punti.</translation>
    </message>
    <message>
        <source>Refining</source>
        <translation>Raffinamento</translation>
    </message>
    <message>
        <source>the vertices of the mesh&apos;s tetrahedra</source>
        <translation>i vertici dei tetraedri della mesh</translation>
    </message>
    <message>
        <source>the state of the mesh&apos;s tetrahedra</source>
        <translation>lo stato dei tetraedri della mesh</translation>
    </message>
    <message>
        <source>the set of the mesh&apos;s points</source>
        <translation>l&apos;insieme dei punti della mesh</translation>
    </message>
    <message>
        <source>The lattice has too many points to be refined as a whole. Crop or subsample it.</source>
        <translation>Il reticolo ha troppi punti per essere raffinato per intero. Ritagliarlo o sottocampionarlo.</translation>
    </message>
    <message>
        <source>the tetrahedra of the refinement</source>
        <translation>i tetraedri del raffinamento</translation>
    </message>
    <message>
        <source>A block of the lattice needs at least two points along each axis and must lie within it. Choose another block size.</source>
        <translation>Un blocco del reticolo richiede due punti lungo ogni asse e non deve sporgere. Scegliere un&apos;altra dimensione dei blocchi.</translation>
    </message>
    <message>
        <source>A block of the lattice is too large to be refined with exact arithmetic. Choose a smaller block size.</source>
        <translation>Un blocco del reticolo è troppo grande per essere raffinato con aritmetica esatta. Scegliere blocchi più piccoli.</translation>
    </message>
    <message>
        <source>Not enough memory to refine this lattice. Close other programs, use a machine with more memory, or crop or subsample the data.</source>
        <translation>La memoria non basta per raffinare questo reticolo. Chiudere altri programmi, usare un computer con più memoria, o prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>the lists of the refinement&apos;s points</source>
        <translation>gli elenchi dei punti del raffinamento</translation>
    </message>
    <message>
        <source>A lattice of %1 x %2 x %3 points is too large to be refined as a whole with exact arithmetic (512 x 512 x 512 is about the limit). Crop or subsample it.</source>
        <translation>Un reticolo di %1 x %2 x %3 punti è troppo grande per essere raffinato per intero con aritmetica esatta (il limite è circa 512 x 512 x 512). Ritagliarlo o sottocampionarlo.</translation>
    </message>
    <message>
        <source>More than %1 points cannot be refined at once. Crop or subsample the data.</source>
        <translation>Non si possono raffinare insieme più di %1 punti. Ritagliare o sottocampionare i dati.</translation>
    </message>
    <message>
        <source>the points of the refinement</source>
        <translation>i punti del raffinamento</translation>
    </message>
    <message>
        <source>the marks of the refinement&apos;s points</source>
        <translation>i segni dei punti del raffinamento</translation>
    </message>
    <message>
        <source>Finding the boundary</source>
        <translation>Ricerca del contorno</translation>
    </message>
    <message>
        <source>Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per il contorno della mesh. Ridurre la accuratezza della mesh.</translation>
    </message>
    <message>
        <source>The boundary&apos;s opacity must be above 0 and at most 1.</source>
        <translation>L&apos;opacità del contorno deve essere sopra 0 e al massimo 1.</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not a number from %2 to %3 (%4).</source>
        <translation>La chiave «%1» della camera non è un numero da %2 a %3 (%4).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is neither true nor false (%2).</source>
        <translation>La chiave «%1» della camera non è né true né false (%2).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not one of x, -x, y, -y, z and -z (%2).</source>
        <translation>La chiave «%1» della camera non è nessuno di x, -x, y, -y, z e -z (%2).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not known (%2).</source>
        <translation>La chiave «%1» della camera non è nota (%2).</translation>
    </message>
    <message>
        <source>The key &quot;%1&quot; of the camera is not a list of three numbers (%2).</source>
        <translation>La chiave «%1» della camera non è un elenco di tre numeri (%2).</translation>
    </message>
    <message>
        <source>This is not a camera. %1</source>
        <translation>Questa non è una camera. %1</translation>
    </message>
    <message>
        <source>This is not a camera: it holds no JSON object, in braces.</source>
        <translation>Questa non è una camera: non contiene un oggetto JSON, fra graffe.</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Disegno dell&apos;immagine</translation>
    </message>
    <message>
        <source>The scene has more than two billion vertices.</source>
        <translation>La scena ha più di due miliardi di vertici.</translation>
    </message>
    <message>
        <source>OpenGL without a window needs EGL, and %1 cannot be loaded. Install it (Debian: libegl1), or use the CPU back end.</source>
        <translation>OpenGL senza finestra richiede EGL, e %1 non può essere caricato. Installarlo (Debian: libegl1), o far disegnare il processore.</translation>
    </message>
    <message>
        <source>%1 has no %2. Install EGL 1.4, or use the CPU back end.</source>
        <translation>%1 non ha %2. Installare EGL 1.4, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>EGL provides no OpenGL 3.3 without a window on this machine. Install the driver of the graphics card or Mesa (Debian: libgl1-mesa-dri), or use the CPU back end.</source>
        <translation>EGL su questo computer non dà OpenGL 3.3 senza finestra. Installare il driver della scheda o Mesa (Debian: libgl1-mesa-dri), o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The OpenGL context cannot be used, perhaps because the graphics card was reset. Use the CPU back end.</source>
        <translation>Il contesto OpenGL non è utilizzabile, forse perché la scheda grafica è stata reinizializzata. Far disegnare il processore.</translation>
    </message>
    <message>
        <source>A surface has too many triangles for OpenGL. Use the CPU back end.</source>
        <translation>Una superficie ha troppi triangoli per OpenGL. Far disegnare il processore.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for this surface. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per questa superficie. Ridurre l&apos;accuratezza della mesh, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for this volume. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per questo volume. Ridurre l&apos;accuratezza della mesh, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>This OpenGL driver draws volumes of at most %1 vertices. Lower the accuracy of the mesh, or use the CPU back end.</source>
        <translation>Questo driver OpenGL disegna volumi di al massimo %1 vertici. Ridurre l&apos;accuratezza della mesh, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The OpenGL driver of this machine rejects a shader of TAn. Use the CPU back end, or another driver. It reports: %1</source>
        <translation>Il driver OpenGL di questo computer rifiuta uno shader di TAn. Far disegnare il processore, o usare un altro driver. Dice: %1</translation>
    </message>
    <message>
        <source>OpenGL supports at most %1 clip planes. Use fewer, or use the CPU back end.</source>
        <translation>OpenGL taglia le scene con al più %1 piani. Usarne meno, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for a picture of this size. Make it smaller, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per un&apos;immagine di queste dimensioni. Rimpicciolirla, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The OpenGL driver cannot draw into floating-point textures, which OpenGL 3.3 requires. Use the CPU back end.</source>
        <translation>Il driver OpenGL non sa disegnare in texture a virgola mobile, che OpenGL 3.3 richiede. Far disegnare il processore.</translation>
    </message>
    <message>
        <source>This OpenGL driver draws at most %1 samples per side. Make the picture smaller, use fewer samples, or use the CPU back end.</source>
        <translation>Questo driver OpenGL disegna al massimo %1 campioni per lato. Rimpicciolire l&apos;immagine, usare meno campioni, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>The OpenGL driver has no function %1, so it is older than OpenGL 3.3. Use the CPU back end, or another driver.</source>
        <translation>Il driver OpenGL non ha la funzione %1, perciò è più vecchio di OpenGL 3.3. Far disegnare il processore, o usare un altro driver.</translation>
    </message>
    <message>
        <source>The OpenGL driver has version %1.%2; TAn needs 3.3. Use the CPU back end, or another driver.</source>
        <translation>Il driver OpenGL ha la versione %1.%2; TAn richiede la 3.3. Far disegnare il processore, o usare un altro driver.</translation>
    </message>
    <message>
        <source>The graphics card does not have enough memory for this picture. Make it smaller, or use the CPU back end.</source>
        <translation>La memoria della scheda grafica non basta per questa immagine. Rimpicciolirla, o far disegnare il processore.</translation>
    </message>
    <message>
        <source>Not enough memory for a picture of this size and scene. Make the picture smaller or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per un&apos;immagine di queste dimensioni e di questa scena. Rimpicciolire l&apos;immagine o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>The scene has more than four billion triangles.</source>
        <translation>La scena ha più di quattro miliardi di triangoli.</translation>
    </message>
    <message>
        <source>Drawing the volume</source>
        <translation>Disegno del volume</translation>
    </message>
    <message>
        <source>A volume of the scene and its transfer function do not belong together.</source>
        <translation>Un volume della scena e la sua funzione di trasferimento non vanno insieme.</translation>
    </message>
    <message>
        <source>Extracting the isosurface</source>
        <translation>Estrazione dell&apos;isosuperficie</translation>
    </message>
    <message>
        <source>The isovalue is not a number.</source>
        <translation>L&apos;isovalore non è un numero.</translation>
    </message>
    <message>
        <source>The mesh, its values, its gradients and its index do not belong together.</source>
        <translation>La mesh, i suoi valori, i gradienti e l&apos;indice non vanno insieme.</translation>
    </message>
    <message>
        <source>The isosurface has more than four billion vertices. Lower the accuracy of the mesh.</source>
        <translation>L&apos;isosuperficie ha più di quattro miliardi di vertici. Ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurface. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per l&apos;isosuperficie. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Extracting isosurfaces</source>
        <translation>Estrazione delle isosuperfici</translation>
    </message>
    <message>
        <source>An isovalue must be a finite number, and its opacity between 0 and 1.</source>
        <translation>Un isovalore deve essere un numero finito, e la sua opacità fra 0 e 1.</translation>
    </message>
    <message>
        <source>Not enough memory for the isosurfaces. Show fewer of them or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per le isosuperfici. Mostrarne meno o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a clip plane: give four numbers nx,ny,nz,offset, the first three not all zero; points with nx x + ny y + nz z &gt;= offset are shown.</source>
        <translation>«%1» non è un piano di taglio: dare quattro numeri nx,ny,nz,distanza, i primi tre non tutti nulli; si mostrano i punti con nx x + ny y + nz z &gt;= distanza.</translation>
    </message>
    <message>
        <source>A surface of the scene does not have one normal for each vertex.</source>
        <translation>Una superficie della scena non ha una normale per ogni vertice.</translation>
    </message>
    <message>
        <source>A surface of the scene does not have one value or colour for each vertex.</source>
        <translation>Una superficie della scena non ha un valore o un colore per ogni vertice.</translation>
    </message>
    <message>
        <source>A triangle of the scene has a corner that does not exist.</source>
        <translation>Un triangolo della scena ha un vertice che non esiste.</translation>
    </message>
    <message>
        <source>A line of the scene has an end that does not exist.</source>
        <translation>Una linea della scena ha un estremo che non esiste.</translation>
    </message>
    <message>
        <source>A picture cannot be %1 x %2 pixels. Each side must be 1 to %3.</source>
        <translation>Un&apos;immagine non può essere di %1 x %2 pixel. Ogni lato deve essere da 1 a %3.</translation>
    </message>
    <message>
        <source>The samples per axis of a pixel must be 1 to 4.</source>
        <translation>I campioni per asse di un pixel devono essere da 1 a 4.</translation>
    </message>
    <message>
        <source>The number of threads must not be negative; 0 means all.</source>
        <translation>Il numero di thread non può essere negativo; 0 significa tutti.</translation>
    </message>
    <message>
        <source>Not enough memory to draw this mesh as a volume. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per disegnare questa mesh come volume. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>The mesh has more than a billion tetrahedra, too many to be drawn at once. Lower its accuracy.</source>
        <translation>La mesh ha più di un miliardo di tetraedri, troppi per essere disegnati insieme. Ridurne l&apos;accuratezza.</translation>
    </message>
    <message>
        <source>The transfer function has more than 65,000 points. Leave some out.</source>
        <translation>La funzione di trasferimento ha più di 65 000 punti. Ometterne alcuni.</translation>
    </message>
    <message>
        <source>Preparing the volume</source>
        <translation>Preparazione del volume</translation>
    </message>
    <message>
        <source>Ordering the tetrahedra</source>
        <translation>Ordinamento dei tetraedri</translation>
    </message>
    <message>
        <source>A picture must have 1 to %1 samples per side. Draw a larger one in parts.</source>
        <translation>Un&apos;immagine deve avere da 1 a %1 campioni per lato. Disegnarne una più grande a parti.</translation>
    </message>
    <message>
        <source>The mesh, its transfer function and its order do not belong together.</source>
        <translation>La mesh, la sua funzione di trasferimento e il suo ordine non vanno insieme.</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be used: %2.</source>
        <translation>La preimpostazione «%1» non può essere usata: %2.</translation>
    </message>
    <message>
        <source>a value is not a finite number</source>
        <translation>un valore non è un numero finito</translation>
    </message>
    <message>
        <source>its values are not in ascending order: %1 comes after %2</source>
        <translation>i suoi valori non crescono: %1 viene dopo %2</translation>
    </message>
    <message>
        <source>it has neither colours nor opacities</source>
        <translation>non ha né colori né opacità</translation>
    </message>
    <message>
        <source>its colours follow the logarithm, and its values are not all positive</source>
        <translation>i suoi colori seguono il logaritmo, e non tutti i suoi valori sono positivi</translation>
    </message>
    <message>
        <source>a channel of a colour lies outside 0 to 1</source>
        <translation>un canale di un colore è fuori da 0 a 1</translation>
    </message>
    <message>
        <source>an opacity, a midpoint or a sharpness lies outside 0 to 1</source>
        <translation>un&apos;opacità, un punto medio o una nitidezza è fuori da 0 a 1</translation>
    </message>
    <message>
        <source>The ParaView preset cannot be read: %1 (%2).</source>
        <translation>La preimpostazione di ParaView non può essere letta: %1 (%2).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list of numbers, %2 for each point</source>
        <translation>«%1» deve essere un elenco di numeri, %2 per ogni punto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds something that is not a number</source>
        <translation>«%1» contiene qualcosa che non è un numero</translation>
    </message>
    <message>
        <source>the colour space &apos;%1&apos; is not known here; choose another one in ParaView&apos;s colour map editor</source>
        <translation>lo spazio di colore «%1» qui non è noto; sceglierne un altro nell&apos;editor delle mappe di colore di ParaView</translation>
    </message>
    <message>
        <source>a preset must be an object, in braces</source>
        <translation>una preimpostazione deve essere un oggetto, tra graffe</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has colours for categories and none for values in between</source>
        <translation>«%1» ha colori per categorie e nessuno per i valori intermedi</translation>
    </message>
    <message>
        <source>the list is empty</source>
        <translation>l&apos;elenco è vuoto</translation>
    </message>
    <message>
        <source>The ParaView preset cannot be read: %1.</source>
        <translation>La preimpostazione di ParaView non può essere letta: %1.</translation>
    </message>
    <message>
        <source>a point&apos;s attribute &apos;%1&apos; is &apos;%2&apos;, which is not a number</source>
        <translation>l&apos;attributo «%1» di un punto è «%2» e non un numero</translation>
    </message>
    <message>
        <source>the name of a colour map is not UTF-8</source>
        <translation>il nome di una mappa di colori non è UTF-8</translation>
    </message>
    <message>
        <source>the colour space &apos;%1&apos; of &apos;%2&apos; is not known here</source>
        <translation>lo spazio di colore «%1» di «%2» qui non è noto</translation>
    </message>
    <message>
        <source>the XML is damaged at byte %1: %2</source>
        <translation>l&apos;XML è danneggiato al byte %1: %2</translation>
    </message>
    <message>
        <source>there is no ColorMap element in it</source>
        <translation>non contiene un elemento ColorMap</translation>
    </message>
    <message>
        <source>The transfer function cannot be read. %1</source>
        <translation>La funzione di trasferimento non può essere letta. %1</translation>
    </message>
    <message>
        <source>has no finite value.</source>
        <translation>non ha un valore finito.</translation>
    </message>
    <message>
        <source>has a group outside 0 to 9.</source>
        <translation>ha un gruppo fuori da 0 a 9.</translation>
    </message>
    <message>
        <source>has a smaller value than the point before it. Put them in ascending order.</source>
        <translation>ha un valore minore del punto precedente. Metterli in ordine crescente.</translation>
    </message>
    <message>
        <source>is the third at its value. Two make a step; leave out those between.</source>
        <translation>è il terzo del suo valore. Due formano un gradino; omettere quelli in mezzo.</translation>
    </message>
    <message>
        <source>Colour %1 of the transfer function %2</source>
        <translation>Il colore %1 della funzione di trasferimento %2</translation>
    </message>
    <message>
        <source>has a channel outside 0 to 1.</source>
        <translation>ha un canale fuori da 0 a 1.</translation>
    </message>
    <message>
        <source>Opacity %1 of the transfer function %2</source>
        <translation>L&apos;opacità %1 della funzione di trasferimento %2</translation>
    </message>
    <message>
        <source>is outside 0 to 1.</source>
        <translation>è fuori da 0 a 1.</translation>
    </message>
    <message>
        <source>The mask of a transfer function must be a range of finite values.</source>
        <translation>La maschera di una funzione di trasferimento deve essere un intervallo di valori finiti.</translation>
    </message>
    <message>
        <source>The unit distance of a transfer function must be a length above zero.</source>
        <translation>La distanza unitaria di una funzione di trasferimento deve essere una lunghezza sopra zero.</translation>
    </message>
    <message>
        <source>%1 must be a number within range</source>
        <translation>%1 deve essere un numero adatto</translation>
    </message>
    <message>
        <source>%1 must be an object, in braces</source>
        <translation>%1 deve essere un oggetto, tra graffe</translation>
    </message>
    <message>
        <source>%1 has no &quot;%2&quot;</source>
        <translation>%1 non ha «%2»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known here</source>
        <translation>«%1» qui non è noto</translation>
    </message>
    <message>
        <source>a colour must be three numbers in brackets</source>
        <translation>un colore deve essere tre numeri tra parentesi quadre</translation>
    </message>
    <message>
        <source>a channel</source>
        <translation>un canale</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>un colore</translation>
    </message>
    <message>
        <source>an opacity</source>
        <translation>un&apos;opacità</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>un punto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be a list, in brackets</source>
        <translation>«%1» deve essere un elenco, tra parentesi quadre</translation>
    </message>
    <message>
        <source>a mask</source>
        <translation>una maschera</translation>
    </message>
    <message>
        <source>&quot;format&quot; is not &quot;%1&quot;</source>
        <translation>«format» non è «%1»</translation>
    </message>
    <message>
        <source>this program knows versions 1 to %1</source>
        <translation>questo programma conosce le versioni da 1 a %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>spento</translation>
    </message>
    <message>
        <source>translucent</source>
        <translation>traslucido</translation>
    </message>
    <message>
        <source>values</source>
        <translation>valori</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Shows where the mesh ends, holes and cavities included: &apos;translucent&apos; in a light colour, so that you can see inside, or in the colours that the transfer function gives the &apos;values&apos; there.</source>
        <translation>Mostra dove finisce la mesh, con fori e cavità: «traslucido» in un solo colore chiaro, così che si veda che cosa c&apos;è dentro le sue pareti, oppure con i colori che la funzione di trasferimento dà ai «valori» in quei punti.</translation>
    </message>
    <message>
        <source>The opacity of a translucent boundary; 1 hides what is behind it.</source>
        <translation>L&apos;opacità di un contorno traslucido; 1 nasconde ciò che sta dietro.</translation>
    </message>
    <message>
        <source>Back faces only</source>
        <translation>Solo facce posteriori</translation>
    </message>
    <message>
        <source>Shows only the far walls of the boundary, seen from inside, and leaves out those that face the camera.</source>
        <translation>Mostra solo le pareti lontane del contorno, dall&apos;interno, e tralascia quelle rivolte verso la camera.</translation>
    </message>
    <message>
        <source>Isovalues</source>
        <translation>Isovalori</translation>
    </message>
    <message>
        <source>The values whose surfaces are shown, each with its colour and opacity.</source>
        <translation>I valori di cui si mostrano le superfici, ciascuno con colore e opacità.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Funzione di trasferimento</translation>
    </message>
    <message>
        <source>The colour and the opacity of each value.</source>
        <translation>Il colore e l&apos;opacità di ogni valore.</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Ombreggiato</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation>Parallelepipedo limite</translation>
    </message>
    <message>
        <source>Draws the bounding box of the data.</source>
        <translation>Mostra gli spigoli del parallelepipedo che i dati riempiono.</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Piani di taglio</translation>
    </message>
    <message>
        <source>Clip planes as nx,ny,nz,offset; keeps the points with nx x + ny y + nz z &gt;= offset.</source>
        <translation>Taglia via ciò che sta davanti a un piano: nx,ny,nz,offset mostra i punti con nx x + ny y + nz z &gt;= offset.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>% of the value range</source>
        <translation>% dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Warping</source>
        <translation>Deformazione</translation>
    </message>
    <message>
        <source>% of the diagonal</source>
        <translation>% della diagonale</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesi</translation>
    </message>
    <message>
        <source>Where accuracy matters: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach or value:q,reach, several separated by &apos;;&apos;. Errors there count in full, and the weight falls linearly to a tenth (or to &apos;,floor&apos; at the end) at the distance &apos;reach&apos;; where several apply, the largest weight counts. Examples: &apos;point:16,16,8,10&apos;, &apos;value:120,15,0.05&apos;.</source>
        <translation>Dove conta l&apos;accuratezza: point:x,y,z,reach, box:x0,y0,z0,x1,y1,z1,reach o value:q,reach, più di uno separati da «;». Lì gli errori contano per intero e calano linearmente a un decimo (o a «,floor» alla fine) alla distanza «reach»; vale il peso maggiore. Esempi: «point:16,16,8,10», «value:120,15,0.05».</translation>
    </message>
    <message>
        <source>rounds</source>
        <translation>a turni</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordine</translation>
    </message>
    <message>
        <source>Which point is removed next: &apos;exact&apos; takes the one whose loss does the least harm, for the fewest points; &apos;paper&apos; estimates that by gradients and planes, as the paper did; &apos;rounds&apos; takes many points that are not neighbours at a time, so that a focus region needs the fewest additional points.</source>
        <translation>Quale punto togliere per primo: «esatto» quello la cui perdita fa meno danno, per il minor numero di punti; «articolo» lo stima con gradienti e piani, come faceva l&apos;articolo; «a turni» toglie molti punti per volta che non si toccano, così che una regione di focus richieda meno all&apos;intorno.</translation>
    </message>
    <message>
        <source>An irregular mesh: decimation keeps its shape and its cavities.</source>
        <translation>Una mesh irregolare: la decimazione ne conserva la forma e le cavità.</translation>
    </message>
    <message>
        <source>A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.</source>
        <translation>Un reticolo regolare: la decimazione richiede meno punti a pari accuratezza, ma più tempo e memoria.</translation>
    </message>
    <message>
        <source>Decimation stops at this error; 0 continues to the coarsest mesh.</source>
        <translation>La decimazione si ferma a questo errore; 0 prosegue fino alla mesh più grossolana.</translation>
    </message>
    <message>
        <source>Finest error</source>
        <translation>Errore più fine</translation>
    </message>
    <message>
        <source>Leaves meshes of smaller errors out of the model, to make it smaller; 0 keeps everything.</source>
        <translation>Tralascia dal modello le mesh con errori minori, così che sia più piccolo; 0 conserva tutto.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blocco</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>celle</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatico</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>The block size &apos;%1&apos; is not &quot;automatic&quot;, &quot;none&quot; or a number of cells of at least 1.</source>
        <translation>La dimensione «%1» dei blocchi non è né «automatico» né «nessuno» né un numero di celle da 1.</translation>
    </message>
    <message>
        <source>A regular lattice: refinement keeps the exact domain and is the fastest method.</source>
        <translation>Un reticolo regolare: il raffinamento conserva esattamente il dominio e richiede il tempo minore.</translation>
    </message>
    <message>
        <source>Scattered points: refinement fills their convex hull.</source>
        <translation>Punti sparsi: il raffinamento riempie il loro inviluppo convesso.</translation>
    </message>
    <message>
        <source>Refinement stops at this error; 0 keeps everything, so that any accuracy can be shown later.</source>
        <translation>Il raffinamento si ferma a questo errore; 0 conserva tutto, così che in seguito si possa mostrare ogni accuratezza.</translation>
    </message>
    <message>
        <source>The preset &apos;%1&apos; cannot be changed: %2. Check the permissions of its folder, and that there is space.</source>
        <translation>La preimpostazione «%1» non può essere modificata: %2. Controllare i permessi della cartella, e che ci sia spazio.</translation>
    </message>
    <message>
        <source>The axis of values stays linear: a logarithmic one has no place for zero and negative values, and the data or the points begin at %1. Move the points above zero, or choose data with positive values.</source>
        <translation>L&apos;asse dei valori resta lineare: uno logaritmico non ha posto per zero e meno, e i dati o i punti cominciano a %1. Spostare i punti sopra zero, o scegliere dati di valori positivi.</translation>
    </message>
    <message>
        <source>The clipboard holds no points of a transfer function. Copy some here or in another window. %1</source>
        <translation>Gli appunti non contengono punti di una funzione di trasferimento. Copiarne alcuni qui o in un&apos;altra finestra. %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a colour. Give #rrggbb in hexadecimal, or one of %2.</source>
        <translation>«%1» non è un colore. Indicare #rrggbb in esadecimale, o uno di %2.</translation>
    </message>
    <message>
        <source>It is written for plugin interface %1, and this program has %2. Install a newer version of TAn, or an older one of the plugin.</source>
        <translation>È scritto per l&apos;interfaccia dei plugin %1, e questo programma ha la %2. Installare una versione più recente di TAn, o una meno recente del plugin.</translation>
    </message>
    <message>
        <source>Its metadata call it a %1, but it implements %2 instead of %3. Ask the plugin&apos;s author for a fixed version.</source>
        <translation>I suoi metadati lo dicono un plugin di %1, ma implementa %2 invece di %3. Chiedere all&apos;autore del plugin una versione corretta.</translation>
    </message>
    <message>
        <source>It was built with Qt %1, and this program runs with Qt %2. Install a build of the plugin for this Qt.</source>
        <translation>È stato compilato con Qt %1, e questo programma usa Qt %2. Installare il plugin per questo Qt.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is an archive. Unpack it first, with &apos;%2&apos;, and open what is in it.</source>
        <translation>«%1» è compresso. Decomprimerlo prima con «%2» e aprire ciò che contiene.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has an unknown format. %2%3</source>
        <translation>«%1» ha un formato sconosciuto. %2%3</translation>
    </message>
    <message>
        <source>No reader is installed.</source>
        <translation>Nessun lettore è installato.</translation>
    </message>
    <message>
        <source>%1 (It was unpacked on its own. If it refers to other files, unpack it next to them: gunzip.)</source>
        <translation>%1 (È stato decompresso da solo. Se nomina altri file, decomprimerlo accanto ad essi: gunzip.)</translation>
    </message>
    <message>
        <source>reader &apos;%1&apos;</source>
        <translation>lettura «%1»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a TAn model, but a dataset is needed here: the file that the model was built from.</source>
        <translation>«%1» è un modello TAn, e qui si vuole un insieme di dati: il file da cui il modello è stato costruito.</translation>
    </message>
    <message>
        <source>No writer is installed.</source>
        <translation>Nessun plugin di scrittura è installato.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which is missing or cannot be used. Install it.</source>
        <translation>Richiede il plugin «%1», che manca o non è utilizzabile. Installarlo.</translation>
    </message>
    <message>
        <source>It needs the plugin &quot;%1&quot;, which cannot be used: %2</source>
        <translation>Richiede il plugin «%1», che non è utilizzabile: %2</translation>
    </message>
    <message>
        <source>Plugins depend on each other in a circle: %1. Remove one of them.</source>
        <translation>I plugin si richiedono in circolo: %1. Rimuoverne uno.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not exist, or its folder may not be entered. Check the name.</source>
        <translation>«%1» non esiste, o la sua cartella non è accessibile. Controllare il nome.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a folder. Choose a file inside it.</source>
        <translation>«%1» è una cartella. Scegliere un file al suo interno.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a device or a pipe. Give a file.</source>
        <translation>«%1» è un dispositivo o una pipe. Scegliere un file.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is empty. The copy may be incomplete: copy the file again.</source>
        <translation>«%1» è vuoto. La copia potrebbe essere incompleta: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>The library %1 is missing. %2</source>
        <translation>Manca la libreria %1. %2</translation>
    </message>
    <message>
        <source>Install the package that contains it (on Debian, &apos;%1&apos; names it), or remove the plugin.</source>
        <translation>Installare il pacchetto che la contiene (su Debian lo indica «%1»), o rimuovere il plugin.</translation>
    </message>
    <message>
        <source>It needs the function %1, which no library here provides: it was built for another version of TAn or of a library. %2</source>
        <translation>Richiede la funzione %1, che qui nessuna libreria ha: è stato compilato per un&apos;altra versione di TAn o di una libreria. %2</translation>
    </message>
    <message>
        <source>Rebuild it, or install the version for this program.</source>
        <translation>Ricompilarlo, o installare la versione per questo programma.</translation>
    </message>
    <message>
        <source>It could not be loaded: %1 %2</source>
        <translation>Non è stato possibile caricarlo: %1 %2</translation>
    </message>
    <message>
        <source>Install it again, or remove it.</source>
        <translation>Installarlo di nuovo, o rimuoverlo.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; does not accept &apos;%2&apos;: %3</source>
        <translation>«%1» non accetta «%2»: %3</translation>
    </message>
    <message>
        <source>%1
%2: %3</source>
        <translation>%1
%2: %3</translation>
    </message>
    <message>
        <source>No builder accepts &apos;%1&apos;.%2%3</source>
        <translation>Nessuna costruzione accetta «%1».%2%3</translation>
    </message>
    <message>
        <source>builder &apos;%1&apos;</source>
        <translation>costruzione «%1»</translation>
    </message>
    <message>
        <source>The output &apos;%1&apos; is the input &apos;%2&apos;. Give the output another name.</source>
        <translation>Il risultato «%1» è l&apos;origine «%2». Dare al risultato un altro nome.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; exists and has the same name as the dataset that the model was built from, so it is not overwritten. Give the output another name, or remove that file first.</source>
        <translation>«%1» esiste e si chiama come l&apos;insieme di dati da cui il modello è stato costruito, perciò non viene sovrascritto. Dare un altro nome al risultato, o rimuovere prima quel file.</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and damaged or cut short. The copy may be incomplete: copy the file again.</source>
        <translation>è compresso con gzip, e danneggiato o troncato. La copia potrebbe essere incompleta: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>there is not enough memory to unpack it.</source>
        <translation>la memoria non basta per decomprimerlo.</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and cannot be unpacked into &apos;%1&apos;: %2. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>è compresso con gzip, e non si può decomprimere in «%1»: %2. Liberare spazio là, impostare TMPDIR su una cartella che ne ha di più, o decomprimerlo a mano (gunzip).</translation>
    </message>
    <message>
        <source>Unpacking</source>
        <translation>Decompressione</translation>
    </message>
    <message>
        <source>it is compressed with gzip, and unpacks to more than %1, half of the space in &apos;%2&apos;. Free some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).</source>
        <translation>è compresso con gzip, e decompresso supera %1, metà dello spazio in «%2». Liberare spazio là, impostare TMPDIR su una cartella che ne ha di più, o decomprimerlo a mano (gunzip).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not fit &apos;%2&apos;: it takes %3.</source>
        <translation>«%1» non va bene per «%2»: ci si aspetta %3.</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un numero intero</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un testo</translation>
    </message>
    <message>
        <source>isovalues %1</source>
        <translation>isovalori %1</translation>
    </message>
    <message>
        <source>a transfer function as JSON</source>
        <translation>una funzione di trasferimento in JSON</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an isovalue. Give VALUE, VALUE:COLOUR or VALUE:COLOUR:OPACITY, the opacity above 0 and at most 1: 128:#ff8000:0.5</source>
        <translation>«%1» non è un isovalore. Indicare VALORE, VALORE:COLORE o VALORE:COLORE:OPACITÀ, l&apos;opacità sopra 0 e al massimo 1: 128:#ff8000:0.5</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>uno di %1</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 da %2 a %3</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, in %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a regular lattice</source>
        <translation>«%1» è un reticolo regolare</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a curvilinear grid</source>
        <translation>«%1» è una griglia curvilinea</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is an irregular mesh</source>
        <translation>«%1» è una mesh irregolare</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has scattered points</source>
        <translation>«%1» ha punti sparsi</translation>
    </message>
    <message>
        <source>The %1 has no parameter &apos;%2&apos;. %3</source>
        <translation>Il plugin di %1 non conosce il parametro «%2». %3</translation>
    </message>
    <message>
        <source>It has none.</source>
        <translation>Non ce ne sono.</translation>
    </message>
    <message>
        <source>Available: %1.</source>
        <translation>Disponibili: %1.</translation>
    </message>
    <message>
        <source>The parameter &apos;%1&apos; of the %2 takes %3.</source>
        <translation>Per il parametro «%1» di %2 ci si aspetta %3.</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is for %2 data only, and %3. Leave it out.</source>
        <translation>«%1» vale solo per questo tipo di dati: %2; ma %3. Ometterlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; applies only if &apos;%2&apos; is %3. Leave it out, or choose that.</source>
        <translation>«%1» serve solo se «%2» è %3. Ometterlo, o scegliere quello.</translation>
    </message>
    <message>
        <source>This machine does not have enough memory for &apos;%1&apos; here. Close other programs, or give it smaller data.</source>
        <translation>La memoria di questo computer qui non basta per «%1». Chiudere altri programmi, o dargli dati più piccoli.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed: %2. This is a fault of the plugin; tell its author.</source>
        <translation>Il plugin «%1» ha fallito: %2. È un errore del plugin; segnalarlo all&apos;autore.</translation>
    </message>
    <message>
        <source>It is not a plugin, or is damaged: %1 Install it again, or remove the file.</source>
        <translation>Non è un plugin, o è danneggiato: %1 Installarlo di nuovo, o rimuovere il file.</translation>
    </message>
    <message>
        <source>%1
The plugin %2 (%3) is not used. %4</source>
        <translation>%1
Il plugin %2 (%3) non è in uso. %4</translation>
    </message>
    <message>
        <source>Not all plugins can be loaded now: %1 %2</source>
        <translation>Ora non tutti i plugin si possono caricare: %1 %2</translation>
    </message>
    <message>
        <source>It is disabled by the settings or by %1.</source>
        <translation>È disattivato dalle impostazioni o da %1.</translation>
    </message>
    <message>
        <source>Another plugin has the same id and was found first: %1. Remove one of the two.</source>
        <translation>Un altro plugin ha lo stesso identificativo ed è stato trovato prima: %1. Rimuovere uno dei due.</translation>
    </message>
    <message>
        <source>The %1 &quot;%2&quot; cannot be used. %3</source>
        <translation>Il plugin di %1 «%2» non si può usare. %3</translation>
    </message>
    <message>
        <source>There is no %1 &quot;%2&quot;. %3</source>
        <translation>Un plugin di %1 «%2» non esiste. %3</translation>
    </message>
    <message>
        <source>None is installed.</source>
        <translation>Nessuno è installato.</translation>
    </message>
    <message>
        <source>The plugin &quot;%1&quot; cannot be used. %2</source>
        <translation>Il plugin «%1» non si può usare. %2</translation>
    </message>
    <message>
        <source>It failed to start: %1. Install it again.</source>
        <translation>È fallito all&apos;avvio: %1. Installarlo di nuovo.</translation>
    </message>
    <message>
        <source>Its metadata call it a %1, but it does not implement %2. Ask the plugin&apos;s author for a fixed version.</source>
        <translation>I suoi metadati lo dicono un plugin di %1, ma non implementa %2. Chiedere all&apos;autore del plugin una versione corretta.</translation>
    </message>
    <message>
        <source>builder</source>
        <translation>costruzione</translation>
    </message>
    <message>
        <source>renderer</source>
        <translation>resa</translation>
    </message>
    <message>
        <source>reader</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>writer</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>editor</source>
        <translation>editor</translation>
    </message>
    <message>
        <source>Its metadata are malformed: %1. Ask the plugin&apos;s author for a fixed version.</source>
        <translation>I suoi metadati non sono corretti: %1. Chiedere all&apos;autore del plugin una versione corretta.</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>manca la chiave «%1»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a string</source>
        <translation>«%1» non è un testo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is &quot;%2&quot;, which is not a version like &quot;1.2.3&quot;</source>
        <translation>«%1» è «%2», che non è una versione come «1.2.3»</translation>
    </message>
    <message>
        <source>&quot;requires&quot; is not a list</source>
        <translation>«requires» non è un elenco</translation>
    </message>
    <message>
        <source>&quot;requires&quot; lists something that is not the id of a plugin</source>
        <translation>«requires» elenca qualcosa che non è l&apos;identificativo di un plugin</translation>
    </message>
    <message>
        <source>&quot;id&quot; is &quot;%1&quot;; it may contain only lower-case letters, digits, &apos;.&apos;, &apos;-&apos; and &apos;_&apos;</source>
        <translation>«id» è «%1»; può contenere solo lettere minuscole, cifre, «.», «-» e «_»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a component of an array that has %2: give &apos;magnitude&apos;, or a number from 0 to %3.</source>
        <translation>«%1» non è una componente di un vettore che ne ha %2: indicare «magnitude», o un numero da 0 a %3.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. Available: %2.</source>
        <translation>non ha un vettore «%1». Ci sono: %2.</translation>
    </message>
    <message>
        <source>it changed while it was read. Read it again.</source>
        <translation>è cambiato durante la lettura. Leggerlo di nuovo.</translation>
    </message>
    <message>
        <source>Not enough memory to read &apos;%1&apos;. Close other programs.</source>
        <translation>La memoria non basta per leggere «%1». Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>VTK unstructured grid (*.vtu)</source>
        <translation>Griglia non strutturata VTK (*.vtu)</translation>
    </message>
    <message>
        <source>AVS UCD mesh (*.inp)</source>
        <translation>Mesh AVS UCD (*.inp)</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>Vettore</translation>
    </message>
    <message>
        <source>The array whose values to take, of points or of cells; by default the one the file calls active, else the first.</source>
        <translation>Il vettore di cui prendere i valori, di punti o di celle; se vuoto quello che il file dice attivo, altrimenti il primo.</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Componente</translation>
    </message>
    <message>
        <source>the first line is not five numbers: of points, of cells, of values per point, per cell and of the model</source>
        <translation>la prima riga non è di cinque numeri: punti, celle, valori per punto, per cella e del modello</translation>
    </message>
    <message>
        <source>it is too short for %1 points and %2 cells</source>
        <translation>è troppo corto per %1 punti e %2 celle</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punti</translation>
    </message>
    <message>
        <source>a point is not its number and three coordinates</source>
        <translation>un punto non è il suo numero e tre coordinate</translation>
    </message>
    <message>
        <source>the number of a point appears twice</source>
        <translation>il numero di un punto compare due volte</translation>
    </message>
    <message>
        <source>a cell is not its number, its material and its shape: pt, line, tri, quad, tet, pyr, prism or hex</source>
        <translation>una cella non è il suo numero, il materiale e la forma: pt, line, tri, quad, tet, pyr, prism o hex</translation>
    </message>
    <message>
        <source>the list of values is missing</source>
        <translation>manca l&apos;elenco dei valori</translation>
    </message>
    <message>
        <source>the line before the values does not hold their number and how many components each has</source>
        <translation>la riga prima dei valori non è il loro numero e quante componenti ha ciascuno</translation>
    </message>
    <message>
        <source>the components of the values do not add up to what the first line states</source>
        <translation>le componenti dei valori non danno in tutto ciò che dice la prima riga</translation>
    </message>
    <message>
        <source>the name of a value is missing</source>
        <translation>manca il nome di un valore</translation>
    </message>
    <message>
        <source>a value belongs to a number that no point or cell has</source>
        <translation>un valore appartiene a un numero che nessun punto o cella ha</translation>
    </message>
    <message>
        <source>a value is missing or not a number</source>
        <translation>un valore manca o non è un numero</translation>
    </message>
    <message>
        <source>the file ends early</source>
        <translation>il file finisce troppo presto</translation>
    </message>
    <message>
        <source>line %1: %2.</source>
        <translation>riga %1: %2.</translation>
    </message>
    <message>
        <source>the file ends after %1 of %2 %3</source>
        <translation>il file finisce dopo %1 di %2: %3</translation>
    </message>
    <message>
        <source>a corner of a cell is not the number of a point</source>
        <translation>un vertice di una cella non è il numero di un punto</translation>
    </message>
    <message>
        <source>a cell has more corners than its shape</source>
        <translation>una cella ha più vertici della sua forma</translation>
    </message>
    <message>
        <source>it is a binary UCD file, and only text is read. Write it as text, or as .vtu, for instance with ParaView.</source>
        <translation>è un file UCD binario, e si legge solo il testo. Scriverlo come testo o come .vtu, per esempio con ParaView.</translation>
    </message>
    <message>
        <source>is too short for %1 numbers, or cut short</source>
        <translation>è troppo corto per %1 numeri, o troncato</translation>
    </message>
    <message>
        <source>has %1 bytes, not the %2 of %3 numbers</source>
        <translation>ha %1 byte, non i %2 di %3 numeri</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>è danneggiato: non si può decomprimere</translation>
    </message>
    <message>
        <source>is too short for %1 numbers</source>
        <translation>è troppo corto per %1 numeri</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; among its numbers</source>
        <translation>ha «%1» fra i suoi numeri</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>ha più di %1 numeri</translation>
    </message>
    <message>
        <source>has %1 numbers, not %2</source>
        <translation>ha %1 numeri, non %2</translation>
    </message>
    <message>
        <source>is of type &apos;%1&apos;, which is not a number</source>
        <translation>è di tipo «%1», che non è un numero</translation>
    </message>
    <message>
        <source>has the unknown format &apos;%1&apos;</source>
        <translation>ha il formato sconosciuto «%1»</translation>
    </message>
    <message>
        <source>is of type &apos;%1&apos;, not of whole numbers</source>
        <translation>è di tipo «%1», non di numeri interi</translation>
    </message>
    <message>
        <source>a piece claims to have more points than possible.</source>
        <translation>un pezzo dichiara più punti di quanti possano essere.</translation>
    </message>
    <message>
        <source>its points do not have three coordinates each.</source>
        <translation>i suoi punti non hanno tre coordinate ciascuno.</translation>
    </message>
    <message>
        <source>not every piece has the array &apos;%1&apos;.</source>
        <translation>non ogni pezzo ha il vettore «%1».</translation>
    </message>
    <message>
        <source>a piece claims to have more values than possible.</source>
        <translation>un pezzo dichiara più valori di quanti possano essere.</translation>
    </message>
    <message>
        <source>the offsets of its cells do not rise.</source>
        <translation>gli inizi delle sue celle non crescono.</translation>
    </message>
    <message>
        <source>a cell has the corner %1 of %2 points.</source>
        <translation>una cella ha il vertice %1 di %2 punti.</translation>
    </message>
    <message>
        <source>it does not begin with &lt;VTKFile&gt;, so it is not a VTK XML file.</source>
        <translation>non comincia con &lt;VTKFile&gt;, perciò non è un file VTK XML.</translation>
    </message>
    <message>
        <source>its XML is damaged or cut short.</source>
        <translation>il suo XML è danneggiato o troncato.</translation>
    </message>
    <message>
        <source>it holds a %1, not an UnstructuredGrid. The VTK plugin reads those.</source>
        <translation>contiene un %1, non un UnstructuredGrid. Il plugin VTK li legge.</translation>
    </message>
    <message>
        <source>a piece does not say how many points and cells it has.</source>
        <translation>un pezzo non dice quanti punti e celle ha.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; has %2 components.</source>
        <translation>il vettore «%1» ha %2 componenti.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; does not say where it is.</source>
        <translation>il vettore «%1» non dice dove sta.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; does not end.</source>
        <translation>il vettore «%1» non finisce.</translation>
    </message>
    <message>
        <source>its appended data do not begin.</source>
        <translation>i suoi dati in coda non cominciano.</translation>
    </message>
    <message>
        <source>it has no piece with points and cells.</source>
        <translation>non ha un pezzo con punti e celle.</translation>
    </message>
    <message>
        <source>a piece has no array &apos;%1&apos;.</source>
        <translation>un pezzo non ha il vettore «%1».</translation>
    </message>
    <message>
        <source>A .vtu file holds a mesh of tetrahedra, and this dataset is not one. Write lattices as .nrrd, curvilinear grids as .xyz, points as .csv.</source>
        <translation>Un file .vtu contiene una mesh di tetraedri, e questo insieme di dati non lo è. Scrivere i reticoli come .nrrd, le griglie curvilinee come .xyz, i punti come .csv.</translation>
    </message>
    <message>
        <source>its compressed data are damaged (%1). Copy the file again.</source>
        <translation>i suoi dati compressi sono danneggiati (%1). Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>Not enough memory to unpack gzip data. Close other programs.</source>
        <translation>La memoria non basta per decomprimere dati gzip. Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>they are cut short</source>
        <translation>sono troncati</translation>
    </message>
    <message>
        <source>another part cannot be started</source>
        <translation>una nuova parte non può cominciare</translation>
    </message>
    <message>
        <source>its compressed data hold more than %1 bytes where the description requires %2. The sizes or the type are wrong, or the data belong to another file.</source>
        <translation>i suoi dati compressi contengono più di %1 byte dove la descrizione ne chiede %2. Le dimensioni o il tipo sono sbagliati, o i dati sono di un altro file.</translation>
    </message>
    <message>
        <source>its compressed data hold only %1 bytes where the description requires %2. The sizes or the type are wrong, or the data belong to another file.</source>
        <translation>i suoi dati compressi contengono solo %1 byte dove la descrizione ne chiede %2. Le dimensioni o il tipo sono sbagliati, o i dati sono di un altro file.</translation>
    </message>
    <message>
        <source>Not enough memory to compress the data. Close other programs.</source>
        <translation>La memoria non basta per comprimere i dati. Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>%1 The header &apos;%2&apos; names it as its data file.</source>
        <translation>%1 L&apos;intestazione «%2» lo nomina come suo file di dati.</translation>
    </message>
    <message>
        <source>it is empty. Get or make the file again.</source>
        <translation>è vuoto. Procurarsi o creare di nuovo il file.</translation>
    </message>
    <message>
        <source>NRRD volume (*.nrrd *.nhdr)</source>
        <translation>Volume NRRD (*.nrrd *.nhdr)</translation>
    </message>
    <message>
        <source>Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)</source>
        <translation>Volume raw (*.raw *.bin *.binary *.dat *.img *.vol)</translation>
    </message>
    <message>
        <source>must have one entry for each of the %1 axes.</source>
        <translation>deve avere una voce per ciascuno dei %1 assi.</translation>
    </message>
    <message>
        <source>its header has no field &apos;dimension&apos;.</source>
        <translation>la sua intestazione non ha il campo «dimension».</translation>
    </message>
    <message>
        <source>must be a number from 1 to 16.</source>
        <translation>deve essere un numero da 1 a 16.</translation>
    </message>
    <message>
        <source>its header has no field &apos;sizes&apos;.</source>
        <translation>la sua intestazione non ha il campo «sizes».</translation>
    </message>
    <message>
        <source>must be whole numbers from 1.</source>
        <translation>deve essere di numeri interi da 1.</translation>
    </message>
    <message>
        <source>must be numbers.</source>
        <translation>deve essere di numeri.</translation>
    </message>
    <message>
        <source>must be &apos;none&apos; or three numbers in parentheses for each axis.</source>
        <translation>deve essere «none» o tre numeri tra parentesi per ogni asse.</translation>
    </message>
    <message>
        <source>line %1 of its header %2</source>
        <translation>la riga %1 della sua intestazione %2</translation>
    </message>
    <message>
        <source>it is not an NRRD file: it does not begin with &apos;NRRD0001&apos; to &apos;NRRD0005&apos;.</source>
        <translation>non è un file NRRD: non comincia con «NRRD0001» fino a «NRRD0005».</translation>
    </message>
    <message>
        <source>it has the unknown NRRD version &apos;%1&apos;. Save it as NRRD0005 or earlier.</source>
        <translation>è di una versione NRRD non nota, «%1». Salvarlo come NRRD0005 o precedente.</translation>
    </message>
    <message>
        <source>is neither a field nor a comment: &apos;%1&apos;.</source>
        <translation>non è né un campo né un commento: «%1».</translation>
    </message>
    <message>
        <source>has the unknown field &apos;%1&apos;. Correct its name, or write &apos;:=&apos; for a note of your own.</source>
        <translation>ha il campo sconosciuto «%1». Correggere il nome, o scrivere «:=» per una nota propria.</translation>
    </message>
    <message>
        <source>gives &apos;%1&apos; a second time. Remove one of them.</source>
        <translation>indica «%1» una seconda volta. Rimuoverne uno.</translation>
    </message>
    <message>
        <source>its header does not end: there is no empty line in the first MiB.</source>
        <translation>la sua intestazione non finisce: nel primo MiB non c&apos;è una riga vuota.</translation>
    </message>
    <message>
        <source>it has %1 dimensions, %2 of them with more than one point. A volume has three: take out a part that has, such as one component or one time step.</source>
        <translation>ha %1 dimensioni, %2 delle quali con più di un punto. Un volume ne ha tre: estrarre una parte che le ha, come una componente o un passo temporale.</translation>
    </message>
    <message>
        <source>one of its axes, of size %1, holds &apos;%2&apos; instead of points. Take out one component first.</source>
        <translation>uno dei suoi assi, di dimensione %1, contiene «%2» invece di punti. Estrarre prima una componente.</translation>
    </message>
    <message>
        <source>its header gives the spacing of some axes only. Give all three, or none.</source>
        <translation>la sua intestazione dà la spaziatura solo di alcuni assi. Darle tutte e tre, o nessuna.</translation>
    </message>
    <message>
        <source>its space origin &apos;%1&apos; is not three numbers in parentheses.</source>
        <translation>il suo «space origin» «%1» non è di tre numeri tra parentesi.</translation>
    </message>
    <message>
        <source>its space directions are given for some axes only. Give them for all three, or for none.</source>
        <translation>le sue «space directions» sono date solo per alcuni assi. Darle per tutti e tre, o per nessuno.</translation>
    </message>
    <message>
        <source>its header has no field &apos;%1&apos;. Add it.</source>
        <translation>la sua intestazione non ha il campo «%1». Aggiungerlo.</translation>
    </message>
    <message>
        <source>its &apos;line skip&apos; must be a whole number of at least 0.</source>
        <translation>il suo «line skip» deve essere un numero intero da 0.</translation>
    </message>
    <message>
        <source>its &apos;byte skip&apos; must be a whole number of at least 0, or -1 for raw data at the end of the file.</source>
        <translation>il suo «byte skip» deve essere un numero intero da 0, o -1 per dati raw alla fine del file.</translation>
    </message>
    <message>
        <source>its data file is called &apos;%1&apos;, with characters that no name should contain. Correct it.</source>
        <translation>il suo file di dati si chiama «%1», con caratteri che nessun nome dovrebbe avere. Correggerlo.</translation>
    </message>
    <message>
        <source>its type is &apos;block&apos;, which does not describe the samples. Convert them to a number type first.</source>
        <translation>il suo tipo è «block», che non dice nulla dei campioni. Convertirli prima in un tipo numerico.</translation>
    </message>
    <message>
        <source>its byte order &apos;%1&apos; is not known. Use little or big.</source>
        <translation>il suo ordine dei byte «%1» non è noto. Ci sono little e big.</translation>
    </message>
    <message>
        <source>its encoding &apos;%1&apos; is not read. Save it with the encoding raw, gzip or ascii.</source>
        <translation>la sua codifica «%1» non si legge. Salvarlo con la codifica raw, gzip o ascii.</translation>
    </message>
    <message>
        <source>NRRD files are written with the encoding raw or gzip, not &apos;%1&apos;.</source>
        <translation>I file NRRD si scrivono con la codifica raw o gzip, non «%1».</translation>
    </message>
    <message>
        <source>NRRD files hold regular lattices, and &apos;%1&apos; is %2. Give the file another ending: .xyz for curvilinear grids, .csv for scattered points.</source>
        <translation>I file NRRD contengono reticoli regolari, e «%1» è %2. Dare al file un&apos;altra estensione: .xyz per griglie curvilinee, .csv per punti sparsi.</translation>
    </message>
    <message>
        <source>%1, or %2</source>
        <translation>%1, o %2</translation>
    </message>
    <message>
        <source>it is raw data, whose %1 bytes do not say how they are laid out. Describe them: size and type at least, for example %2.</source>
        <translation>contiene dati grezzi, i cui %1 byte non dicono come sono disposti. Descriverli: almeno dimensioni e tipo, per esempio %2.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensione</translation>
    </message>
    <message>
        <source>Raw files: the number of points along x (which runs fastest), y and z, as in 256x256x128.</source>
        <translation>File raw: il numero di punti lungo x (che varia più in fretta), y e z, come in 256x256x128.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Raw files: the type of a sample.</source>
        <translation>File raw: il tipo di un campione.</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Ordine dei byte</translation>
    </message>
    <message>
        <source>Raw files: little (PC) or big endian, for types of more than one byte.</source>
        <translation>File raw: little (PC) o big endian, per tipi di più di un byte.</translation>
    </message>
    <message>
        <source>little</source>
        <translation>little-endian (PC)</translation>
    </message>
    <message>
        <source>big</source>
        <translation>big-endian</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Salta</translation>
    </message>
    <message>
        <source>Raw files: the length of a header before the samples.</source>
        <translation>File raw: la lunghezza di un&apos;intestazione prima dei campioni.</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>byte</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Spaziatura</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>the number of bytes to skip cannot be negative.</source>
        <translation>il numero di byte da saltare non può essere negativo.</translation>
    </message>
    <message>
        <source>%1 x %2 x %3 samples of type %4, %5 bytes</source>
        <translation>%1 × %2 × %3 campioni di tipo %4, %5 byte</translation>
    </message>
    <message>
        <source>it should hold %1, but there are only %2. It is cut short, or its description (sizes, type, bytes to skip) is wrong.</source>
        <translation>dovrebbe contenere %1, ma ci sono solo %2. È troncato, o la descrizione (dimensioni, tipo, byte da saltare) è sbagliata.</translation>
    </message>
    <message>
        <source>it has only %1 of the %2 lines to be skipped. Check &apos;line skip&apos;.</source>
        <translation>ha solo %1 delle %2 righe da saltare. Controllare «line skip».</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 byte</translation>
    </message>
    <message>
        <source>it should hold %1, but there are %2, %3 too many. Its description is wrong: check the sizes, the type and the bytes to skip.</source>
        <translation>dovrebbe contenere %1, ma ci sono %2, %3 di troppo. La descrizione è sbagliata: controllare dimensioni, tipo e byte da saltare.</translation>
    </message>
    <message>
        <source>%1 bytes of compressed data</source>
        <translation>%1 byte di dati compressi</translation>
    </message>
    <message>
        <source>%1 bytes of text</source>
        <translation>%1 byte di testo</translation>
    </message>
    <message>
        <source>its text holds more than the %1 numbers that the description requires. Check the sizes.</source>
        <translation>il suo testo contiene più dei %1 numeri che la descrizione chiede. Controllare le dimensioni.</translation>
    </message>
    <message>
        <source>number %1 of its text, &apos;%2&apos;, is not a number of this type. Correct it, or the type.</source>
        <translation>il numero %1 del suo testo, «%2», non è un numero del tipo. Correggere quello, o il tipo.</translation>
    </message>
    <message>
        <source>its text holds only %1 numbers where the description requires %2. It is cut short, or the sizes are wrong.</source>
        <translation>il suo testo contiene solo %1 numeri dove la descrizione ne chiede %2. È troncato, o le dimensioni sono sbagliate.</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densità</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>pressione</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energia</translation>
    </message>
    <message>
        <source>velocity_magnitude</source>
        <translation>modulo della velocità</translation>
    </message>
    <message>
        <source>momentum_magnitude</source>
        <translation>modulo della quantità di moto</translation>
    </message>
    <message>
        <source>momentum_x</source>
        <translation>quantità di moto lungo x</translation>
    </message>
    <message>
        <source>momentum_y</source>
        <translation>quantità di moto lungo y</translation>
    </message>
    <message>
        <source>momentum_z</source>
        <translation>quantità di moto lungo z</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>temperatura</translation>
    </message>
    <message>
        <source>mach</source>
        <translation>numero di Mach</translation>
    </message>
    <message>
        <source>No array of this solution varies.</source>
        <translation>Nessuna grandezza di questa soluzione varia.</translation>
    </message>
    <message>
        <source>Available arrays: %1.</source>
        <translation>Si possono prendere: %1.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; has the same value everywhere. %2</source>
        <translation>il vettore «%1» ha lo stesso valore ovunque. %2</translation>
    </message>
    <message>
        <source>none of its arrays varies, so there is nothing to see.</source>
        <translation>nessuno dei suoi vettori varia, perciò non c&apos;è nulla da vedere.</translation>
    </message>
    <message>
        <source>the lengths of its Fortran records do not fit the sizes of its grids. Copy the file again.</source>
        <translation>le lunghezze dei suoi record Fortran non corrispondono alle dimensioni delle griglie. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>%1 bytes too many follow its data. Check that it is a PLOT3D file.</source>
        <translation>%1 byte di troppo stanno dopo i suoi dati. Controllare che sia un file PLOT3D.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no grid %2: it holds %3.</source>
        <translation>«%1» non ha la griglia %2: ne contiene %3.</translation>
    </message>
    <message>
        <source>its grid has %1 x %2 x %3 points. TAn takes volumes: at least two points along each of three axes.</source>
        <translation>la sua griglia ha %1 x %2 x %3 punti. TAn accetta volumi: almeno due punti lungo ciascuno dei tre assi.</translation>
    </message>
    <message>
        <source>it holds a two-dimensional grid. TAn takes volumes: grids with at least two points along each of three axes.</source>
        <translation>contiene una griglia bidimensionale. TAn accetta volumi: griglie con almeno due punti lungo ciascuno dei tre assi.</translation>
    </message>
    <message>
        <source>it begins like a grid of %1 points, which takes %2 bytes or more, and has %3</source>
        <translation>comincia come una griglia di %1 punti, che occupa %2 byte o più, e ne ha %3</translation>
    </message>
    <message>
        <source>%1: it is cut short. Copy the file again.</source>
        <translation>%1: è troncato. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>%1, which fits no kind of PLOT3D file.</source>
        <translation>%1, e ciò non corrisponde a nessun tipo di file PLOT3D.</translation>
    </message>
    <message>
        <source>it is a PLOT3D solution, and its grid is not next to it (%1). Open the grid, and give it the solution.</source>
        <translation>è una soluzione PLOT3D, e la sua griglia non è accanto (%1). Aprire la griglia, e darle la soluzione.</translation>
    </message>
    <message>
        <source>it is a grid without values, and no solution is next to it (%1). Say where it is with &apos;solution&apos;, or give it one of these names.</source>
        <translation>è una griglia senza valori, e nessuna soluzione è accanto (%1). Dire dov&apos;è con «solution», o darle uno di questi nomi.</translation>
    </message>
    <message>
        <source>it is the solution of another grid: its sizes differ from those of &apos;%1&apos;. Choose another one with &apos;solution&apos;.</source>
        <translation>è la soluzione di un&apos;altra griglia: le sue dimensioni non sono quelle di «%1». Sceglierne un&apos;altra con «solution».</translation>
    </message>
    <message>
        <source>PLOT3D grid and solution (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</source>
        <translation>Griglia e soluzione PLOT3D (*.xyz *.x *.g *.grd *.p3d *.q *xyz.bin *q.bin)</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>Which scalar of the solution: automatic takes the density, or, if that is the same everywhere, the first that varies.</source>
        <translation>Quale scalare della soluzione: «automatico» prende la densità o, se questa è ovunque uguale, il primo che varia.</translation>
    </message>
    <message>
        <source>Solution file</source>
        <translation>File di soluzione</translation>
    </message>
    <message>
        <source>The PLOT3D solution of the grid; by default the one next to it with a matching name.</source>
        <translation>La soluzione PLOT3D della griglia; altrimenti quella accanto con un nome corrispondente.</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Griglia</translation>
    </message>
    <message>
        <source>PLOT3D files hold points on a grid, and &apos;%1&apos; is not. Give the file another ending, such as .csv for scattered points.</source>
        <translation>I file PLOT3D contengono punti su una griglia, e «%1» no. Dare al file un&apos;altra estensione, come .csv per punti sparsi.</translation>
    </message>
    <message>
        <source>there is no column &apos;%1&apos;; there are %2, or give a number from 1 to %3.</source>
        <translation>non c&apos;è una colonna «%1»; ci sono %2, o indicare un numero da 1 a %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not name the three columns of the positions. Give three names or numbers separated by commas, as in x,y,z or 1,2,3.</source>
        <translation>«%1» non nomina le tre colonne delle posizioni. Indicare tre nomi o numeri separati da virgole, come in x,y,z o 1,2,3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names the same column twice.</source>
        <translation>«%1» nomina due volte la stessa colonna.</translation>
    </message>
    <message>
        <source>it has %1 columns, and points need at least four: x, y, z and a value.</source>
        <translation>ha %1 colonne, e i punti ne richiedono almeno quattro: x, y, z e un valore.</translation>
    </message>
    <message>
        <source>1 incomplete row was skipped.</source>
        <translation>1 riga incompleta è stata saltata.</translation>
    </message>
    <message>
        <source>%1 incomplete rows were skipped.</source>
        <translation>%1 righe incomplete sono state saltate.</translation>
    </message>
    <message>
        <source>Table of points (*.csv *.tsv *.xyz *.pts *.txt *.asc)</source>
        <translation>Tabella di punti (*.csv *.tsv *.xyz *.pts *.txt *.asc)</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posizioni</translation>
    </message>
    <message>
        <source>The values to take, by name or number; &apos;automatic&apos; takes the first.</source>
        <translation>I valori da prendere, per nome o numero; «automatic» prende i primi che ci sono.</translation>
    </message>
    <message>
        <source>Skip incomplete rows</source>
        <translation>Salta le righe incomplete</translation>
    </message>
    <message>
        <source>Tables of points: leave out rows with a missing number, instead of refusing the file.</source>
        <translation>Tabelle di punti: tralascia le righe a cui manca un numero, invece di rifiutare il file.</translation>
    </message>
    <message>
        <source>it has more than 4294967295 points. Take a part of them.</source>
        <translation>ha più di 4294967295 punti. Prenderne una parte.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>riga %1</translation>
    </message>
    <message>
        <source>%1 has a double quote that is not closed.</source>
        <translation>%1 ha virgolette non chiuse.</translation>
    </message>
    <message>
        <source>it holds no points.</source>
        <translation>non contiene punti.</translation>
    </message>
    <message>
        <source>%1, %2: a number is missing. Add it, or have incomplete rows skipped.</source>
        <translation>%1, %2: non c&apos;è un numero. Aggiungerlo, o far saltare le righe incomplete.</translation>
    </message>
    <message>
        <source>%1, %2: %3 is not a number. Numbers need a decimal point.</source>
        <translation>%1, %2: %3 non è un numero. I numeri richiedono il punto decimale.</translation>
    </message>
    <message>
        <source>%1, %2: %3 is not a finite number.</source>
        <translation>%1, %2: %3 non è un numero finito.</translation>
    </message>
    <message>
        <source>%1 has %2 columns, and the lines before have %3.</source>
        <translation>la %1 ha %2 colonne, e quelle prima ne hanno %3.</translation>
    </message>
    <message>
        <source>%1, %2: %3 is too large for a position.</source>
        <translation>%1, %2: %3 è troppo grande per una posizione.</translation>
    </message>
    <message>
        <source>it is in UTF-16. Save it as UTF-8.</source>
        <translation>è in UTF-16. Salvarlo come UTF-8.</translation>
    </message>
    <message>
        <source>it is not text.</source>
        <translation>non è un testo.</translation>
    </message>
    <message>
        <source>it is a chemical structure: elements and the positions of their atoms. A table of points is needed, with a value for each x, y and z.</source>
        <translation>è una struttura chimica: elementi e dove stanno i loro atomi. Si vuole una tabella di punti, con un valore per ogni x, y e z.</translation>
    </message>
    <message>
        <source>%1 The file is damaged: copy or export it again.</source>
        <translation>%1 Il file è danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has %1 bytes of pixels of %2 (of %3 in all). It is damaged: copy the file again.</source>
        <translation>ha %1 byte di pixel su %2 (su %3 in tutto). È danneggiato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it ends too early. Copy the file again.</source>
        <translation>finisce troppo presto. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>ends in line %1, before the last %2. It is cut short: copy the file again.</source>
        <translation>finisce alla riga %1, prima che ci sia tutto (%2). È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; %2</source>
        <translation>il suo file «%1» %2</translation>
    </message>
    <message>
        <source>line &apos;FORMAT&apos;</source>
        <translation>riga «FORMAT»</translation>
    </message>
    <message>
        <source>does not begin with FORMAT. It is damaged, or not an EnSight case.</source>
        <translation>non comincia con FORMAT. Non è un caso EnSight, o è danneggiato.</translation>
    </message>
    <message>
        <source>line &apos;type:&apos;</source>
        <translation>riga «type:»</translation>
    </message>
    <message>
        <source>has a section &apos;%1&apos;, which VTK cannot skip. Remove it, or put it after the variables.</source>
        <translation>ha una sezione «%1», che VTK non sa saltare. Toglierla, o metterla dopo le variabili.</translation>
    </message>
    <message>
        <source>names no geometry (&apos;model:&apos;). It is cut short or damaged.</source>
        <translation>non nomina una geometria («model:»). È troncato o danneggiato.</translation>
    </message>
    <message>
        <source>number of a time set</source>
        <translation>numero di un insieme di tempi</translation>
    </message>
    <message>
        <source>line &apos;number of steps:&apos;</source>
        <translation>riga «number of steps:»</translation>
    </message>
    <message>
        <source>number of time steps</source>
        <translation>numero di passi temporali</translation>
    </message>
    <message>
        <source>states that there are %1 time steps.</source>
        <translation>dichiara %1 passi temporali.</translation>
    </message>
    <message>
        <source>line &apos;time values:&apos;</source>
        <translation>riga «time values:»</translation>
    </message>
    <message>
        <source>first number of its files</source>
        <translation>primo numero dei suoi file</translation>
    </message>
    <message>
        <source>line &apos;filename increment:&apos;</source>
        <translation>riga «filename increment:»</translation>
    </message>
    <message>
        <source>increment of its files&apos; numbers</source>
        <translation>incremento dei numeri dei suoi file</translation>
    </message>
    <message>
        <source>has %1 of %2 time values. It is cut short or damaged.</source>
        <translation>ha %1 di %2 valori di tempo. È troncato o danneggiato.</translation>
    </message>
    <message>
        <source>number of a file set</source>
        <translation>numero di un insieme di file</translation>
    </message>
    <message>
        <source>number of time steps in a file</source>
        <translation>numero di passi temporali in un file</translation>
    </message>
    <message>
        <source>number of a file</source>
        <translation>numero di un file</translation>
    </message>
    <message>
        <source>time step</source>
        <translation>passo temporale</translation>
    </message>
    <message>
        <source>line of its description</source>
        <translation>riga della sua descrizione</translation>
    </message>
    <message>
        <source>line &apos;node id&apos;</source>
        <translation>riga «node id»</translation>
    </message>
    <message>
        <source>line &apos;element id&apos;</source>
        <translation>riga «element id»</translation>
    </message>
    <message>
        <source>part</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>line &apos;particle coordinates&apos;</source>
        <translation>riga «particle coordinates»</translation>
    </message>
    <message>
        <source>number of points</source>
        <translation>numero di punti</translation>
    </message>
    <message>
        <source>does not state how many measured points it has. It is damaged.</source>
        <translation>non dice quanti punti misurati ha. È danneggiato.</translation>
    </message>
    <message>
        <source>measured point</source>
        <translation>punto misurato</translation>
    </message>
    <message>
        <source>has no point in the line &apos;%1&apos;. It is cut short or damaged.</source>
        <translation>non ha un punto nella riga «%1». È troncato o danneggiato.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posizione</translation>
    </message>
    <message>
        <source>line &apos;coordinates&apos;</source>
        <translation>riga «coordinates»</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; where a part should begin; VTK skips this and all that follows. It is damaged, or of another version of the format: export it again.</source>
        <translation>ha «%1» dove dovrebbe cominciare una parte, cosa che VTK salta con tutto il seguito. È danneggiato, o di un&apos;altra versione del formato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>size of a block</source>
        <translation>dimensioni di un blocco</translation>
    </message>
    <message>
        <source>has a block of the size &apos;%1&apos;. It is damaged.</source>
        <translation>ha un blocco di dimensioni «%1». È danneggiato.</translation>
    </message>
    <message>
        <source>coordinate of a block</source>
        <translation>coordinata di un blocco</translation>
    </message>
    <message>
        <source>origin or spacing of a block</source>
        <translation>origine o spaziatura di un blocco</translation>
    </message>
    <message>
        <source>mark of a blanked point</source>
        <translation>segno di un punto escluso</translation>
    </message>
    <message>
        <source>number of a part</source>
        <translation>numero di una parte</translation>
    </message>
    <message>
        <source>name of a part</source>
        <translation>nome di una parte</translation>
    </message>
    <message>
        <source>kind of a part</source>
        <translation>tipo di una parte</translation>
    </message>
    <message>
        <source>element</source>
        <translation>elemento</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; where elements should begin. It is damaged, or of another version of the format: export it again.</source>
        <translation>ha «%1» dove dovrebbero cominciare gli elementi. È danneggiato, o di un&apos;altra versione del formato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>number of elements</source>
        <translation>numero di elementi</translation>
    </message>
    <message>
        <source>number of faces</source>
        <translation>numero di facce</translation>
    </message>
    <message>
        <source>number of corners</source>
        <translation>numero di vertici</translation>
    </message>
    <message>
        <source>has &apos;%1&apos; where elements should begin, which VTK does not recognise. It is damaged, or of another version of the format: export it again.</source>
        <translation>ha «%1» dove dovrebbero cominciare gli elementi, che VTK non conosce. È danneggiato, o di un&apos;altra versione del formato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>has an element with too few corners: &apos;%1&apos;. It is cut short or damaged.</source>
        <translation>ha un elemento con troppo pochi vertici: «%1». È troncato o danneggiato.</translation>
    </message>
    <message>
        <source>has values of part &apos;%1&apos;, which the geometry does not have. One of the two is cut short, or they do not belong together.</source>
        <translation>ha valori della parte «%1», che la geometria non ha. Uno dei due è troncato, o non vanno insieme.</translation>
    </message>
    <message>
        <source>has values of &apos;%1&apos;, which the part does not have. It is damaged, or does not belong to the geometry.</source>
        <translation>ha valori di «%1», che la parte non ha. È danneggiato, o non appartiene alla geometria.</translation>
    </message>
    <message>
        <source>has no values of the elements &apos;%1&apos; of a part. It is cut short, or incomplete: export it again.</source>
        <translation>non ha valori degli elementi «%1» di una parte. È troncato, o incompleto: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>has vectors of a block in the text format of EnSight 6, which VTK reads wrongly. Write the case as EnSight Gold, or the data as .vts.</source>
        <translation>ha vettori di un blocco nel formato di testo di EnSight 6, che VTK legge male. Scrivere il caso come EnSight Gold, o i dati come .vts.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; is missing. Copy it into the same folder: they belong together.</source>
        <translation>il suo file «%1» manca. Copiarlo nella cartella di questo: vanno insieme.</translation>
    </message>
    <message>
        <source>%1 ends within a section. It is cut short: copy the file again.</source>
        <translation>%1 finisce dentro una sezione. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its file %1, which holds the values, is missing. Copy it into the same folder.</source>
        <translation>il suo file %1, che contiene i valori, manca. Copiarlo nella cartella di questo.</translation>
    </message>
    <message>
        <source>%1 has no section. It is cut short, or of another format.</source>
        <translation>%1 non ha una sezione. È troncato, o di un altro formato.</translation>
    </message>
    <message>
        <source>it</source>
        <translation>il file</translation>
    </message>
    <message>
        <source>its file %1</source>
        <translation>il suo file %1</translation>
    </message>
    <message>
        <source>it is an HDF4 file, which is not read. Convert it to .vti or .vtu, for instance with h4toh5 and ParaView.</source>
        <translation>è un file HDF4, che non si legge. Convertirlo, per esempio con h4toh5 e ParaView, in .vti o .vtu.</translation>
    </message>
    <message>
        <source>it does not begin like an HDF5 file. It is damaged, or of another format.</source>
        <translation>non comincia come i file HDF5. È danneggiato, o di un altro formato.</translation>
    </message>
    <message>
        <source>it is an HDF5 file of another program: it does not have the group VTKHDF, by which VTK recognises its own. Write it as .vti or .vtu.</source>
        <translation>è un file HDF5 di un altro programma: non ha il gruppo VTKHDF, da cui VTK riconosce i suoi. Scriverlo come .vti o .vtu.</translation>
    </message>
    <message>
        <source>it is a VTK HDF file with several time steps, which VTK 9.1 does not read. Write one time step as .vti or .vtu.</source>
        <translation>è un file VTK HDF di più passi temporali, un tipo venuto dopo VTK 9.1. Scrivere un passo temporale come .vti o .vtu.</translation>
    </message>
    <message>
        <source>it is a VTK HDF file of the type %1, which VTK 9.1 does not read. Write it as .vti or .vtu.</source>
        <translation>è un file VTK HDF di tipo %1, venuto dopo VTK 9.1. Scriverlo come .vti o .vtu.</translation>
    </message>
    <message>
        <source>it holds &apos;%1&apos;: values alone, without the points or the grid that they belong to. Write them with their grid.</source>
        <translation>contiene «%1»: solo valori, senza punti o una griglia a cui appartengano. Scriverli con la loro griglia.</translation>
    </message>
    <message>
        <source>it has &apos;%1&apos; where DATASET and a type such as STRUCTURED_POINTS or UNSTRUCTURED_GRID should be. It is damaged, or was written by a faulty program.</source>
        <translation>dice «%1» dove dovrebbe stare DATASET e un tipo come STRUCTURED_POINTS o UNSTRUCTURED_GRID. È danneggiato, o scritto da un programma difettoso.</translation>
    </message>
    <message>
        <source>The file ends without an end of line: if it was cut short there, its last number is wrong.</source>
        <translation>Il file finisce senza fine riga: se è stato troncato lì, il suo ultimo numero è sbagliato.</translation>
    </message>
    <message>
        <source>its header does not state its ElementType. It is cut short: copy the file again.</source>
        <translation>la sua intestazione non dice l&apos;ElementType. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its samples are of the type &apos;%1&apos;, which is not read. Write them as MET_INT, MET_FLOAT or MET_DOUBLE.</source>
        <translation>i suoi campioni sono di tipo «%1», che non si legge. Scriverli come MET_INT, MET_FLOAT o MET_DOUBLE.</translation>
    </message>
    <message>
        <source>its header has no NDims.</source>
        <translation>la sua intestazione non ha NDims.</translation>
    </message>
    <message>
        <source>its DimSize is &apos;%1&apos; and not %2 numbers of points.</source>
        <translation>il suo DimSize è «%1» e non %2 numeri di punti.</translation>
    </message>
    <message>
        <source>its ElementNumberOfChannels is &apos;%1&apos;.</source>
        <translation>il suo ElementNumberOfChannels è «%1».</translation>
    </message>
    <message>
        <source>its HeaderSize is &apos;%1&apos;.</source>
        <translation>il suo HeaderSize è «%1».</translation>
    </message>
    <message>
        <source>its HeaderSize is -1, which has no meaning where samples are packed or text.</source>
        <translation>il suo HeaderSize è -1, che non dice nulla dove i campioni sono compressi o un testo.</translation>
    </message>
    <message>
        <source>its header has no line &apos;ElementDataFile = ...&apos;: it is cut short or not a MetaImage. Copy the file again.</source>
        <translation>la sua intestazione non ha la riga «ElementDataFile = ...», perciò è troncato o non è un MetaImage. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its data file %1 is missing. Copy it into the same folder: the two belong together.</source>
        <translation>il suo file di dati %1 manca. Copiarlo nella cartella di questo: i due vanno insieme.</translation>
    </message>
    <message>
        <source>it should name %1 data files, each on a line of its own, and names %2. It is cut short: copy the file again.</source>
        <translation>dovrebbe nominare %1 file di dati, ciascuno in una riga propria che finisce, e ne nomina %2. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its ElementDataFile is &apos;%1&apos;.</source>
        <translation>il suo ElementDataFile è «%1».</translation>
    </message>
    <message>
        <source>its ElementDataFile &apos;%1&apos; does not name a file for each of its %2 layers. Write the numbers of the first, the last and the step after the name.</source>
        <translation>il suo ElementDataFile «%1» non nomina un file per ciascuno dei suoi %2 strati. Scrivere dopo il nome i numeri del primo, dell&apos;ultimo e il passo.</translation>
    </message>
    <message>
        <source>its ElementDataFile &apos;%1&apos; is not a name with a number such as &apos;%03d&apos;.</source>
        <translation>il suo ElementDataFile «%1» non è un nome con un numero come «%03d».</translation>
    </message>
    <message>
        <source>it ends within its header. It is cut short: copy the file again.</source>
        <translation>finisce dentro la sua intestazione. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>its NetCDF header has lists that are longer than the file, or lacks required ones.</source>
        <translation>la sua intestazione NetCDF ha elenchi più lunghi del file, o nessuno dove ne occorrono.</translation>
    </message>
    <message>
        <source>its dimension &apos;%1&apos; is %2 long, more than the file has bytes.</source>
        <translation>la sua dimensione «%1» è lunga %2, più dei byte del file.</translation>
    </message>
    <message>
        <source>its NetCDF header has an attribute of unknown type.</source>
        <translation>un attributo nella sua intestazione NetCDF è di un tipo che non esiste.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; has dimensions that do not exist.</source>
        <translation>la sua variabile «%1» ha dimensioni che non ci sono.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; is of unknown type.</source>
        <translation>la sua variabile «%1» è di un tipo che non esiste.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its variable &apos;%2&apos; is larger than any file. It is cut short, or was not written completely: copy the file again, or export it again.</source>
        <translation>ha %1 byte, e la sua variabile «%2» è più grande di qualsiasi file. È troncato, o non è stato scritto fino alla fine: copiare di nuovo il file, o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and its variable &apos;%2&apos; extends to byte %3. It is cut short, or was not written completely: copy the file again, or export it again.</source>
        <translation>ha %1 byte, e la sua variabile «%2» arriva al byte %3. È troncato, o non è stato scritto fino in fondo: copiare di nuovo il file, o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; begins within the header.</source>
        <translation>la sua variabile «%1» comincia dentro l&apos;intestazione.</translation>
    </message>
    <message>
        <source>page %1</source>
        <translation>la pagina %1</translation>
    </message>
    <message>
        <source>%1 lies beyond its end, at %2 bytes. It is cut short: copy the file again.</source>
        <translation>%1 sta oltre la sua fine, a %2 byte. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>%1 has no size.</source>
        <translation>%1 non ha dimensioni.</translation>
    </message>
    <message>
        <source>a piece of %1 has %2 bytes and should have %3.</source>
        <translation>un pezzo (%1) ha %2 byte e dovrebbe averne %3.</translation>
    </message>
    <message>
        <source>a piece of %1</source>
        <translation>un pezzo (%1)</translation>
    </message>
    <message>
        <source>%1 It is damaged, or was written by a faulty program: export it again.</source>
        <translation>%1 È danneggiato, o scritto da un programma difettoso: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it ends within its appended data. It is cut short: copy the file again.</source>
        <translation>finisce dentro i dati in coda. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it is a list of files, one for each time step or part. Open one of its files.</source>
        <translation>è un elenco di file, uno per ogni passo temporale o parte. Aprire uno dei suoi file.</translation>
    </message>
    <message>
        <source>it is a list of files, one for each time step or part. Open one of its files, such as &apos;%1&apos;.</source>
        <translation>è un elenco di file, uno per ogni passo temporale o parte. Aprirne uno, per esempio «%1».</translation>
    </message>
    <message>
        <source>its element %1 is missing.</source>
        <translation>manca il suo elemento %1.</translation>
    </message>
    <message>
        <source>the pieces in it do not fill the WholeExtent that it names.</source>
        <translation>i pezzi in esso non riempiono il WholeExtent che indica.</translation>
    </message>
    <message>
        <source>it has more than %1 elements.</source>
        <translation>ha più di %1 elementi.</translation>
    </message>
    <message>
        <source>its elements are nested more than %1 levels deep.</source>
        <translation>i suoi elementi sono annidati più di %1 volte.</translation>
    </message>
    <message>
        <source>an element has more than %1 attributes.</source>
        <translation>un elemento ha più di %1 attributi.</translation>
    </message>
    <message>
        <source>its %1 is &apos;%2&apos; and not three numbers.</source>
        <translation>il suo %1 è «%2» e non tre numeri.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has &apos;%2&apos; components.</source>
        <translation>il suo vettore «%1» ha «%2» componenti.</translation>
    </message>
    <message>
        <source>it claims to have %1 points or cells, more than %2 bytes can hold.</source>
        <translation>dichiara %1 punti o celle, più di quanti %2 byte possano contenere.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos;: %2</source>
        <translation>il suo file «%1»: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; (of cells)</source>
        <translation>«%1» (di celle)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Its 64-bit integers were converted to floating-point numbers, which are exact to 53 bits.</source>
        <translation>I suoi interi a 64 bit sono diventati numeri in virgola mobile a 53 bit.</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. Choose one of these: %2.</source>
        <translation>non ha un vettore «%1». Sceglierne uno fra questi: %2.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has no component &apos;%2&apos;. Choose one from 0 to %3, or &apos;magnitude&apos;.</source>
        <translation>il suo vettore «%1» non ha la componente «%2». Sceglierne una da 0 a %3, o «magnitude».</translation>
    </message>
    <message>
        <source>it has cells of a shape that TAn does not support: %1. Divide them into simpler ones.</source>
        <translation>ha celle di una forma che TAn non conosce: %1. Dividerle in altre più semplici.</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numero %1</translation>
    </message>
    <message>
        <source>the lists of its cells&apos; corners contradict each other. It is damaged.</source>
        <translation>gli elenchi dei vertici delle sue celle si contraddicono. È danneggiato.</translation>
    </message>
    <message>
        <source>cell %1 (from 0) has the corner %2, and there are %3 points. It is damaged.</source>
        <translation>la cella %1 (da 0) ha il vertice %2, e ci sono %3 punti. È danneggiato.</translation>
    </message>
    <message>
        <source>1 cell is declared linear and has the corners of a quadratic one: it was read as such.</source>
        <translation>1 cella è detta lineare e ha i vertici di una quadratica: è stata presa come tale.</translation>
    </message>
    <message>
        <source>%1 cells are declared linear and have the corners of quadratic ones: they were read as such.</source>
        <translation>%1 celle sono dette lineari e hanno i vertici di quadratiche: sono state prese come tali.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has values for its polygons, not its points. Choose an array of points.</source>
        <translation>il suo vettore «%1» ha valori per i poligoni, non per i punti. Scegliere un vettore di punti.</translation>
    </message>
    <message>
        <source>The lines and polygons that join its points were left out: they are scattered points.</source>
        <translation>Ciò che unisce i suoi punti (linee, poligoni) è stato omesso: sono punti sparsi.</translation>
    </message>
    <message>
        <source>The values of the cells were transferred to the points, as the mean of the cells around each.</source>
        <translation>I valori delle celle sono stati portati ai punti, come media delle celle attorno.</translation>
    </message>
    <message>
        <source>it has no part &apos;%1&apos;. %2</source>
        <translation>non ha una parte «%1». %2</translation>
    </message>
    <message>
        <source>It has only one: leave &apos;part&apos; empty.</source>
        <translation>È tutto uno: lasciare «part» vuoto.</translation>
    </message>
    <message>
        <source>VTK says: %1</source>
        <translation>VTK dice: %1</translation>
    </message>
    <message>
        <source>it claims to hold more than any machine can. It is damaged.</source>
        <translation>dichiara di contenere più di quanto un computer possa. È danneggiato.</translation>
    </message>
    <message>
        <source>it is not a VTK file: its beginning does not state a type of data. Write it again.</source>
        <translation>non è un file VTK: il suo inizio non dice un tipo di dati. Riscriverlo.</translation>
    </message>
    <message>
        <source>it holds data of the type &apos;%1&apos;, which are not a volume. Write them as a grid, a mesh or points.</source>
        <translation>contiene dati di tipo «%1», che non sono un volume. Scriverli come griglia, mesh o punti.</translation>
    </message>
    <message>
        <source>Install VTK with &apos;apt install libvtk9.1&apos; (other systems: VTK 9).</source>
        <translation>Installare VTK con «apt install libvtk9.1» (altri sistemi: VTK 9).</translation>
    </message>
    <message>
        <source>it has no zone. It is cut short, or not Tecplot text.</source>
        <translation>non ha una zona. È troncato, o non è un testo Tecplot.</translation>
    </message>
    <message>
        <source>its zone %1</source>
        <translation>la sua zona %1</translation>
    </message>
    <message>
        <source>its zone %1 (&apos;%2&apos;)</source>
        <translation>la sua zona %1 («%2»)</translation>
    </message>
    <message>
        <source>it holds &apos;%1&apos;, not a grid with its values. Write both into one file (FILETYPE = FULL).</source>
        <translation>contiene «%1», non una griglia con i suoi valori. Scriverli entrambi in un file (FILETYPE = FULL).</translation>
    </message>
    <message>
        <source>it has more numbers than its %1 zones require. Its sizes are wrong, or it is damaged.</source>
        <translation>ha più numeri di quanti ne chiedano le sue %1 zone. Le sue dimensioni sono sbagliate, o è danneggiato.</translation>
    </message>
    <message>
        <source>it has &apos;%1&apos; where a record such as ZONE should begin. It is damaged, or not Tecplot text.</source>
        <translation>ha «%1» dove dovrebbe cominciare un record come ZONE. È danneggiato, o non è un testo Tecplot.</translation>
    </message>
    <message>
        <source>none of its variables is called %1, so that it has no position in space. Name the coordinates X, Y and Z.</source>
        <translation>nessuna delle sue variabili si chiama %1, perciò non ha un posto nello spazio. Chiamare le coordinate X, Y e Z.</translation>
    </message>
    <message>
        <source>it has a zone before its VARIABLES. It is damaged.</source>
        <translation>ha una zona prima delle sue VARIABLES. È danneggiato.</translation>
    </message>
    <message>
        <source>%1 repeats variables with &apos;D&apos;, which is not read. Write it with VARSHARELIST, or all of its variables.</source>
        <translation>%1 ripete variabili con «D», cosa che non si legge. Scriverla con VARSHARELIST, o con tutte le variabili.</translation>
    </message>
    <message>
        <source>%1 ends within its header. It is cut short: copy the file again.</source>
        <translation>%1 finisce dentro la sua intestazione. È troncata: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>%1 has a VARLOCATION &apos;%2&apos; that is not understood.</source>
        <translation>%1 ha una VARLOCATION «%2» che non si capisce.</translation>
    </message>
    <message>
        <source>%1 shares variables with zone &apos;%2&apos;, which does not come before it. The file is damaged or cut short.</source>
        <translation>%1 condivide variabili con la zona «%2», che non viene prima. Il file è danneggiato o troncato.</translation>
    </message>
    <message>
        <source>%1 has &apos;%2&apos;. It is damaged or cut short.</source>
        <translation>%1 ha «%2». È danneggiata o troncata.</translation>
    </message>
    <message>
        <source>%1 is of the type &apos;%2&apos;, which is not read. Divide its elements into bricks or tetrahedra.</source>
        <translation>%1 è di tipo «%2», che non si legge. Dividere i suoi elementi in esaedri o tetraedri.</translation>
    </message>
    <message>
        <source>%1 does not state how many nodes (N) and elements (E) it has. It is damaged or cut short.</source>
        <translation>%1 non dice quanti nodi (N) ed elementi (E) ha. È danneggiata o troncata.</translation>
    </message>
    <message>
        <source>%1 does not state how many points it has (I, J, K). It is damaged or cut short.</source>
        <translation>%1 non dice quanti punti ha (I, J, K). È danneggiata o troncata.</translation>
    </message>
    <message>
        <source>%1 ends before the last of its %2. It is cut short: copy the file again.</source>
        <translation>%1 finisce prima che ci sia tutto: %2. È troncata: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>%1 has something other than a number among its %2. Its sizes are wrong, or it is damaged.</source>
        <translation>%1 in un punto non ha un numero dove dovrebbe esserci: %2. Le sue dimensioni sono sbagliate, o è danneggiata.</translation>
    </message>
    <message>
        <source>%1 ends directly after its last number, or within it. If the file is complete, add an end of line; otherwise copy the file again.</source>
        <translation>%1 finisce subito dopo il suo ultimo numero, o dentro di esso. Se il file è intero, mettervi un fine riga; altrimenti copiarlo di nuovo.</translation>
    </message>
    <message>
        <source>%1 shares values with a zone of another size. The file is damaged.</source>
        <translation>%1 condivide valori con una zona di altre dimensioni. Il file è danneggiato.</translation>
    </message>
    <message>
        <source>%1 has the unknown packing &apos;%2&apos;.</source>
        <translation>%1 è disposta come «%2», che non è noto.</translation>
    </message>
    <message>
        <source>%1 has values of elements, which must be packed by blocks. It is damaged.</source>
        <translation>%1 ha valori di elementi, che devono essere disposti a blocchi. È danneggiata.</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>%1 values of &apos;%2&apos;</source>
        <translation>%1 valori di «%2»</translation>
    </message>
    <message>
        <source>%1 has more numbers than it should. Its sizes are wrong, or it is damaged.</source>
        <translation>%1 ha più numeri del dovuto. Le sue dimensioni sono sbagliate, o è danneggiata.</translation>
    </message>
    <message>
        <source>%1 has no positions of its points. Write it with all coordinates.</source>
        <translation>%1 non ha le posizioni dei suoi punti. Scriverla con tutte le coordinate.</translation>
    </message>
    <message>
        <source>%1 shares its elements with a zone that does not fit. The file is damaged.</source>
        <translation>%1 condivide i suoi elementi con una zona che non corrisponde. Il file è danneggiato.</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 elementi</translation>
    </message>
    <message>
        <source>%1 has an element with node &apos;%2&apos;, and it has %3. It is damaged.</source>
        <translation>%1 ha un elemento al nodo «%2», e ne ha %3. È danneggiata.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has %2 values for %3 points.</source>
        <translation>il suo vettore «%1» ha %2 valori per %3 punti.</translation>
    </message>
    <message>
        <source>it has %1 positions for a grid of %2 points.</source>
        <translation>ha %1 posizioni per una griglia di %2 punti.</translation>
    </message>
    <message>
        <source>the position of point %1 (from 0) is not a number, or too large. Repair the file.</source>
        <translation>la posizione del punto %1 (da 0) non è un numero, o è troppo grande. Riparare il file.</translation>
    </message>
    <message>
        <source>VTK legacy (*.vtk)</source>
        <translation>VTK legacy (*.vtk)</translation>
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
        <translation>Serie TIFF (*.tif *.tiff)</translation>
    </message>
    <message>
        <source>DICOM series (*.dcm *.dicom)</source>
        <translation>Serie DICOM (*.dcm *.dicom)</translation>
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
        <translation>Testo Tecplot (*.tec *.tp)</translation>
    </message>
    <message>
        <source>Give &apos;%1&apos;, or the number of a component from 0.</source>
        <translation>Indicare «%1», o il numero di una componente da 0.</translation>
    </message>
    <message>
        <source>Arrays with several components: the number of one, from 0, or &apos;magnitude&apos;.</source>
        <translation>Di vettori con più componenti: il numero di una, da 0, o «magnitude».</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Passo temporale</translation>
    </message>
    <message>
        <source>Files with several time steps: which one, from 1.</source>
        <translation>Di file con più passi temporali: quale, da 1.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>with-cell</source>
        <translation>con la cella</translation>
    </message>
    <message>
        <source>How surfaces and volume are put in order: &apos;exact&apos;, or, as the paper did, &apos;with-cell&apos;, where the part of a surface in a cell is drawn before the cell.</source>
        <translation>Come si ordinano superfici e volume: «esatto», oppure come faceva l&apos;articolo «con la cella», dove la parte di superficie in una cella si disegna prima della cella.</translation>
    </message>
    <message>
        <source>electron density of the C60 molecule, a hollow ball of smooth bumps</source>
        <translation>densità elettronica della molecola C60, una sfera cava di gobbe lisce</translation>
    </message>
    <message>
        <source>probability density of the hydrogen atom&apos;s 3d electron: two lobes and a ring</source>
        <translation>densità di probabilità dell&apos;elettrone 3d dell&apos;atomo di idrogeno: due lobi e un anello</translation>
    </message>
    <message>
        <source>the test signal of Marschner and Lobb: ripples that are hard to reproduce</source>
        <translation>il segnale di prova di Marschner e Lobb: increspature difficili da riprodurre</translation>
    </message>
    <message>
        <source>white noise, the worst case: no sample predicts its neighbour</source>
        <translation>rumore bianco, il caso peggiore: nessun campione dice nulla del vicino</translation>
    </message>
    <message>
        <source>flow in front of a hemisphere: a curvilinear grid whose axis is collapsed</source>
        <translation>flusso davanti a una semisfera: una griglia curvilinea con l&apos;asse collassato</translation>
    </message>
    <message>
        <source>flow around a cylinder: a curvilinear grid that closes on itself</source>
        <translation>flusso attorno a un cilindro: una griglia curvilinea che si chiude su sé stessa</translation>
    </message>
    <message>
        <source>flow through a bent duct: a curvilinear grid</source>
        <translation>flusso in un condotto curvo: una griglia curvilinea</translation>
    </message>
    <message>
        <source>a layer at a wall: a rectilinear grid with growing spacing</source>
        <translation>uno strato presso una parete: una griglia rettilinea con spaziature crescenti</translation>
    </message>
    <message>
        <source>random points in a ball, with waves that become finer outwards</source>
        <translation>punti casuali in una sfera, con onde più fini verso l&apos;esterno</translation>
    </message>
    <message>
        <source>stress in a plate with five holes and a closed cavity: an irregular mesh</source>
        <translation>tensione in una piastra con cinque fori e una cavità chiusa: una mesh irregolare</translation>
    </message>
    <message>
        <source>There is no sample called &apos;%1&apos;. Available:%2.</source>
        <translation>Non c&apos;è un esempio chiamato «%1». Ci sono:%2.</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Creazione dell&apos;esempio</translation>
    </message>
    <message>
        <source>The sample &apos;%1&apos; has from %2 to %3 points along each axis, not %4.</source>
        <translation>L&apos;esempio «%1» ha da %2 a %3 punti lungo ogni asse, non %4.</translation>
    </message>
    <message>
        <source>Not enough memory to make the sample. Choose a smaller size.</source>
        <translation>La memoria non basta per creare l&apos;esempio. Chiedere dimensioni più piccole.</translation>
    </message>
    <message>
        <source>The array &apos;%1&apos; has %2 values for %3 %4: an array needs a name, and one value for each.</source>
        <translation>Il vettore «%1» ha %2 valori per %3 %4: un vettore richiede un nome e un valore per ciascuno.</translation>
    </message>
    <message>
        <source>The surface &apos;%1&apos; has %2, so it cannot be written.</source>
        <translation>La superficie «%1» ha %2, perciò non può essere scritta.</translation>
    </message>
    <message>
        <source>not one normal for each vertex</source>
        <translation>non una normale per ogni vertice</translation>
    </message>
    <message>
        <source>not one value for each vertex</source>
        <translation>non un valore per ogni vertice</translation>
    </message>
    <message>
        <source>triangles with vertices that it does not have</source>
        <translation>triangoli di vertici che non ha</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be the boundary of more than 1073741824 tetrahedra, too many to find it. Write a .vtu file.</source>
        <translation>«%1» sarebbe il contorno di più di 1073741824 tetraedri, troppi per trovarlo. Scrivere un file .vtu.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than a legacy VTK file can number. Write a .vtu file.</source>
        <translation>«%1» avrebbe più di quanto un file VTK legacy possa numerare. Scrivere un file .vtu.</translation>
    </message>
    <message>
        <source>The film</source>
        <translation>Il filmato</translation>
    </message>
    <message>
        <source>three numbers in brackets</source>
        <translation>tre numeri tra parentesi quadre</translation>
    </message>
    <message>
        <source>an object, in braces</source>
        <translation>un oggetto, tra graffe</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be %2.</source>
        <translation>«%1» deve essere %2.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be written to, so that the view cannot be kept. Free some space there, or save the session.</source>
        <translation>Non si può scrivere nella cartella «%1», quindi la vista non può essere conservata. Liberare spazio lì, o salvare la sessione.</translation>
    </message>
    <message>
        <source>There is no surface to save: add an isovalue, or show one.</source>
        <translation>Non c&apos;è alcuna superficie da salvare: aggiungere un isovalore, o mostrarne uno.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>La memoria non basta per un&apos;immagine di queste dimensioni.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; for samples cannot be made: %2. Make it writable, or free some space.</source>
        <translation>La cartella «%1» per gli esempi non può essere creata: %2. Renderla scrivibile, o liberare spazio.</translation>
    </message>
    <message>
        <source>There is no sample called &apos;%1&apos;.</source>
        <translation>Non c&apos;è un esempio chiamato «%1».</translation>
    </message>
    <message>
        <source>There is not enough memory for the mesh at this accuracy. Choose a coarser one, or close other programs.</source>
        <translation>La memoria non basta per la mesh a questa accuratezza. Sceglierne una minore, o chiudere altri programmi.</translation>
    </message>
    <message>
        <source>its &quot;format&quot; is not &quot;%1&quot;.</source>
        <translation>«format» non è «%1».</translation>
    </message>
    <message>
        <source>this program reads version %1 of sessions only.</source>
        <translation>questo programma conosce solo la versione %1 delle sessioni.</translation>
    </message>
    <message>
        <source>it names no model in &quot;model.path&quot;.</source>
        <translation>non indica un modello in «model.path».</translation>
    </message>
    <message>
        <source>The video could not be made: %1 says &quot;%2&quot;. Choose another format, or PNG pictures.</source>
        <translation>Non è stato possibile creare il video: %1 dice «%2». Scegliere un altro formato, o immagini PNG.</translation>
    </message>
    <message>
        <source>The video</source>
        <translation>Il video</translation>
    </message>
    <message>
        <source>In &apos;%1&apos;: %2</source>
        <translation>In «%1»: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The model of the session cannot be opened. %1</source>
        <translation>Il modello della sessione non può essere aperto. %1</translation>
    </message>
    <message>
        <source>Install VTK with &apos;apt install libvtk9.1&apos;.</source>
        <translation>Installare VTK con «apt install libvtk9.1».</translation>
    </message>
    <message>
        <source>A dataset cannot be written as &apos;%1&apos;. %2</source>
        <translation>Un insieme di dati non può essere scritto come «%1». %2</translation>
    </message>
    <message>
        <source>A mesh cannot be written as &apos;%1&apos;. %2</source>
        <translation>Una mesh non può essere scritta come «%1». %2</translation>
    </message>
    <message>
        <source>Surfaces cannot be written as &apos;%1&apos;. %2</source>
        <translation>Le superfici non possono essere scritte come «%1». %2</translation>
    </message>
    <message>
        <source>Choose one of these endings: %1; or, for the mesh&apos;s boundary alone, %2.</source>
        <translation>Scegliere una di queste estensioni: %1; oppure, per il solo contorno della mesh, %2.</translation>
    </message>
    <message>
        <source>Choose one of these endings: %1.</source>
        <translation>Scegliere una di queste estensioni: %1.</translation>
    </message>
    <message>
        <source>It was built with %1, and this program with %2. Rebuild the plugin with that compiler and the headers of this TAn, or install a build of it for this TAn.</source>
        <translation>È stato compilato con %1 e questo programma con %2. Ricompilare il plugin con questo compilatore e gli header di questo TAn, oppure installarne una versione per questo TAn.</translation>
    </message>
    <message>
        <source>The plugin that writes &apos;%1&apos; announces something that it cannot write. Tell its author.</source>
        <translation>Il plugin che scrive «%1» promette ciò che non sa scrivere. Avvisare il suo autore.</translation>
    </message>
    <message>
        <source>It does not state what it was built with, and this program was built with %1. Rebuild the plugin with tan_plugin_module().</source>
        <translation>Non dice con che cosa è stato compilato, e questo programma è stato compilato con %1. Ricompilare il plugin con tan_plugin_module().</translation>
    </message>
    <message>
        <source>%1%2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>a colour, #rrggbb or a name</source>
        <translation>un colore, #rrggbb o un nome</translation>
    </message>
    <message>
        <source>three numbers x,y,z</source>
        <translation>tre numeri x,y,z</translation>
    </message>
    <message>
        <source>text that describes %1</source>
        <translation>un testo che dia un %1</translation>
    </message>
    <message>
        <source>&quot;edits&quot; does not state which type of parameters the editor is for</source>
        <translation>«edits» non dice per quale tipo di parametri è l&apos;editor</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than the 4 GiB that a .glb file can. Write a .vtp file, or a surface of a larger error.</source>
        <translation>«%1» avrebbe più dei 4 GiB che un file .glb può contenere. Scrivere un file .vtp, o una superficie con un errore maggiore.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than the 2147483647 vertices that a PLY file can number. Write a .vtp file, or a surface of a larger error.</source>
        <translation>«%1» avrebbe più dei 2147483647 vertici che un file PLY può numerare. Scrivere un file .vtp, o una superficie con un errore maggiore.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than the 4294967295 triangles that an STL file can count. Write a .vtp file, or a surface of a larger error.</source>
        <translation>«%1» avrebbe più dei 4294967295 triangoli che un file STL può contare. Scrivere un file .vtp, o una superficie con un errore maggiore.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would hold more than a legacy VTK file can number. Write a .vtp file, or a surface of a larger error.</source>
        <translation>«%1» avrebbe più di quanto un file VTK legacy possa numerare. Scrivere un file .vtp, o una superficie con un errore maggiore.</translation>
    </message>
    <message>
        <source>Tables of points</source>
        <translation>Tabelle di punti</translation>
    </message>
    <message>
        <source>NRRD volumes</source>
        <translation>Volumi NRRD</translation>
    </message>
    <message>
        <source>PLOT3D grids with a solution file</source>
        <translation>Griglie PLOT3D con file di soluzione</translation>
    </message>
    <message>
        <source>VTK XML unstructured grids</source>
        <translation>Griglie non strutturate VTK XML</translation>
    </message>
    <message>
        <source>VTK XML polydata</source>
        <translation>VTK XML polydata</translation>
    </message>
    <message>
        <source>VTK legacy files</source>
        <translation>File VTK legacy</translation>
    </message>
    <message>
        <source>PLY files</source>
        <translation>File PLY</translation>
    </message>
    <message>
        <source>STL files</source>
        <translation>File STL</translation>
    </message>
    <message>
        <source>Wavefront OBJ files</source>
        <translation>File Wavefront OBJ</translation>
    </message>
    <message>
        <source>Binary glTF files</source>
        <translation>File glTF binari</translation>
    </message>
    <message>
        <source>Writing the dataset</source>
        <translation>Scrittura dell&apos;insieme di dati</translation>
    </message>
    <message>
        <source>Writing the mesh</source>
        <translation>Scrittura della mesh</translation>
    </message>
    <message>
        <source>Writing the surfaces</source>
        <translation>Scrittura delle superfici</translation>
    </message>
    <message>
        <source>writer &apos;%1&apos;</source>
        <translation>scrittura «%1»</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>vertici</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tetraedri</translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation>Codifica</translation>
    </message>
    <message>
        <source>raw is quick to write and read, gzip is smaller.</source>
        <translation>raw è rapido da scrivere e da leggere, gzip è più piccolo.</translation>
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
        <translation>Ciò che disegna la scena ha fallito: %1. È un errore del plugin che l&apos;ha creata; avvisare il suo autore.</translation>
    </message>
    <message>
        <source>An optical model of the scene lacks its function or its shader. This is a fault of the plugin that made it; tell its author.</source>
        <translation>A un modello ottico della scena manca la funzione o lo shader. È un errore del plugin che l&apos;ha creata; avvisare il suo autore.</translation>
    </message>
    <message>
        <source>A blend of two volumes supports only emission and absorption. Remove the optical model, or show one of the two.</source>
        <translation>Una dissolvenza tra due volumi si vede solo con emissione e assorbimento. Togliere il modello ottico, o mostrare uno solo dei due.</translation>
    </message>
    <message>
        <source>A scene can have one volume, or one blend of two, and this one has %1. Show the others as surfaces, or in separate pictures.</source>
        <translation>Una scena può avere un volume, o una dissolvenza tra due, e questa ne ha %1. Mostrare gli altri come superfici, o in un&apos;immagine a parte.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; failed without giving a reason. This is a fault of the plugin; tell its author.</source>
        <translation>Il plugin «%1» ha fallito senza dire perché. È un errore del plugin; avvisare il suo autore.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a choice for &apos;%2&apos;. Available: %3.</source>
        <translation>«%1» non è una scelta per «%2». Ci sono: %3.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; made a scene that cannot be shown: %2 This is a fault of the plugin; tell its author.</source>
        <translation>Il plugin «%1» ha creato una scena che non si può mostrare: %2 È un errore del plugin; avvisare il suo autore.</translation>
    </message>
    <message>
        <source>there is none.</source>
        <translation>non ce n&apos;è.</translation>
    </message>
    <message>
        <source>a drawable has no name.</source>
        <translation>un elemento non ha nome.</translation>
    </message>
    <message>
        <source>two drawables are called &apos;%1&apos;.</source>
        <translation>due elementi si chiamano «%1».</translation>
    </message>
    <message>
        <source>It failed to start, without giving a reason. Install it again.</source>
        <translation>È fallito all&apos;avvio senza dire perché. Installarlo di nuovo.</translation>
    </message>
    <message>
        <source>it is compressed with %1, and only zlib is supported. Save it with zlib, or as .vtk, for instance with ParaView.</source>
        <translation>è compresso con %1, e si legge solo zlib. Salvarlo con zlib, o come .vtk, per esempio con ParaView.</translation>
    </message>
    <message>
        <source>it holds several time steps. Save each as a file of its own, for instance with ParaView.</source>
        <translation>contiene più passi temporali. Salvare ciascuno in un file proprio, per esempio con ParaView.</translation>
    </message>
    <message>
        <source>it begins like a grid of %1 points, which takes %2 numbers or more, and has %3</source>
        <translation>comincia come una griglia di %1 punti, che occupa %2 numeri o più, e ne ha %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in line %2 is not a number, or is too large. The file is damaged, or of another format.</source>
        <translation>«%1» alla riga %2 non è un numero, o è troppo grande. Il file è danneggiato, o di un altro formato.</translation>
    </message>
    <message>
        <source>it ends directly after its last number, or within it. If the file is complete, add an end of line; otherwise copy the file again.</source>
        <translation>finisce subito dopo il suo ultimo numero, o dentro di esso. Se il file è intero, mettervi un fine riga; altrimenti copiarlo di nuovo.</translation>
    </message>
    <message>
        <source>with &apos;%1&apos; it repeats numbers more often than is plausible for a file of its size. Write them one by one.</source>
        <translation>con «%1» ripete numeri più spesso di quanto TAn creda a un file delle sue dimensioni. Scriverli uno per uno.</translation>
    </message>
    <message>
        <source>VTK XML (*.vti *.vtr *.vts *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</source>
        <translation>VTK XML (*.vti *.vtr *.vts *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)</translation>
    </message>
    <message>
        <source>its format is not one that TAn leaves to VTK. Let TAn choose the reader.</source>
        <translation>non è di un formato che TAn lascia a VTK. Lasciare a TAn la scelta della lettura.</translation>
    </message>
    <message>
        <source>It returned no widget. Please tell its author.</source>
        <translation>Non ha fornito nulla da mostrare. Avvisare il suo autore.</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; is larger than 64 MiB. Choose a session, camera or transfer function.</source>
        <translation>Il file «%1» è più grande di 64 MiB. Scegliere una sessione, una camera o una funzione di trasferimento.</translation>
    </message>
    <message>
        <source>The picture &apos;%1&apos; does not say how it was made. Choose a model or a session.</source>
        <translation>L&apos;immagine «%1» non dice come è stata fatta. Scegliere un modello o una sessione.</translation>
    </message>
    <message>
        <source>text in quotes</source>
        <translation>un testo tra virgolette</translation>
    </message>
    <message>
        <source>one of the known names</source>
        <translation>uno dei nomi noti</translation>
    </message>
    <message>
        <source>A film needs at least two key frames. Add another view.</source>
        <translation>Un filmato richiede almeno due fotogrammi chiave. Aggiungere un&apos;altra vista.</translation>
    </message>
    <message>
        <source>The shader of an optical model cannot be used. The compiler says: %1</source>
        <translation>Lo shader di un modello ottico non è utilizzabile. Il compilatore dice: %1</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; has an optical model whose shader cannot be used. This is a fault of the plugin; tell its author. The compiler says: %2</source>
        <translation>Il plugin «%1» ha un modello ottico il cui shader non è utilizzabile. È un errore del plugin; segnalarlo al suo autore. Il compilatore dice: %2</translation>
    </message>
    <message>
        <source>A plane needs a normal of three finite numbers, not all zero, and a finite offset.</source>
        <translation>Un piano richiede una normale di tre numeri finiti, non tutti nulli, e una distanza finita.</translation>
    </message>
    <message>
        <source>Not enough memory to cut the mesh. Close other programs or lower the accuracy of the mesh.</source>
        <translation>Memoria insufficiente per tagliare la mesh. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>not one colour for each vertex</source>
        <translation>non un colore per ogni vertice</translation>
    </message>
    <message>
        <source>&apos;--%1&apos; describes raw files, but the header of &apos;%2&apos; states it. Leave it out.</source>
        <translation>«--%1» descrive i file grezzi, e l&apos;intestazione di «%2» lo dice già. Toglierlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; applies only without &apos;%2&apos;. Leave one of them out.</source>
        <translation>«%1» serve solo senza «%2». Tralasciare uno dei due.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; applies only with &apos;%2&apos;. Leave it out, or give both.</source>
        <translation>«%1» serve solo con «%2». Tralasciarlo, o indicare entrambi.</translation>
    </message>
    <message>
        <source>one-sided</source>
        <translation>da un lato</translation>
    </message>
    <message>
        <source>physical</source>
        <translation>fisico</translation>
    </message>
    <message>
        <source>computational</source>
        <translation>computazionale</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a regular lattice, which has no warping. Leave out the options about it.</source>
        <translation>«%1» è un reticolo regolare, che non ha deformazione. Omettere ciò che la riguarda.</translation>
    </message>
    <message>
        <source>Decimation needs the mesh of scattered points, and these are the points alone.</source>
        <translation>La decimazione prende la mesh di punti sparsi, e questi sono solo i punti.</translation>
    </message>
    <message>
        <source>Only irregular data have a boundary that moves, and so a distance from both sides to limit. Leave that out.</source>
        <translation>Solo i dati irregolari hanno un contorno che si sposta e quindi una distanza da entrambi i lati da limitare. Tralasciarla.</translation>
    </message>
    <message>
        <source>The paper&apos;s selection of points cannot be used with blocks: blocks that are refined independently could not agree about their faces. Set the block to &quot;none&quot;.</source>
        <translation>La selezione dei punti come nell&apos;articolo non è possibile con i blocchi: blocchi raffinati indipendentemente non potrebbero accordarsi sulle loro facce. Impostare il blocco su «nessuno».</translation>
    </message>
    <message>
        <source>Examining the cells</source>
        <translation>Esame delle celle</translation>
    </message>
    <message>
        <source>The paper&apos;s selection compares error and warping, so a build cannot be ordered by one of them alone. Choose the normalised selection, or order by both.</source>
        <translation>La selezione dell&apos;articolo confronta errore e deformazione, quindi una costruzione non può essere ordinata in base a uno solo dei due. Scegliere la selezione normalizzata, oppure ordinare in base a entrambi.</translation>
    </message>
    <message>
        <source>The domain of this mesh is not convex, and refinement would fill what its boundary leaves out. Decimation keeps it.</source>
        <translation>Il dominio di questa mesh non è convesso e il raffinamento riempirebbe ciò che il suo contorno lascia fuori. La decimazione lo conserva.</translation>
    </message>
    <message>
        <source>Refining a rectilinear grid of %1 points in physical space takes about %2 of memory, and this machine has %3. Refine it in computational space, as a curvilinear grid, or take a region of it or fewer samples.</source>
        <translation>Raffinare una griglia rettilinea di %1 punti nello spazio fisico richiede circa %2 di memoria, e questo computer ne ha %3. Raffinarla nello spazio computazionale, come griglia curvilinea, oppure prenderne una regione o meno campioni.</translation>
    </message>
    <message>
        <source>Only rectilinear grids can be refined in one space or the other, and &apos;%1&apos; is not one.</source>
        <translation>Solo le griglie rettilinee possono essere raffinate nell&apos;uno o nell&apos;altro spazio, e «%1» non lo è.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a rectilinear grid, which is refined in physical space: there it has no warping and no blocks. Leave these out, or refine it in computational space.</source>
        <translation>«%1» è una griglia rettilinea, che viene raffinata nello spazio fisico: lì non ha deformazione né blocchi. Ometterli, oppure raffinarla nello spazio computazionale.</translation>
    </message>
    <message>
        <source>When refined, &apos;%1&apos; has no warping. Leave out the options about it.</source>
        <translation>Raffinato, «%1» non ha deformazione. Omettere ciò che la riguarda.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a grid, so it has no blocks. Leave them out.</source>
        <translation>«%1» non è una griglia, quindi non ha blocchi. Ometterli.</translation>
    </message>
    <message>
        <source>Refinement uses the points of a convex mesh, and this is the mesh itself.</source>
        <translation>Il raffinamento prende i punti di una mesh convessa, e questa è la mesh stessa.</translation>
    </message>
    <message>
        <source>A build ordered by the error alone has no threshold of warping. Leave that out, or order by both.</source>
        <translation>Ordinata in base al solo errore, una costruzione non ha soglia di deformazione. Ometterla, oppure ordinare in base a entrambi.</translation>
    </message>
    <message>
        <source>A build ordered by the warping alone has no threshold of error. Leave that out, or order by both.</source>
        <translation>Ordinata in base alla sola deformazione, una costruzione non ha soglia di errore. Ometterla, oppure ordinare in base a entrambi.</translation>
    </message>
    <message>
        <source>it has a value that is not finite</source>
        <translation>ha un valore non finito</translation>
    </message>
    <message>
        <source>it has no volume</source>
        <translation>non ha volume</translation>
    </message>
    <message>
        <source>it is too warped to be cut into tetrahedra</source>
        <translation>è troppo deformata per essere suddivisa in tetraedri</translation>
    </message>
    <message>
        <source>it appears twice</source>
        <translation>è presente due volte</translation>
    </message>
    <message>
        <source>more than two cells share one of its faces</source>
        <translation>più di due celle condividono una delle sue facce</translation>
    </message>
    <message>
        <source>it is inverted and overlaps its neighbours</source>
        <translation>è invertita e si sovrappone alle vicine</translation>
    </message>
    <message>
        <source>it overlaps others</source>
        <translation>si sovrappone ad altre</translation>
    </message>
    <message>
        <source>1 cell was left out: more than two cells share one of its faces.</source>
        <translation>1 cella è stata tralasciata: più di due celle condividono una delle sue facce.</translation>
    </message>
    <message>
        <source>%1 cells were left out: more than two cells share one of their faces.</source>
        <translation>%1 celle sono state tralasciate: più di due celle condividono una delle loro facce.</translation>
    </message>
    <message>
        <source>1 cell was left out: it is inverted and overlaps its neighbours.</source>
        <translation>1 cella è stata tralasciata: è invertita e si sovrappone alle vicine.</translation>
    </message>
    <message>
        <source>%1 cells were left out: they are inverted and overlap their neighbours.</source>
        <translation>%1 celle sono state tralasciate: sono invertite e si sovrappongono alle vicine.</translation>
    </message>
    <message>
        <source>1 cell was left out: it overlaps others.</source>
        <translation>1 cella è stata tralasciata: si sovrappone ad altre.</translation>
    </message>
    <message>
        <source>%1 cells were left out: they overlap others.</source>
        <translation>%1 celle sono state tralasciate: si sovrappongono ad altre.</translation>
    </message>
    <message>
        <source>It has holes, points that are blanked out or without a finite value, which make it an irregular mesh: up to %1 tetrahedra, which take %2 of memory, of %3. Take a region or every n-th point of it, or replace those values with numbers.</source>
        <translation>Ha dei fori, punti esclusi o senza un valore finito, perciò è una mesh irregolare: fino a %1 tetraedri, che occupano %2 di memoria, su %3. Prendere una regione o un punto ogni n, oppure sostituire quei valori con numeri.</translation>
    </message>
    <message>
        <source>No cell of the grid has a finite value at each of its corners, or all are blanked out: nothing is left.</source>
        <translation>Nessuna cella della griglia ha un valore finito in ogni vertice, oppure sono tutte escluse: non resta nulla.</translation>
    </message>
    <message>
        <source>The grid has become an irregular mesh with holes.</source>
        <translation>La griglia è diventata una mesh irregolare con fori.</translation>
    </message>
    <message>
        <source>%1 Left out with the cells around them: %2 of its %3 points, blanked out or without a finite value.</source>
        <translation>%1 Tralasciati con le celle attorno: %2 dei suoi %3 punti, esclusi o senza un valore finito.</translation>
    </message>
    <message>
        <source>It has blanking flags for %1 cells, but %2 cells. It is damaged.</source>
        <translation>Indica per %1 celle se sono escluse, e ne ha %2. È danneggiato.</translation>
    </message>
    <message>
        <source>1 pair of tetrahedra that overlap, one at %1</source>
        <translation>1 coppia di tetraedri sovrapposti, uno in %1</translation>
    </message>
    <message>
        <source>%1 pairs of tetrahedra that overlap, one at %2</source>
        <translation>%1 coppie di tetraedri sovrapposti, uno in %2</translation>
    </message>
    <message>
        <source>the position of point %1 is not a finite number, or too large. Leave it out.</source>
        <translation>la posizione del punto %1 non è un numero finito, o è troppo grande. Ometterlo.</translation>
    </message>
    <message>
        <source>none of its values is a finite number.</source>
        <translation>nessuno dei suoi valori è un numero finito.</translation>
    </message>
    <message>
        <source>1 point without a finite value was left out.</source>
        <translation>1 punto senza un valore finito è stato tralasciato.</translation>
    </message>
    <message>
        <source>%1 points without a finite value were left out.</source>
        <translation>%1 punti senza un valore finito sono stati tralasciati.</translation>
    </message>
    <message>
        <source>The tetrahedralization</source>
        <translation>La tetraedrizzazione</translation>
    </message>
    <message>
        <source>Tetrahedralizing the points</source>
        <translation>Tetraedrizzazione dei punti</translation>
    </message>
    <message>
        <source>Testing the boundary</source>
        <translation>Controllo del contorno</translation>
    </message>
    <message>
        <source>the camera&apos;s position</source>
        <translation>la posizione della camera</translation>
    </message>
    <message>
        <source>the isovalues</source>
        <translation>gli isovalori</translation>
    </message>
    <message>
        <source>the opacities</source>
        <translation>le opacità</translation>
    </message>
    <message>
        <source>Not enough memory for all meshes of up to %1 sites. Choose a larger error.</source>
        <translation>Memoria insufficiente per tutte le mesh fino a %1 siti. Scegliere un errore maggiore.</translation>
    </message>
    <message>
        <source>Selecting tetrahedra by when they appear and disappear</source>
        <translation>Scelta dei tetraedri secondo la loro vita</translation>
    </message>
    <message>
        <source>An end of the range of accuracies is not a number. Give both in percent.</source>
        <translation>Un estremo dell&apos;intervallo di accuratezze non è un numero. Indicarli entrambi in percentuale.</translation>
    </message>
    <message>
        <source>A range of errors at which tetrahedra appear or disappear goes from a smaller error to a larger one: %1 and %2 do not.</source>
        <translation>Un intervallo di nascite o morti va da un errore minore a uno maggiore: %1 e %2 no.</translation>
    </message>
    <message>
        <source>A budget is for one mesh, and a range of accuracies has many. Leave one of the two out.</source>
        <translation>Un budget vale per una mesh, e un intervallo di accuratezze ne ha molte. Omettere uno dei due.</translation>
    </message>
    <message>
        <source>OpenGL draws at most %1 focus regions. Take fewer, or use the CPU back end.</source>
        <translation>OpenGL disegna al massimo %1 regioni di focus. Usarne di meno, o disegnare con il processore.</translation>
    </message>
    <message>
        <source>rectilinear</source>
        <translation>rettilineo</translation>
    </message>
    <message>
        <source>For data whose domain can warp: the warping at which to stop. Its ratio to the error sets how much the shape counts against the values. If one of the two is 0, it is the same number as the other.</source>
        <translation>Per dati il cui dominio può deformarsi: la deformazione alla quale fermarsi. Il suo rapporto con l&apos;errore dice quanto conta la forma rispetto ai valori. Se uno dei due è 0, è lo stesso numero dell&apos;altro.</translation>
    </message>
    <message>
        <source>Ordered by</source>
        <translation>Ordinato per</translation>
    </message>
    <message>
        <source>For data whose domain can warp: &apos;both&apos; orders the model by the larger of error and warping, in the ratio of their thresholds; &apos;error&apos; or &apos;warping&apos; by that alone, for the fewest points where the other one does not matter.</source>
        <translation>Per dati il cui dominio può deformarsi: «entrambi» ordina il modello secondo il maggiore tra errore e deformazione, nel rapporto delle loro soglie; «errore» o «deformazione» secondo questo solo, per il minor numero di punti dove l&apos;altro non conta.</translation>
    </message>
    <message>
        <source>both</source>
        <translation>entrambi</translation>
    </message>
    <message>
        <source>error</source>
        <translation>errore</translation>
    </message>
    <message>
        <source>warping</source>
        <translation>deformazione</translation>
    </message>
    <message>
        <source>two-sided</source>
        <translation>da entrambi i lati</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>What the warping of irregular data measures: &apos;one-sided&apos;, as the paper did, how far the points of the data&apos;s boundary are from that of a mesh; &apos;two-sided&apos; also how far any place on a mesh&apos;s boundary is from that of the data.</source>
        <translation>Che cosa misura la deformazione dei dati irregolari: «da un lato», come nell&apos;articolo, quanto i punti del contorno dei dati distano da quello di una mesh; «da entrambi i lati» anche quanto ogni punto del contorno di una mesh dista da quello dei dati.</translation>
    </message>
    <message>
        <source>Scattered points: decimation begins with the Delaunay mesh of all of them, and needs fewer of them for the same accuracy, but more time and memory.</source>
        <translation>Punti sparsi: la decimazione comincia con la mesh di Delaunay di tutti i punti e ne richiede meno per la stessa accuratezza, ma più tempo e memoria.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Spazio</translation>
    </message>
    <message>
        <source>The edge length, in cells, of the blocks that are refined independently, a few of them in memory at a time; &apos;none&apos; refines the dataset as a whole; &apos;automatic&apos; uses blocks where a lattice or grid is large.</source>
        <translation>Le celle lungo uno spigolo dei blocchi, che vengono raffinati indipendentemente, con memoria solo per alcuni di essi; «nessuno» raffina i dati come un tutto; «automatico» usa blocchi se un reticolo o una griglia è grande.</translation>
    </message>
    <message>
        <source>A rectilinear grid: refinement in physical space keeps the exact domain.</source>
        <translation>Una griglia rettilinea: il raffinamento nello spazio fisico conserva il dominio esatto.</translation>
    </message>
    <message>
        <source>A mesh of convex domain: refinement keeps the exact domain, with tetrahedra of its own.</source>
        <translation>Una mesh di dominio convesso: il raffinamento conserva il dominio esatto, con tetraedri propri.</translation>
    </message>
    <message>
        <source>The mesh is too large to be shown.</source>
        <translation>La mesh è troppo grande per essere guardata.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a rectilinear grid</source>
        <translation>«%1» è una griglia rettilinea</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is for %2 data only, and %3. Leave it out, or choose &apos;%4 %5&apos;.</source>
        <translation>«%1» vale solo per questo tipo di dati: %2; ma %3. Ometterlo, o scegliere «%4 %5».</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>superfici</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>What is shown, inside and outside the focus: the volume, isosurfaces, or both.</source>
        <translation>Che cosa si mostra dentro e fuori dal focus: il volume, le isosuperfici o entrambi.</translation>
    </message>
    <message>
        <source>A range of accuracies has overlapping tetrahedra, so their volume cannot be drawn. Choose isosurfaces, or limits of appearance and disappearance that leave one mesh.</source>
        <translation>Un intervallo di accuratezze ha tetraedri sovrapposti, quindi il loro volume non si può disegnare. Scegliere le isosuperfici, o limiti che lascino una sola mesh.</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lettura del modello</translation>
    </message>
    <message>
        <source>Set XDG_CACHE_HOME to a folder that can be written to.</source>
        <translation>Impostare XDG_CACHE_HOME su una cartella scrivibile.</translation>
    </message>
    <message>
        <source>Cannot use the cache folder &apos;%1&apos;: %2. %3</source>
        <translation>Impossibile usare la cartella cache «%1»: %2. %3</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>nella griglia</translation>
    </message>
    <message>
        <source>space</source>
        <translation>nello spazio</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was cut short or changed while it was read. Copy the file again.</source>
        <translation>«%1» è stato troncato o modificato durante la lettura. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>The error in space is kept in whole grids only, as a point may lie in a tetrahedron of another block. Set the block to &quot;none&quot;.</source>
        <translation>L&apos;errore nello spazio è mantenuto solo in griglie intere, perché un punto può trovarsi in un tetraedro di un altro blocco. Impostare il blocco su «nessuno».</translation>
    </message>
    <message>
        <source>To keep the error in space, a build must be ordered by error and warping, with the normalised selection. Leave out the other choice.</source>
        <translation>Per mantenere l&apos;errore nello spazio, una costruzione è ordinata in base a errore e deformazione, con la selezione normalizzata. Omettere l&apos;altra scelta.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is refined in the space where its points lie, so its error is the error in space. Leave this choice out.</source>
        <translation>«%1» viene raffinato nello spazio in cui si trovano i suoi punti, quindi il suo errore è l&apos;errore nello spazio. Omettere questa scelta.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a packed model. Unpack it first, with &apos;tan unpack&apos;.</source>
        <translation>«%1» è un modello compresso. Decomprimerlo prima con «tan unpack».</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; is invalid</source>
        <translation>la sezione «%1» non ha senso</translation>
    </message>
    <message>
        <source>Not enough memory to open &apos;%1&apos;. Close other programs.</source>
        <translation>La memoria non basta per aprire «%1». Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2. Copy the file again, or pack the model again.</source>
        <translation>«%1» è danneggiato: %2. Copiare di nuovo il file o comprimere di nuovo il modello.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is packed by method %2, which this version does not know. Install a later version of TAn.</source>
        <translation>«%1» è compresso con il metodo %2, che questa versione non conosce. Installare una versione più recente di TAn.</translation>
    </message>
    <message>
        <source>its levels are invalid</source>
        <translation>i suoi livelli non hanno senso</translation>
    </message>
    <message>
        <source>Reading a packed model</source>
        <translation>Lettura di un modello compresso</translation>
    </message>
    <message>
        <source>a chunk is cut short</source>
        <translation>un blocco è troncato</translation>
    </message>
    <message>
        <source>the checksum of a chunk is wrong</source>
        <translation>la somma di controllo di un blocco è errata</translation>
    </message>
    <message>
        <source>This packed mesh is damaged.</source>
        <translation>Questa mesh compressa è danneggiata.</translation>
    </message>
    <message>
        <source>This mesh cannot be packed: its arrays do not belong together, or it has more than %1 tetrahedra.</source>
        <translation>Questa mesh non può essere compressa: i suoi vettori non vanno insieme, o ha più di %1 tetraedri.</translation>
    </message>
    <message>
        <source>What was received is not a packed mesh of this version, or is damaged.</source>
        <translation>Ciò che è stato ricevuto non è una mesh compressa di questa versione, o è danneggiato.</translation>
    </message>
    <message>
        <source>The mesh has %1 tetrahedra, and at most %2 are taken.</source>
        <translation>La mesh ha %1 tetraedri, e se ne accettano al massimo %2.</translation>
    </message>
    <message>
        <source>Not enough memory for a packed mesh. Choose a larger error or a part of it.</source>
        <translation>Memoria insufficiente per una mesh compressa. Chiedere un errore maggiore o una sua parte.</translation>
    </message>
    <message>
        <source>Not enough memory to unpack &apos;%1&apos;. Close other programs, or unpack it on a larger machine.</source>
        <translation>Memoria insufficiente per decomprimere «%1». Chiudere altri programmi o decomprimerlo su una macchina più grande.</translation>
    </message>
    <message>
        <source>Not enough memory to pack &apos;%1&apos;. Close other programs, or pack it on a larger machine.</source>
        <translation>Memoria insufficiente per comprimere «%1». Chiudere altri programmi o comprimerlo su una macchina più grande.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 levels, and level %3 is none of them.</source>
        <translation>«%1» ha %2 livelli, e il livello %3 non è tra questi.</translation>
    </message>
    <message>
        <source>Packing the model</source>
        <translation>Compressione del modello</translation>
    </message>
    <message>
        <source>Unpacking the model</source>
        <translation>Decompressione del modello</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be packed: most of it is in sections that this version does not know.</source>
        <translation>«%1» non può essere compresso: gran parte è in sezioni che questa versione non conosce.</translation>
    </message>
    <message>
        <source>its content is not a history</source>
        <translation>ciò che contiene non è una storia</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be packed: its history is not that of a mesh. &apos;tan verify&apos; gives details.</source>
        <translation>«%1» non può essere compresso: la sua storia non è quella di una mesh. «tan verify» dice di più.</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Compressione</translation>
    </message>
    <message>
        <source>its sites are invalid</source>
        <translation>i suoi siti non hanno senso</translation>
    </message>
    <message>
        <source>a lattice of %1 points cannot be replayed</source>
        <translation>un reticolo di %1 punti non può essere ripetuto</translation>
    </message>
    <message>
        <source>its text does not tell how it was built</source>
        <translation>il suo testo non dice come è costruito</translation>
    </message>
    <message>
        <source>its samples are not those that it was packed with</source>
        <translation>i suoi campioni non sono quelli con cui è stato compresso</translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation>Scrittura del modello</translation>
    </message>
    <message>
        <source>Replaying the insertions</source>
        <translation>Ripetizione degli inserimenti</translation>
    </message>
    <message>
        <source>The lattice is too large to be packed as a whole.</source>
        <translation>Il reticolo è troppo grande per essere compresso per intero.</translation>
    </message>
    <message>
        <source>A point lies in no tetrahedron of the mesh.</source>
        <translation>Un punto non si trova in alcun tetraedro della mesh.</translation>
    </message>
    <message>
        <source>TAN_CACHE_MB is &apos;%1&apos;. Give the maximum size of the cache folder in megabytes.</source>
        <translation>TAN_CACHE_MB è «%1». Indicare quanti megabyte può occupare al massimo la cartella cache.</translation>
    </message>
    <message>
        <source>There is no cache folder, because this user has no home folder. Set XDG_CACHE_HOME to a folder.</source>
        <translation>Non c&apos;è una cartella cache, perché questo utente non ha una cartella personale. Impostare XDG_CACHE_HOME su una cartella.</translation>
    </message>
    <message>
        <source>Waiting for a file of the cache folder</source>
        <translation>Attesa di un file della cartella cache</translation>
    </message>
    <message>
        <source>The cache folder &apos;%1&apos; has no room for %2 more: its limit is %3, and files in use are kept. Set TAN_CACHE_MB to more megabytes.</source>
        <translation>Nella cartella cache «%1» non c&apos;è posto per altri %2: il limite è %3, e ciò che è in uso resta. Impostare TAN_CACHE_MB su più megabyte.</translation>
    </message>
    <message>
        <source>Not enough memory to read the cache folder &apos;%1&apos;. Close other programs.</source>
        <translation>Memoria insufficiente per esaminare la cartella cache «%1». Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; sends more than %2, the most that is accepted.</source>
        <translation>«%1» invia più di %2, il massimo accettato.</translation>
    </message>
    <message>
        <source>Not enough memory for the server&apos;s answer. Request less.</source>
        <translation>Memoria insufficiente per ciò che invia il server. Chiedere di meno.</translation>
    </message>
    <message>
        <source>the file on the server was changed while it was read. Open it again.</source>
        <translation>il file sul server è stato modificato durante la lettura. Aprirlo di nuovo.</translation>
    </message>
    <message>
        <source>the server or a proxy compresses what it sends (%1), so that parts of the file cannot be located. Download the file and open the copy.</source>
        <translation>il server o un proxy comprime ciò che invia (%1), e le parti del file non si riconoscono. Scaricare il file e aprire la copia.</translation>
    </message>
    <message>
        <source>the server does not state the length of the file. Download the file and open the copy.</source>
        <translation>il server non dice quanto è lungo il file. Scaricare il file e aprire la copia.</translation>
    </message>
    <message>
        <source>its server delivers files only as a whole, not in parts (range requests). Download the file and open the copy, or put it on a server that supports ranges.</source>
        <translation>il suo server dà i file solo interi, non in parti (range request). Scaricare il file e aprire la copia, oppure metterlo su un server che conosca i range.</translation>
    </message>
    <message>
        <source>the server sends a different part of the file from the one requested. Download the file and open the copy.</source>
        <translation>il server dà una parte del file diversa da quella richiesta. Scaricare il file e aprire la copia.</translation>
    </message>
    <message>
        <source>the program that answers there is not a web server. Check the address and its port.</source>
        <translation>ciò che risponde non è un server web. Controllare l&apos;indirizzo e la porta.</translation>
    </message>
    <message>
        <source>the connection was lost again and again, because of the server or a proxy on the way. Try again later, or download the file and open the copy.</source>
        <translation>la connessione è stata interrotta più volte, dal server o da un proxy intermedio. Riprovare più tardi, o scaricare il file e aprire la copia.</translation>
    </message>
    <message>
        <source>the server requires a name and a password. Give them in the address, https://NAME:PASSWORD@..., or download the file.</source>
        <translation>il server chiede un nome e una password. Indicarli nell&apos;indirizzo, https://NOME:PASSWORD@..., o scaricare il file.</translation>
    </message>
    <message>
        <source>the proxy requires a name and a password. Set https_proxy to an address with both.</source>
        <translation>il proxy chiede un nome e una password. Impostare https_proxy su un indirizzo che li contenga.</translation>
    </message>
    <message>
        <source>there is no such file on the server (%1). Check the address.</source>
        <translation>sul server non c&apos;è questo file (%1). Controllare l&apos;indirizzo.</translation>
    </message>
    <message>
        <source>the server is busy (%1). Try again later.</source>
        <translation>il server è occupato (%1). Riprovare più tardi.</translation>
    </message>
    <message>
        <source>the server failed (%1). Try again later, or tell its operator.</source>
        <translation>il server ha un errore (%1). Riprovare più tardi, o avvisare chi lo gestisce.</translation>
    </message>
    <message>
        <source>the server answers with status %1 instead of data. Check the address.</source>
        <translation>il server risponde con lo stato %1 invece che con i dati. Controllare l&apos;indirizzo.</translation>
    </message>
    <message>
        <source>its host was not found. Check the address and the network.</source>
        <translation>il suo host non è stato trovato. Controllare l&apos;indirizzo e la rete.</translation>
    </message>
    <message>
        <source>the proxy was not found. Check http_proxy and https_proxy.</source>
        <translation>il proxy non è stato trovato. Controllare http_proxy e https_proxy.</translation>
    </message>
    <message>
        <source>nothing answers at that host and port. Check the address and the network.</source>
        <translation>a quell&apos;host e a quella porta non risponde nulla. Controllare l&apos;indirizzo e la rete.</translation>
    </message>
    <message>
        <source>the server redirects from one address to another and never to a file. Check the address.</source>
        <translation>il server rimanda da un indirizzo all&apos;altro e a nessun file. Controllare l&apos;indirizzo.</translation>
    </message>
    <message>
        <source>the certificate of its host cannot be trusted (%1). Check the address and this machine&apos;s clock; read nothing from it if you do not know why.</source>
        <translation>il certificato dell&apos;host non è affidabile (%1). Controllare l&apos;indirizzo e l&apos;orologio di questo computer; non leggere nulla da lì se il motivo non è noto.</translation>
    </message>
    <message>
        <source>a secure connection to its host cannot be made (%1). Check whether the address begins with http:// or https://.</source>
        <translation>non c&apos;è una connessione sicura con l&apos;host (%1). Controllare se l&apos;indirizzo inizia con http:// o https://.</translation>
    </message>
    <message>
        <source>the server redirects to an address that is not safe to follow. Give the address of the file itself.</source>
        <translation>il server rimanda a un indirizzo che non è sicuro seguire. Indicare l&apos;indirizzo del file stesso.</translation>
    </message>
    <message>
        <source>the file is empty. Check the address.</source>
        <translation>il file è vuoto. Controllare l&apos;indirizzo.</translation>
    </message>
    <message>
        <source>The cache folder returns other bytes than were written to it. Check its disk, or set XDG_CACHE_HOME to a folder on another one.</source>
        <translation>La cartella cache dà byte diversi da quelli che vi sono stati scritti. Controllare il disco, o impostare XDG_CACHE_HOME su una cartella di un altro disco.</translation>
    </message>
    <message>
        <source>Reading &apos;%1&apos;</source>
        <translation>Lettura di «%1»</translation>
    </message>
    <message>
        <source>it ends too early. It is not a complete model: ask the person who put it there.</source>
        <translation>finisce prima di ciò che si cercava. Non è un modello intero: chiedere a chi l&apos;ha messo lì.</translation>
    </message>
    <message>
        <source>Reading from the network</source>
        <translation>Lettura dalla rete</translation>
    </message>
    <message>
        <source>nothing arrived from the server for %1 seconds, or too slowly. Check the network, or try again later.</source>
        <translation>dal server non è arrivato nulla per %1 secondi, o troppo lentamente. Controllare la rete, o riprovare più tardi.</translation>
    </message>
    <message>
        <source>The part of a picture to be drawn must lie within it.</source>
        <translation>La parte di un&apos;immagine da disegnare deve trovarsi al suo interno.</translation>
    </message>
    <message>
        <source>Error in</source>
        <translation>L&apos;errore vale</translation>
    </message>
    <message>
        <source>What an interrupted build left in &apos;%1&apos; is damaged. Build from the beginning.</source>
        <translation>Ciò che una costruzione interrotta ha lasciato in «%1» è danneggiato. Ricominciare la costruzione dall&apos;inizio.</translation>
    </message>
    <message>
        <source>What an interrupted build left in &apos;%1&apos; belongs to other data, other options, or another version of TAn. Give the same ones, or build from the beginning.</source>
        <translation>Ciò che una costruzione interrotta ha lasciato in «%1» appartiene ad altri dati, ad altre opzioni o a un&apos;altra versione di TAn. Indicare gli stessi, oppure ricominciare la costruzione dall&apos;inizio.</translation>
    </message>
    <message>
        <source>Refining all blocks coarsely</source>
        <translation>Raffinamento grossolano di tutti i blocchi</translation>
    </message>
    <message>
        <source>Restoring the interrupted build</source>
        <translation>Ripresa di quanto già fatto</translation>
    </message>
    <message>
        <source>it lists a faulty cell that its grid does not have</source>
        <translation>elenca una cella difettosa che la sua griglia non ha</translation>
    </message>
    <message>
        <source>it lists a faulty cell that is not faulty</source>
        <translation>elenca una cella difettosa che non è tale</translation>
    </message>
    <message>
        <source>There is no file &apos;%1&apos;. An address on a server begins with http:// or https://.</source>
        <translation>Il file «%1» non esiste. Un indirizzo su un server comincia con http:// o https://.</translation>
    </message>
    <message>
        <source>The file of &apos;%1&apos; was made by a version of TAn that did not record where its coarse meshes end, so it cannot be left at the server. Build it again, or copy it there with &apos;tan pack&apos; and &apos;tan unpack&apos;.</source>
        <translation>Il file di «%1» è di una versione di TAn che non scriveva dove finiscono le sue mesh rade, quindi non può restare sul server. Costruirlo di nuovo, o riscriverlo lì con «tan pack» e «tan unpack».</translation>
    </message>
    <message>
        <source>A server cannot extract a range of accuracies whose two ends have different warpings. Give both the same.</source>
        <translation>A un server non si può chiedere un intervallo di accuratezze i cui estremi hanno deformazioni proprie. Dare a entrambi la stessa.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not extract meshes (status %2): only a TAn server (&apos;tan serve&apos;) of this version does. Download the model from there instead.</source>
        <translation>«%1» non trova mesh (stato %2): lo fa solo un server di TAn («tan serve») di questa versione. Far scaricare il modello.</translation>
    </message>
    <message>
        <source>The server of &apos;%1&apos; says: %2</source>
        <translation>Il server di «%1» risponde: %2</translation>
    </message>
    <message>
        <source>What &apos;%1&apos; says of its model cannot be read. The server may run another version of TAn.</source>
        <translation>Ciò che «%1» dice del suo modello non si può leggere. Forse è un server di un&apos;altra versione di TAn.</translation>
    </message>
    <message>
        <source>The error field is too long for a server request: %1 of at most %2 characters. Use fewer regions, isovalues or points of the transfer function.</source>
        <translation>Ciò che dice dove quale errore è ammesso è troppo lungo per una richiesta a un server: %1 di al massimo %2 caratteri. Usare meno regioni, isovalori o punti della funzione di trasferimento.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; was changed on its server. Open it again.</source>
        <translation>Il modello «%1» è stato modificato sul suo server. Aprirlo di nuovo.</translation>
    </message>
    <message>
        <source>The sites yield more than they should.</source>
        <translation>I siti producono più di quanto dovrebbero.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has positions or values that are not finite.</source>
        <translation>«%1» contiene posizioni o valori non finiti.</translation>
    </message>
    <message>
        <source>Unpacking the mesh</source>
        <translation>Decompressione della mesh</translation>
    </message>
    <message>
        <source>Unpacking the whole model: %1</source>
        <translation>Decompressione dell&apos;intero modello: %1</translation>
    </message>
    <message>
        <source>The server of &apos;%1&apos; requires a token. Give the one issued by its operator; on the command line with &apos;--token-file&apos;.</source>
        <translation>Il server di «%1» risponde solo a chi ha il suo token. Indicare quello stabilito da chi lo gestisce; sulla riga di comando con «--token-file».</translation>
    </message>
    <message>
        <source>Packing the mesh</source>
        <translation>Compressione della mesh</translation>
    </message>
    <message>
        <source>Waiting for the server</source>
        <translation>Attesa del server</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Ricezione</translation>
    </message>
    <message>
        <source>Asking the server</source>
        <translation>Richiesta al server</translation>
    </message>
    <message>
        <source>the server sends a web page or a list instead of data. Open the address in a browser: you may have to log in, or to choose a file there and give its address.</source>
        <translation>il server dà una pagina web o un elenco al posto dei dati. Aprire l&apos;indirizzo in un browser: forse occorre accedere, oppure scegliere lì un file e indicarne l&apos;indirizzo.</translation>
    </message>
    <message>
        <source>the server requires a token. Give the one issued by its operator; on the command line with &apos;--token-file&apos;.</source>
        <translation>il server risponde solo a chi ha il suo token. Indicare quello stabilito da chi lo gestisce; sulla riga di comando con «--token-file».</translation>
    </message>
    <message>
        <source>the server does not allow it (403). Ask its operator, or check whether the address has expired.</source>
        <translation>il server non lo permette (403). Chiedere a chi lo gestisce, o controllare se l&apos;indirizzo è scaduto.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is an address, and datasets are read from this computer only. Download it and give the file.</source>
        <translation>«%1» è un indirizzo, e i dati si leggono solo da questo computer. Scaricare il file e indicare quello.</translation>
    </message>
    <message>
        <source>Cannot read &apos;%1&apos;: it has more than %2 bytes, too many for such a file.</source>
        <translation>Impossibile leggere «%1»: ha più di %2 byte, troppi per un file del genere.</translation>
    </message>
    <message>
        <source>This TAn cannot make a mesh of the points of &apos;%1&apos;: it was built without CGAL (TAN_CGAL). Use one that has it, or data with a grid or with cells.</source>
        <translation>Questo TAn non fa una mesh dei punti di «%1»: è stato compilato senza CGAL (TAN_CGAL). Usarne uno che lo abbia, o dati con una griglia o con celle.</translation>
    </message>
    <message>
        <source>The history has more than %1 sites. Choose a larger error, or build in blocks.</source>
        <translation>La storia ha più di %1 siti. Chiedere un errore più grande, o costruire a blocchi.</translation>
    </message>
    <message>
        <source>section &apos;%1&apos; holds impossible numbers</source>
        <translation>la sezione «%1» contiene numeri impossibili</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: section &apos;%2&apos; was planned with %3 bytes, which does not match its content. This is a fault of TAn: please report it.</source>
        <translation>Impossibile scrivere «%1»: la sezione «%2» era prevista di %3 byte, che non corrispondono a ciò che contiene. È un difetto di TAn: si prega di segnalarlo.</translation>
    </message>
    <message>
        <source>There is no folder for temporary files: %1.</source>
        <translation>Non c&apos;è una cartella per i file temporanei: %1.</translation>
    </message>
    <message>
        <source>The model cannot be packed into &apos;%1&apos;: the errors that it claims are invalid. &apos;tan verify&apos; gives details.</source>
        <translation>Il modello non può essere compresso in «%1»: gli errori che dichiara non hanno senso. «tan verify» dice di più.</translation>
    </message>
    <message>
        <source>The mesh has %1 tetrahedra, too many for the memory of this machine. Choose a larger error or a part of it.</source>
        <translation>La mesh ha %1 tetraedri, troppi per la memoria di questo computer. Chiedere un errore più grande o una sua parte.</translation>
    </message>
    <message>
        <source>something precedes section &apos;%1&apos;</source>
        <translation>c&apos;è qualcosa prima della sezione «%1»</translation>
    </message>
    <message>
        <source>This TAn cannot make a mesh of scattered points: it was built without CGAL (TAN_CGAL). Use one that has it, or data with a grid or with cells.</source>
        <translation>Questo TAn non fa una mesh di punti sparsi: è stato compilato senza CGAL (TAN_CGAL). Usarne uno che lo abbia, o dati con una griglia o con celle.</translation>
    </message>
    <message>
        <source>Cannot use the cache folder &apos;%1&apos;: %2. Set XDG_CACHE_HOME to a folder that only you can use.</source>
        <translation>Impossibile usare la cartella cache «%1»: %2. Impostare XDG_CACHE_HOME su una cartella che sia soltanto propria.</translation>
    </message>
    <message>
        <source>it belongs to another user</source>
        <translation>appartiene a un altro utente</translation>
    </message>
    <message>
        <source>others can write to it</source>
        <translation>altri possono scriverci</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another user</source>
        <translation>«%1» appartiene a un altro utente</translation>
    </message>
    <message>
        <source>everybody can write to &apos;%1&apos;</source>
        <translation>tutti possono scrivere in «%1»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not answer: %2</source>
        <translation>«%1» non risponde: %2</translation>
    </message>
    <message>
        <source>nothing arrived for %1 seconds, or too slowly. Check the network, and whether the server is running.</source>
        <translation>per %1 secondi non è arrivato nulla, o troppo lentamente. Controllare la rete, e che il server sia attivo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the address of a server. Write it as http://HOST:PORT/NAME.tan.</source>
        <translation>«%1» non è l&apos;indirizzo di un server. Scriverlo come http://HOST:PORT/NAME.tan.</translation>
    </message>
    <message>
        <source>the server says that the file has %1, more than any model has. Check the address.</source>
        <translation>il server dice che il file ha %1, più di qualsiasi modello. Controllare l&apos;indirizzo.</translation>
    </message>
    <message>
        <source>it is not the address of a file. Write it as https://HOST/PATH, with spaces as %1.</source>
        <translation>non è l&apos;indirizzo di un file. Scriverlo come https://HOST/PERCORSO, e gli spazi come %1.</translation>
    </message>
    <message>
        <source>This TAn was built without OpenGL (TAN_GL). Use the CPU back end.</source>
        <translation>Questo TAn è stato compilato senza OpenGL (TAN_GL). Far disegnare il processore.</translation>
    </message>
    <message>
        <source>Cannot listen on port %1 of &apos;%2&apos;: %3. Choose another port with &apos;--port&apos;, or an address of this machine.</source>
        <translation>Impossibile mettersi in ascolto sulla porta %1 di «%2»: %3. Scegliere un&apos;altra porta con «--port», o un indirizzo di questo computer.</translation>
    </message>
    <message>
        <source>The system cannot start a thread for the server: %1. %2</source>
        <translation>Il sistema non può avviare un thread per il server: %1. %2</translation>
    </message>
    <message>
        <source>The system accepts no more connections: %1. %2</source>
        <translation>Il sistema non accetta altre connessioni: %1. %2</translation>
    </message>
    <message>
        <source>The file is being changed. Ask again.</source>
        <translation>Il file sta cambiando. Chiedere di nuovo.</translation>
    </message>
    <message>
        <source>The server cannot read its models now: %1. Ask again.</source>
        <translation>Il server ora non può cercare i suoi modelli: %1. Chiedere di nuovo.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be served: %2. Check its name.</source>
        <translation>La cartella «%1» non può essere servita: %2. Controllarne il nome.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another user, who could put any program there. Copy what you trust into a folder of your own.</source>
        <translation>«%1» appartiene a un altro utente, che potrebbe metterci qualsiasi programma. Copiare ciò di cui ci si fida in una cartella propria.</translation>
    </message>
    <message>
        <source>Every user of this machine can write to &apos;%1&apos;, and could put any program there. Remove that permission (chmod o-w), and check its content.</source>
        <translation>Ogni utente di questo computer può scrivere in «%1» e potrebbe metterci qualsiasi programma. Togliere questo permesso (chmod o-w), e controllare che cosa contiene.</translation>
    </message>
    <message>
        <source>the array &apos;%1&apos; is not a number anywhere: it cannot be computed from this solution. %2</source>
        <translation>il vettore «%1» non ha numeri da nessuna parte: non si può calcolare da questa soluzione. %2</translation>
    </message>
    <message>
        <source>The domain is different, so the camera keeps its direction and shows all of the model.</source>
        <translation>Il dominio è un altro, perciò la camera conserva la direzione e mostra tutto il modello.</translation>
    </message>
    <message>
        <source>The focus is off: it is not within the domain.</source>
        <translation>Il focus è disattivato: non è nel dominio.</translation>
    </message>
    <message>
        <source>The crop box is off: it is not within the domain.</source>
        <translation>La finestra è disattivata: non è nel dominio.</translation>
    </message>
    <message>
        <source>Nothing is clipped: the clip planes are for another domain.</source>
        <translation>Nulla viene tagliato: i piani di taglio sono per un altro dominio.</translation>
    </message>
    <message>
        <source>The film has no key frames: their cameras are for another domain.</source>
        <translation>Il filmato non ha fotogrammi chiave: le loro camere sono per un altro dominio.</translation>
    </message>
    <message>
        <source>None of the isovalues lies within the model&apos;s values, %1 to %2, so the default ones are shown.</source>
        <translation>Nessuno degli isovalori è fra i valori del modello, da %1 a %2, perciò si mostrano quelli consueti.</translation>
    </message>
    <message>
        <source>%1 of %2 isovalues are left out: they are not within the model&apos;s values, %3 to %4.</source>
        <translation>%1 di %2 isovalori sono omessi: non sono fra i valori del modello, da %3 a %4.</translation>
    </message>
    <message>
        <source>The transfer function has no point within the model&apos;s values, so the default one is shown.</source>
        <translation>La funzione di trasferimento non ha punti fra i valori del modello, perciò si mostra quella consueta.</translation>
    </message>
    <message>
        <source>All values are shown: the model has none of the selected ones.</source>
        <translation>Si mostrano tutti i valori: il modello non ha nessuno di quelli scelti.</translation>
    </message>
    <message>
        <source>There is no rendering mode &apos;%1&apos; here, so the model is shown as &apos;%2&apos;. It may belong to a plugin that is not installed.</source>
        <translation>Qui non c&apos;è una modalità di resa «%1», perciò si mostra come «%2». Forse appartiene a un plugin che non è installato.</translation>
    </message>
    <message>
        <source>The model &apos;%1&apos; has changed since the session was saved: it was rebuilt or replaced.</source>
        <translation>Il modello «%1» è cambiato da quando la sessione è stata salvata: è stato ricostruito o sostituito.</translation>
    </message>
    <message>
        <source>This file cannot be read as a transfer function. TAn reads its own and ParaView&apos;s presets in JSON, and ParaView&apos;s colour maps in XML, but not tables of colours.</source>
        <translation>Questo file non può essere letto come funzione di trasferimento. TAn legge le proprie e le preimpostazioni di ParaView in JSON, e le mappe di colori di ParaView in XML, ma non le tabelle di colori.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a surface. TAn reads volumes: values throughout a body, not only on its surface.</source>
        <translation>«%1» contiene una superficie. TAn legge volumi: valori ovunque in un corpo, non solo sulla sua pelle.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a picture. TAn reads volumes, including stacks of TIFF pictures, and opens pictures that it has saved with their session.</source>
        <translation>«%1» è un&apos;immagine. TAn legge volumi, fra cui pile di immagini TIFF, e apre le immagini che ha salvato con la loro sessione.</translation>
    </message>
    <message>
        <source>TAn reads files such as %1; the manual lists all of them. Samples alone, without a header, are read as a raw file.</source>
        <translation>TAn legge file come %1; il manuale li elenca tutti. I soli campioni, senza intestazione, si leggono come file grezzo.</translation>
    </message>
    <message>
        <source>What &apos;%1&apos; says of its model is impossible: %2. Tell its operator, or download the model and check it with &apos;tan verify&apos;.</source>
        <translation>Ciò che «%1» dice del suo modello è impossibile: %2. Avvisare chi gestisce il server, oppure scaricare il modello ed esaminarlo con «tan verify».</translation>
    </message>
    <message>
        <source>it has %1 sites</source>
        <translation>ha %1 siti</translation>
    </message>
    <message>
        <source>it has %1 tetrahedra</source>
        <translation>ha %1 tetraedri</translation>
    </message>
    <message>
        <source>it has %1 bytes</source>
        <translation>ha %1 byte</translation>
    </message>
    <message>
        <source>a mesh has %1 of its %2 sites</source>
        <translation>una mesh ha %1 dei suoi %2 siti</translation>
    </message>
    <message>
        <source>a mesh has %1 of its %2 tetrahedra</source>
        <translation>una mesh ha %1 dei suoi %2 tetraedri</translation>
    </message>
    <message>
        <source>a mesh has the error %1 % and the warping %2 %</source>
        <translation>una mesh ha l&apos;errore %1 % e la deformazione %2 %</translation>
    </message>
    <message>
        <source>a mesh with %1 sites comes before one with %2</source>
        <translation>una mesh con %1 siti precede una con %2</translation>
    </message>
    <message>
        <source>a mesh has %1 of %2 sites, and the model %3</source>
        <translation>una mesh ha %1 di %2 siti, e il modello %3</translation>
    </message>
    <message>
        <source>a mesh has %1 of %2 tetrahedra, and the model %3</source>
        <translation>una mesh ha %1 di %2 tetraedri, e il modello %3</translation>
    </message>
    <message>
        <source>a mesh keeps %1 times the error</source>
        <translation>una mesh mantiene %1 volte l&apos;errore</translation>
    </message>
    <message>
        <source>a tetrahedron exists at errors that are not numbers of at least 0</source>
        <translation>un tetraedro vive a errori che non sono numeri da 0 in su</translation>
    </message>
    <message>
        <source>the libcurl of this machine does not support what TAn needs (%1). Check the address and SSL_CERT_FILE, and install a libcurl with HTTPS, 7.85 or later.</source>
        <translation>la libcurl di questo computer non fa ciò che serve a TAn (%1). Controllare l&apos;indirizzo e SSL_CERT_FILE e installare una libcurl con HTTPS, 7.85 o successiva.</translation>
    </message>
    <message>
        <source>This TAn was built without the network (TAN_NETWORK), so it cannot open &apos;%1&apos;. Download the file and open the copy.</source>
        <translation>Questo TAn è compilato senza rete (TAN_NETWORK) e non può aprire «%1». Scaricare il file e aprire la copia.</translation>
    </message>
    <message>
        <source>a level of accuracy has no mesh of its own</source>
        <translation>un livello di accuratezza non ha una mesh propria</translation>
    </message>
    <message>
        <source>its three directions %1; %2; %3 lie in a plane, or are not of unit length, so that it has no volume. Give three that span one.</source>
        <translation>le sue tre direzioni %1; %2; %3 giacciono in un piano, o non hanno lunghezza 1, quindi non ha volume. Indicarne tre che ne generino uno.</translation>
    </message>
    <message>
        <source>it has a section &apos;%1&apos;, which only a regular lattice has</source>
        <translation>ha una sezione «%1», che solo un reticolo regolare ha</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: its section &apos;%2&apos; is invalid. Copy the file again, or build it again.</source>
        <translation>«%1» è danneggiato: la sua sezione «%2» non ha senso. Copiare di nuovo il file, o costruirlo di nuovo.</translation>
    </message>
    <message>
        <source>Copying the model</source>
        <translation>Copia del modello</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was built with weights at places (&apos;%2&apos;), which would then lie elsewhere than intended. Build it again from data that state where they lie.</source>
        <translation>«%1» è stato costruito con pesi in certi luoghi («%2»), che si troverebbero altrove da dove erano intesi. Costruirlo di nuovo da dati che dicono dove si trovano.</translation>
    </message>
    <message>
        <source>The model cannot be placed there: %1</source>
        <translation>Il modello non può trovarsi lì: %1</translation>
    </message>
    <message>
        <source>Not enough memory to copy the model. Close other programs.</source>
        <translation>La memoria non basta per copiare il modello. Chiudere altri programmi.</translation>
    </message>
    <message>
        <source>Measuring the deviation</source>
        <translation>Misura dello scostamento</translation>
    </message>
    <message>
        <source>One of the two surfaces is empty, so there is no distance.</source>
        <translation>Una delle due superfici è vuota, quindi non c&apos;è distanza.</translation>
    </message>
    <message>
        <source>Not enough memory to measure the deviation. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per misurare lo scostamento. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>its section &apos;%1&apos; is invalid</source>
        <translation>la sua sezione «%1» non ha senso</translation>
    </message>
    <message>
        <source>Closing the surface</source>
        <translation>Chiusura della superficie</translation>
    </message>
    <message>
        <source>The mesh has too many tetrahedra for its boundary to be found. Lower the accuracy of the mesh.</source>
        <translation>La mesh ha troppi tetraedri perché se ne trovi il contorno. Ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>Not enough memory to close the isosurface. Close other programs or lower the accuracy of the mesh.</source>
        <translation>La memoria non basta per chiudere l&apos;isosuperficie. Chiudere altri programmi o ridurre l&apos;accuratezza della mesh.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has coordinates in single precision, which cannot hold this surface: it is too large or too small. Write a .vtp or .ply file.</source>
        <translation>«%1» ha coordinate in precisione singola, che non possono contenere questa superficie: è troppo grande o troppo piccola. Scrivere un file .vtp o .ply.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: the program that reads it has ended. Look at its messages.</source>
        <translation>Impossibile scrivere «%1»: il programma che doveva leggerlo è terminato. Vedere che cosa dice quel programma.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2.</source>
        <translation>Impossibile scrivere «%1»: %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a second file next to &apos;%2&apos;. Give the output a name instead of &apos;-&apos;.</source>
        <translation>«%1» sarebbe un secondo file accanto a «%2». Dare all&apos;uscita un nome invece di «-».</translation>
    </message>
    <message>
        <source>&apos;data file: %1&apos; in its header %2</source>
        <translation>«data file: %1» nella sua intestazione %2</translation>
    </message>
    <message>
        <source>must end with the number of dimensions that each file holds, from 1 to %1, or without it.</source>
        <translation>deve terminare con il numero di dimensioni che ogni file contiene, da 1 a %1, o senza di esso.</translation>
    </message>
    <message>
        <source>must be a name with a number such as &apos;%03d&apos;, and the number of the first file, of the last, and the step.</source>
        <translation>deve essere un nome con un numero come «%03d», e i numeri del primo file, dell&apos;ultimo, e il passo.</translation>
    </message>
    <message>
        <source>names %1 files, which is not the number that its sizes require. Correct the numbers of the first and the last file.</source>
        <translation>nomina %1 file, che non è il numero richiesto dalle sue dimensioni. Correggere i numeri del primo e dell&apos;ultimo file.</translation>
    </message>
    <message>
        <source>is followed by the names of %1 files, which is not the number that its sizes require. Each is on a line of its own.</source>
        <translation>è seguito dai nomi di %1 file, che non è il numero richiesto dalle sue dimensioni. Ciascuno sta su una riga propria.</translation>
    </message>
    <message>
        <source>one of its axes, of size %1, is time. A volume has three axes in space: take out one time step.</source>
        <translation>uno dei suoi assi, di dimensione %1, corre nel tempo. Un volume ne ha tre nello spazio: estrarre un passo temporale.</translation>
    </message>
    <message>
        <source>Its header calls its orientation &apos;%1&apos;, but by its matrix it is &apos;%2&apos;. The matrix was used.</source>
        <translation>La sua intestazione chiama l&apos;orientamento «%1», che secondo la matrice è «%2». È stata usata la matrice.</translation>
    </message>
    <message>
        <source>its Direction is &apos;%1&apos; and not nine numbers.</source>
        <translation>la sua Direction è «%1» e non nove numeri.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; x, y and z are smaller than in the data by %2, %3 and %4, because single precision is too coarse so far from the origin; the first node of the file adds these numbers.</source>
        <translation>In «%1» x, y e z sono minori che nei dati di %2, %3 e %4, perché la precisione singola è troppo grossolana così lontano dall&apos;origine; il primo nodo del file aggiunge questi numeri.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; x, y and z are smaller than in the data by %2, %3 and %4, because single precision is too coarse so far from the origin: add these numbers to get places of the data.</source>
        <translation>In «%1» x, y e z sono minori che nei dati di %2, %3 e %4, perché la precisione singola è troppo grossolana così lontano dall&apos;origine: aggiungere questi numeri per ottenere luoghi dei dati.</translation>
    </message>
    <message>
        <source>The deviation is measured from the finest mesh, which stays at the server. Save without it, or download the model.</source>
        <translation>Lo scostamento si misura dalla mesh più fine, che rimane sul server. Salvare senza di esso, o scaricare il modello.</translation>
    </message>
    <message>
        <source>The deviation is that of whole surfaces. Show all values, and cut off what lies outside the crop box, or save without it.</source>
        <translation>Lo scostamento è quello di superfici intere. Mostrare tutti i valori, e tagliare ciò che sta fuori dalla finestra, o salvare senza di esso.</translation>
    </message>
    <message>
        <source>The tetrahedra of a range of errors overlap, so they make no solid. Show the mesh of one error.</source>
        <translation>Ciò che vive in un intervallo di errori si sovrappone, quindi non forma un solido. Mostrare la mesh di un solo errore.</translation>
    </message>
    <message>
        <source>Value %1: closed; parts: %2, area: %3, volume: %4.</source>
        <translation>Valore %1: chiusa; parti: %2, area: %3, volume: %4.</translation>
    </message>
    <message>
        <source>Value %1: open; openings: %2 (edges: %3), parts: %4, area: %5.</source>
        <translation>Valore %1: aperta; aperture: %2 (spigoli: %3), parti: %4, area: %5.</translation>
    </message>
    <message>
        <source>%1 More than two triangles meet at some edges: %2.</source>
        <translation>%1 Più di due triangoli si incontrano in alcuni spigoli: %2.</translation>
    </message>
    <message>
        <source>its %1 is &apos;%2&apos; and not %3 finite numbers.</source>
        <translation>il suo %1 è «%2» e non %3 numeri finiti.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Unità di lunghezza</translation>
    </message>
    <message>
        <source>Files that do not state it: the unit of coordinates, such as mm. It is displayed; nothing is converted.</source>
        <translation>File che non la indicano: l&apos;unità delle coordinate, come mm. Viene mostrata e non converte nulla.</translation>
    </message>
    <message>
        <source>The model is placed by the directions of its data, but its view was saved without them, because TAn up to version 0.1 read such data differently: its places were other ones. The camera shows all of it; choose regions again.</source>
        <translation>Il modello giace come dicono le direzioni dei suoi dati, ed era visto senza di esse, come TAn fino alla versione 0.1 leggeva tali dati: i suoi luoghi erano altri. La camera lo mostra tutto; scegliere di nuovo le regioni.</translation>
    </message>
    <message>
        <source>its origin %1 and spacing %2 are not finite, or too large or small to compute with. Check both.</source>
        <translation>la sua origine %1 e la sua spaziatura %2 non sono finite, o sono troppo grandi o piccole per calcolare. Controllare entrambe.</translation>
    </message>
    <message>
        <source>Files that do not state it, including raw ones: the distance between neighbouring points along x, y and z, as in 1x1x2.5; by default 1.</source>
        <translation>File che non la dicono, tra cui quelli grezzi: la distanza tra punti vicini lungo x, y e z, come in 1x1x2.5; altrimenti si suppone 1.</translation>
    </message>
    <message>
        <source>Files that do not state it: the position of the first point, as in 10,20,-5; by default 0.</source>
        <translation>File che non la dicono: la posizione del primo punto, come in 10,20,-5; altrimenti si suppone 0.</translation>
    </message>
    <message>
        <source>The file does not state its spacing: %1 is assumed. Give it with &apos;--spacing&apos; or in Import Options, or afterwards with &apos;tan set-frame&apos;.</source>
        <translation>Il file non indica la sua spaziatura: si suppone %1. La si indichi con «--spacing» o nelle opzioni di importazione, oppure in seguito con «tan set-frame».</translation>
    </message>
    <message>
        <source>names %1 files. Put the samples into fewer.</source>
        <translation>nomina %1 file. Mettere i campioni in un numero minore.</translation>
    </message>
    <message>
        <source>Its space &apos;%1&apos; is left-handed. Its coordinates are kept, and pictures and other programs treat them as right-handed: they show the mirror image.</source>
        <translation>Il suo spazio «%1» è sinistrorso. Le sue coordinate restano, e le immagini e gli altri programmi le prendono per destrorse: mostrano l&apos;immagine speculare.</translation>
    </message>
    <message>
        <source>Its units differ from axis to axis: %1. Its numbers were used as they are, without a unit.</source>
        <translation>Le sue unità cambiano da asse ad asse: %1. I suoi numeri sono stati presi come sono, senza unità.</translation>
    </message>
    <message>
        <source>Looking for openings</source>
        <translation>Ricerca di aperture</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; one triangle is left out, because two of its corners coincide in single precision.</source>
        <translation>In «%1» è omesso un triangolo, perché due dei suoi vertici sono uguali in precisione singola.</translation>
    </message>
    <message>
        <source>In &apos;%1&apos; %2 triangles are left out, because two corners of each coincide in single precision.</source>
        <translation>In «%1» sono omessi %2 triangoli, perché due vertici di ciascuno sono uguali in precisione singola.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not contain the triangles&apos; values (%2), because many programs cannot read a PLY file with such values. To keep them, write a .vtp file.</source>
        <translation>«%1» non ha i valori dei triangoli (%2), perché molti programmi non sanno leggere un file PLY con tali valori. Per conservarli, scrivere un file .vtp.</translation>
    </message>
    <message>
        <source>The finest mesh has the surface of %1 and this mesh does not, so no deviation is stated.</source>
        <translation>La mesh più fine ha la superficie di %1 e questa mesh no, perciò non si indica alcuno scostamento.</translation>
    </message>
    <message>
        <source>The finest mesh does not have the surface of %1, so no deviation is stated.</source>
        <translation>La mesh più fine non ha la superficie di %1, perciò non si indica alcuno scostamento.</translation>
    </message>
    <message>
        <source>Value %1: empty.</source>
        <translation>Valore %1: vuota.</translation>
    </message>
    <message>
        <source>%1 Deviation from the finest mesh, measured at many places: largest %2 (mean %3), and of that from this: largest %4 (mean %5).</source>
        <translation>%1 Scostamento dalla mesh più fine, misurato in molti punti: massimo %2 (medio %3), e di quella da questa: massimo %4 (medio %5).</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a model of a regular lattice: each of its points has its own position. Spacing, origin and unit can be set afterwards for a lattice only; for other data give &apos;--unit&apos; when you build the model.</source>
        <translation>«%1» non è il modello di un reticolo: i suoi punti giacciono dove dicono i dati, ciascuno per sé. Solo di un reticolo si possono impostare in seguito spaziatura, origine e unità; di altri dati si dia «--unit» alla costruzione del modello.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;%2&apos; is not understood. Give three numbers, along x, y and z, as in %3.</source>
        <translation>«%1» per «%2» non è comprensibile. Dare tre numeri, lungo x, y e z, come in %3.</translation>
    </message>
    <message>
        <source>it states its %1 itself. Leave &apos;--%1&apos; out; &apos;tan set-frame&apos; changes it in the model of a lattice.</source>
        <translation>dice da sé il suo valore di %1. Omettere «--%1»; «tan set-frame» ne dà un altro al modello di un reticolo.</translation>
    </message>
    <message>
        <source>1 polyhedron was cut into tetrahedra.</source>
        <translation>1 poliedro è stato suddiviso in tetraedri.</translation>
    </message>
    <message>
        <source>1 polyhedron was cut into tetrahedra around a point in its middle.</source>
        <translation>1 poliedro è stato suddiviso in tetraedri attorno a un punto al suo interno.</translation>
    </message>
    <message>
        <source>%1 polyhedra were cut into tetrahedra.</source>
        <translation>%1 poliedri sono stati suddivisi in tetraedri.</translation>
    </message>
    <message>
        <source>%1 polyhedra were cut into tetrahedra; %2 of them got a point in the middle.</source>
        <translation>%1 poliedri sono stati suddivisi in tetraedri; %2 di essi hanno ricevuto un punto al centro.</translation>
    </message>
    <message>
        <source>Polyhedra left out because no point in them sees all of their faces: %1.</source>
        <translation>Poliedri omessi perché nessun punto al loro interno ne vede tutte le facce: %1.</translation>
    </message>
    <message>
        <source>Polyhedra left out because no tetrahedra between their own points fill them: %1. With &apos;--polyhedra centre&apos; they get a point in the middle.</source>
        <translation>Poliedri omessi perché nessun insieme di tetraedri tra i loro punti li riempie: %1. Con «--polyhedra centre» ricevono un punto al centro.</translation>
    </message>
    <message>
        <source>Polyhedra left out because their faces do not enclose a volume: %1.</source>
        <translation>Poliedri omessi perché le loro facce non racchiudono un volume: %1.</translation>
    </message>
    <message>
        <source>The share of cells that may be faulty is %1; it must be from 0 to 1.</source>
        <translation>La quota di celle che possono essere difettose è %1; deve essere compresa tra 0 e 1.</translation>
    </message>
    <message>
        <source>Faces of polyhedra have more points than are listed (%1 in all, the first is of cell %2). The file is damaged.</source>
        <translation>Delle facce di poliedri hanno più punti di quanti ne siano nominati (%1 in tutto, la prima è della cella %2). Il file è danneggiato.</translation>
    </message>
    <message>
        <source>At least %1 of the mesh&apos;s %2 cells are faulty, more than %3. The first is cell %4 at (%5, %6, %7): %8. Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %9&apos;.</source>
        <translation>Almeno %1 delle %2 celle della mesh sono difettose, più di %3. La prima è la cella %4 in (%5, %6, %7): %8. Correggere la mesh nel programma che l&apos;ha creata, o consentire di omettere più celle, per esempio con «--faulty %9».</translation>
    </message>
    <message>
        <source>%1 cells are folded or so warped that no tetrahedra fill them, more than %2; the first is cell %3 at (%4, %5, %6). Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %7&apos;.</source>
        <translation>%1 celle sono ripiegate o così deformate che nessun insieme di tetraedri le riempie, più di %2; la prima è la cella %3 in (%4, %5, %6). Correggere la mesh nel programma che l&apos;ha creata, o consentire di omettere più celle, per esempio con «--faulty %7».</translation>
    </message>
    <message>
        <source>cell %1 at (%2, %3, %4)</source>
        <translation>cella %1 in (%2, %3, %4)</translation>
    </message>
    <message>
        <source>%1 of the mesh&apos;s %2 cells are polyhedra in which no point sees all of their faces, more than %3; the first is %4. Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %5&apos;.</source>
        <translation>%1 delle %2 celle della mesh sono poliedri in cui nessun punto vede tutte le facce, più di %3; la prima è %4. Correggere la mesh nel programma che l&apos;ha creata, o consentire di omettere più celle, per esempio con «--faulty %5».</translation>
    </message>
    <message>
        <source>%1 of the mesh&apos;s %2 cells are polyhedra that no tetrahedra between their own points fill, more than %3; the first is %4. With &apos;--polyhedra centre&apos; they get a point in the middle; with &apos;--faulty %5&apos; they are left out.</source>
        <translation>%1 delle %2 celle della mesh sono poliedri che nessun insieme di tetraedri tra i loro punti riempie, più di %3; la prima è %4. Con «--polyhedra centre» ricevono un punto al centro; con «--faulty %5» vengono omesse.</translation>
    </message>
    <message>
        <source>The faces of %1 of the mesh&apos;s %2 cells do not enclose a volume; the first is cell %3 at (%4, %5, %6). Repair the mesh in the program that made it, or allow more cells to be left out, as with &apos;--faulty %7&apos;.</source>
        <translation>Le facce di %1 delle %2 celle della mesh non racchiudono un volume; la prima è la cella %3 in (%4, %5, %6). Correggere la mesh nel programma che l&apos;ha creata, o consentire di omettere più celle, per esempio con «--faulty %7».</translation>
    </message>
    <message>
        <source>Joining the zones</source>
        <translation>Unione delle zone</translation>
    </message>
    <message>
        <source>The zone &apos;%1&apos; is not a structured grid with a value for each point.</source>
        <translation>La zona «%1» non è una griglia strutturata con un valore per ogni punto.</translation>
    </message>
    <message>
        <source>None of the zones has cells: a volume has at least two points along each of three axes.</source>
        <translation>Nessuna delle zone ha celle: un volume ha almeno due punti lungo ciascuno di tre assi.</translation>
    </message>
    <message>
        <source>The zones have %1 points; at most 4294967294 can be numbered. Take one zone.</source>
        <translation>Le zone hanno %1 punti; se ne possono numerare al massimo 4294967294. Prendere una sola zona.</translation>
    </message>
    <message>
        <source>The zones have %1 cells, whose mesh takes up to %2 of memory, of %3. Take one zone.</source>
        <translation>Le zone hanno %1 celle, la cui mesh occupa fino a %2 di memoria, su %3. Prendere una sola zona.</translation>
    </message>
    <message>
        <source>Its %1 zones were joined into one mesh, in which they share %2 faces.</source>
        <translation>Le sue %1 zone sono state unite in una sola mesh, in cui condividono %2 facce.</translation>
    </message>
    <message>
        <source>Its %1 zones were put into one mesh, in which no two of them share a face.</source>
        <translation>Le sue %1 zone sono state messe in una sola mesh, in cui non ce ne sono due che condividono una faccia.</translation>
    </message>
    <message>
        <source>Faces of zones that meet another zone with different points there: %1. The mesh has a seam there, and is not connected across it.</source>
        <translation>Facce di zone che poggiano su un&apos;altra zona i cui punti in quel luogo sono diversi: %1. La mesh ha lì una giuntura, attraverso la quale non è connessa.</translation>
    </message>
    <message>
        <source>Zones left out because they have no volume: %1.</source>
        <translation>Zone omesse perché non hanno volume: %1.</translation>
    </message>
    <message>
        <source>array</source>
        <translation>vettore</translation>
    </message>
    <message>
        <source>component</source>
        <translation>componente</translation>
    </message>
    <message>
        <source>places</source>
        <translation>posizioni</translation>
    </message>
    <message>
        <source>block</source>
        <translation>blocco</translation>
    </message>
    <message>
        <source>series</source>
        <translation>serie</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>canale</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>sistema di riferimento</translation>
    </message>
    <message>
        <source>unit of the values</source>
        <translation>unità dei valori</translation>
    </message>
    <message>
        <source>fill value</source>
        <translation>valore di riempimento</translation>
    </message>
    <message>
        <source>%1: %2 (a guess)</source>
        <translation>%1: %2 (supposto)</translation>
    </message>
    <message>
        <source>Faulty cells</source>
        <translation>Celle difettose</translation>
    </message>
    <message>
        <source>Meshes: the largest share of cells, or of their volume, that may be left out because they overlap others or are inverted, as in 5%; a mesh with more of them is refused.</source>
        <translation>Mesh: la quota massima di celle, o del loro volume, che si può omettere perché si sovrappongono ad altre o sono rovesciate, per esempio 5%; una mesh che ne ha di più viene rifiutata.</translation>
    </message>
    <message>
        <source>Give a share from 0% to 100%, as in 5%.</source>
        <translation>Indicare una quota da 0% a 100%, per esempio 5%.</translation>
    </message>
    <message>
        <source>Polyhedra</source>
        <translation>Poliedri</translation>
    </message>
    <message>
        <source>Meshes with polyhedra: &apos;corners&apos; cuts each into tetrahedra between its own points; &apos;centre&apos; adds a point in the middle of those that cannot be cut in that way.</source>
        <translation>Mesh con poliedri: «vertici» suddivide ciascuno in tetraedri tra i suoi punti; «centro» dà a quelli che così non si possono suddividere un punto al centro.</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>vertici</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;faulty&apos; is not understood. Give a share from 0% to 100%, as in 5%.</source>
        <translation>«%1» per «faulty» non è comprensibile. Indicare una quota da 0% a 100%, per esempio 5%.</translation>
    </message>
    <message>
        <source>a MINC volume</source>
        <translation>un volume MINC</translation>
    </message>
    <message>
        <source>Convert it to NIfTI, with &apos;mnc2nii&apos; of the MINC tools.</source>
        <translation>Convertirlo in NIfTI, con «mnc2nii» degli strumenti MINC.</translation>
    </message>
    <message>
        <source>a volume of FreeSurfer</source>
        <translation>un volume di FreeSurfer</translation>
    </message>
    <message>
        <source>Convert it to NIfTI, with &apos;mri_convert&apos; of FreeSurfer.</source>
        <translation>Convertirlo in NIfTI, con «mri_convert» di FreeSurfer.</translation>
    </message>
    <message>
        <source>an AVS field</source>
        <translation>un campo AVS</translation>
    </message>
    <message>
        <source>Save it as VTK or NRRD in a program that reads it, or write an NRRD header (.nhdr) that names the numbers of a uniform one as its data file.</source>
        <translation>Salvarlo come VTK o NRRD in un programma che lo legge, o scrivere un&apos;intestazione NRRD (.nhdr) che, se il campo è uniforme, ne nomini i numeri come file di dati.</translation>
    </message>
    <message>
        <source>an OpenVDB volume</source>
        <translation>un volume OpenVDB</translation>
    </message>
    <message>
        <source>Sample it on a regular grid, and save that as VTK, NRRD or a NumPy array.</source>
        <translation>Campionarlo su una griglia regolare, e salvarla come VTK, NRRD o array NumPy.</translation>
    </message>
    <message>
        <source>an Amira file</source>
        <translation>un file Amira</translation>
    </message>
    <message>
        <source>Export it from Amira as NRRD or VTK.</source>
        <translation>Esportarlo da Amira come NRRD o VTK.</translation>
    </message>
    <message>
        <source>a microscope&apos;s own file</source>
        <translation>un file nel formato proprio di un microscopio</translation>
    </message>
    <message>
        <source>Export it as OME-TIFF, with Fiji or the microscope&apos;s program.</source>
        <translation>Esportarlo come OME-TIFF, con Fiji o con il programma del microscopio.</translation>
    </message>
    <message>
        <source>By its name &apos;%1&apos; is %2, which TAn does not read. %3</source>
        <translation>A giudicare dal nome, «%1» è %2, che TAn non legge. %3</translation>
    </message>
    <message>
        <source>%1 needs more memory for it than the %2 that programs may use here. Raise the limit (ulimit -v).</source>
        <translation>%1 richiede per questo più memoria dei %2 che i programmi possono occupare qui. Alzare il limite (ulimit -v).</translation>
    </message>
    <message>
        <source>There is not enough memory, or there are not enough processes or open files, to start the %1 readers (%2). Close other programs, or raise the limit (ulimit).</source>
        <translation>Non ci sono memoria, processi o file aperti sufficienti per avviare i lettori %1 (%2). Chiudere altri programmi, o alzare il limite (ulimit).</translation>
    </message>
    <message>
        <source>The %1 readers are not installed. %2</source>
        <translation>I lettori %1 non sono installati. %2</translation>
    </message>
    <message>
        <source>The %1 readers cannot be started: &apos;%2&apos;: %3</source>
        <translation>I lettori %1 non si possono avviare: «%2»: %3</translation>
    </message>
    <message>
        <source>The %1 readers are not installed: %2. %3</source>
        <translation>I lettori %1 non sono installati: %2. %3</translation>
    </message>
    <message>
        <source>The %1 readers are not installed correctly: %2. %3</source>
        <translation>I lettori %1 sono installati male: %2. %3</translation>
    </message>
    <message>
        <source>the system ended %1, which happens when memory runs out. Close other programs, or take a part of the file.</source>
        <translation>il sistema ha terminato %1, come fa quando la memoria si esaurisce. Chiudere altri programmi, o prendere una parte del file.</translation>
    </message>
    <message>
        <source>%1 has waited for its disk for minutes. Check whether the disk answers, or copy the file to another one.</source>
        <translation>%1 attende il suo disco da minuti. Verificare se il disco risponde, o copiare il file su un altro.</translation>
    </message>
    <message>
        <source>%1 says: %2. It cannot be read.</source>
        <translation>%1 dice: %2. Il file non si può leggere.</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>modulo</translation>
    </message>
    <message>
        <source>quadratic-linear wedges</source>
        <translation>cunei quadratico-lineari</translation>
    </message>
    <message>
        <source>convex point sets</source>
        <translation>insiemi convessi di punti</translation>
    </message>
    <message>
        <source>Bezier tetrahedra</source>
        <translation>tetraedri di Bézier</translation>
    </message>
    <message>
        <source>Bezier hexahedra</source>
        <translation>esaedri di Bézier</translation>
    </message>
    <message>
        <source>Bezier wedges</source>
        <translation>cunei di Bézier</translation>
    </message>
    <message>
        <source>Bezier pyramids</source>
        <translation>piramidi di Bézier</translation>
    </message>
    <message>
        <source>the offsets of its faces are out of range.</source>
        <translation>gli offset delle sue facce sono fuori dall&apos;intervallo ammesso.</translation>
    </message>
    <message>
        <source>a cell has %1 points, and its shape needs %2.</source>
        <translation>una cella ha %1 punti, e la sua forma ne richiede %2.</translation>
    </message>
    <message>
        <source>the polyhedron %1 has no faces.</source>
        <translation>il poliedro %1 non ha facce.</translation>
    </message>
    <message>
        <source>the faces of the polyhedron %1 are damaged.</source>
        <translation>le facce del poliedro %1 sono danneggiate.</translation>
    </message>
    <message>
        <source>Nodes in the faces of quadratic cells were not used: in %1 cells.</source>
        <translation>I nodi nelle facce di celle quadratiche non sono stati usati: quelli di %1 celle.</translation>
    </message>
    <message>
        <source>For the Lagrange cells of order %1 (%2) only the corners were used, with straight edges.</source>
        <translation>Delle celle di Lagrange di ordine %1 (%2) sono stati usati solo i vertici, con spigoli rettilinei.</translation>
    </message>
    <message>
        <source>For the Lagrange cells whose order differs by direction (%1) only the corners were used, with straight edges.</source>
        <translation>Delle celle di Lagrange che non hanno lo stesso ordine in tutte le direzioni (%1) sono stati usati solo i vertici, con spigoli rettilinei.</translation>
    </message>
    <message>
        <source>It states the time %1.</source>
        <translation>Il file dichiara di riferirsi al tempo %1.</translation>
    </message>
    <message>
        <source>this TAn was built without GDCM, which reads DICOM. Rebuild it after &apos;apt install libgdcm-dev&apos;, or convert the file to NRRD.</source>
        <translation>questo TAn è stato compilato senza GDCM, che legge DICOM. Ricompilarlo dopo «apt install libgdcm-dev», o convertire il file in NRRD.</translation>
    </message>
    <message>
        <source>its number of frames is %1. It is damaged: copy the file again.</source>
        <translation>il suo numero di fotogrammi è %1. È danneggiato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>it has %1 frames and describes %2 of them. It is damaged: copy the file again.</source>
        <translation>ha %1 fotogrammi e ne descrive %2. È danneggiato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>the pieces of its packed pixels are damaged. Copy the file again.</source>
        <translation>i pezzi dei suoi pixel compressi sono danneggiati. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>temporal position</source>
        <translation>posizione temporale</translation>
    </message>
    <message>
        <source>echo</source>
        <translation>eco</translation>
    </message>
    <message>
        <source>diffusion weight</source>
        <translation>peso di diffusione</translation>
    </message>
    <message>
        <source>trigger time</source>
        <translation>tempo di trigger</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tempo</translation>
    </message>
    <message>
        <source>image type</source>
        <translation>tipo di immagine</translation>
    </message>
    <message>
        <source>acquisition</source>
        <translation>acquisizione</translation>
    </message>
    <message>
        <source>acquired at</source>
        <translation>ora di acquisizione</translation>
    </message>
    <message>
        <source>made at</source>
        <translation>ora di creazione</translation>
    </message>
    <message>
        <source>it cannot be read.</source>
        <translation>non si può leggere.</translation>
    </message>
    <message>
        <source>it is not a DICOM file, or ends too early. Copy the file again.</source>
        <translation>non è un file DICOM, o finisce troppo presto. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>Its slices are spaced unevenly, %1 to %2 mm apart; each was left where it lies.</source>
        <translation>I suoi strati sono disposti in modo irregolare, a distanze da %1 a %2 mm; ciascuno è stato lasciato dove si trova.</translation>
    </message>
    <message>
        <source>Missing after slice %1, between %2 and %3: %4.</source>
        <translation>Mancanti dopo lo strato %1, tra %2 e %3: %4.</translation>
    </message>
    <message>
        <source>slices %1 mm apart (%2)</source>
        <translation>strati a %1 mm di distanza (%2)</translation>
    </message>
    <message>
        <source>pixels %1 x %2 mm, as at the detector (ImagerPixelSpacing)</source>
        <translation>pixel di %1 x %2 mm, come sul rivelatore (ImagerPixelSpacing)</translation>
    </message>
    <message>
        <source>pixels 1 x 1 mm, because the file does not state their size</source>
        <translation>pixel di 1 x 1 mm, perché il file non ne indica la dimensione</translation>
    </message>
    <message>
        <source>some of its pixels are missing. Copy the file again.</source>
        <translation>i suoi pixel non ci sono tutti. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>GDCM cannot unpack its pixels (%1). They are damaged, or of a kind that it does not support: unpack them with the program that wrote them.</source>
        <translation>GDCM non riesce a decomprimere i suoi pixel (%1). Sono danneggiati, o di un genere che non conosce: decomprimerli con il programma che li ha scritti.</translation>
    </message>
    <message>
        <source>it is the table of contents of a disk (DICOMDIR). Open one of the pictures in the folders next to it.</source>
        <translation>è l&apos;indice di un disco (DICOMDIR). Aprire una delle immagini che si trovano nelle cartelle accanto ad esso.</translation>
    </message>
    <message>
        <source>it is a segmentation, whose pictures are outlines of objects, not numbers. Export it as NRRD, for instance with 3D Slicer.</source>
        <translation>è una segmentazione, le cui immagini sono contorni di oggetti e non numeri. Esportarla come NRRD, per esempio con 3D Slicer.</translation>
    </message>
    <message>
        <source>its pixels are floating-point numbers (FloatPixelData), which TAn does not read from DICOM files. Export it as NRRD, for instance with 3D Slicer.</source>
        <translation>i suoi pixel sono numeri in virgola mobile (FloatPixelData), che TAn non legge da file DICOM. Esportarlo come NRRD, per esempio con 3D Slicer.</translation>
    </message>
    <message>
        <source>it holds no picture (%1). If it should have one, it is cut short: copy it again. Otherwise open a picture of the series that it belongs to.</source>
        <translation>non contiene un&apos;immagine (%1). Se dovrebbe averne una, è troncato: copiarlo di nuovo. Altrimenti aprire un&apos;immagine della serie a cui appartiene.</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 immagini</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos; of its series: it is not a DICOM file, or ends too early. Copy the file again.</source>
        <translation>il file «%1» della sua serie: non è un file DICOM, o finisce troppo presto. Copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos; of its series: %2</source>
        <translation>il file «%1» della sua serie: %2</translation>
    </message>
    <message>
        <source>The file &apos;%1&apos; next to it was not read: %2</source>
        <translation>Il file «%1» accanto ad esso non è stato letto: %2</translation>
    </message>
    <message>
        <source>it has no rows or columns. The file is damaged: copy or export it again.</source>
        <translation>non ha righe o colonne. Il file è danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its pictures are in colour (%1), and TAn reads one value for each point. Export them in shades of grey.</source>
        <translation>le sue immagini sono a colori (%1), e TAn legge un solo valore per ogni punto. Esportarle in scala di grigi.</translation>
    </message>
    <message>
        <source>each of its pictures is a mosaic of slices (Siemens). Convert it to NIfTI with dcm2niix.</source>
        <translation>ciascuna delle sue immagini è un mosaico di strati (Siemens). Convertirlo in NIfTI con dcm2niix.</translation>
    </message>
    <message>
        <source>its pictures are frames of a film and not slices of a volume.</source>
        <translation>le sue immagini sono istanti di un filmato e non strati di un volume.</translation>
    </message>
    <message>
        <source>its pixels have %1 bits, and TAn reads those of 8, 16 and 32. Write them with 16.</source>
        <translation>i suoi pixel hanno %1 bit, e TAn legge quelli di 8, 16 e 32. Scriverli con 16.</translation>
    </message>
    <message>
        <source>it states that %1 of %2 bits of a pixel count, up to bit %3. The file is damaged: copy or export it again.</source>
        <translation>dichiara che contano %1 dei %2 bit di un pixel, fino al bit %3. Il file è danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>Its pictures are meant to be shown with small values bright (MONOCHROME1); the values are as the file has them.</source>
        <translation>Le sue immagini vanno mostrate con i valori piccoli chiari (MONOCHROME1); i valori sono come nel file.</translation>
    </message>
    <message>
        <source>Pixels outside the picture have the value %1 (PixelPaddingValue), and are treated as ordinary values.</source>
        <translation>I pixel fuori dall&apos;immagine hanno il valore %1 (PixelPaddingValue), e sono valori come gli altri.</translation>
    </message>
    <message>
        <source>It has a table (ModalityLUT) that converts stored numbers into values; the stored numbers are used.</source>
        <translation>Ha una tabella (ModalityLUT) che trasforma i numeri memorizzati in valori; si prendono i numeri memorizzati.</translation>
    </message>
    <message>
        <source>It states that its pictures were compressed with loss.</source>
        <translation>Dichiara che le sue immagini sono state compresse con perdita.</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 di %2: %3</translation>
    </message>
    <message>
        <source>Next to it is series %1: %2. Choose it with &apos;series&apos;.</source>
        <translation>Accanto ad esso si trova la serie %1: %2. Sceglierla con «series».</translation>
    </message>
    <message>
        <source>%1 more series are next to it.</source>
        <translation>Accanto ad esso si trovano altre %1 serie.</translation>
    </message>
    <message>
        <source>%1 pictures of the series have another size or direction, as overviews have, and were left out.</source>
        <translation>%1 immagini della serie hanno un&apos;altra dimensione o direzione, come le immagini panoramiche, e sono state omesse.</translation>
    </message>
    <message>
        <source>%1 files are copies of others, and were left out.</source>
        <translation>%1 file sono copie di altri, e sono stati omessi.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>its values are scaled beyond the range of numbers (RescaleSlope). The file is damaged: copy or export it again.</source>
        <translation>i suoi valori sono scalati oltre ogni numero rappresentabile (RescaleSlope). Il file è danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>%1 pictures of its series lie at one place, such as &apos;%2&apos; and &apos;%3&apos;, and nothing tells which of them belong together. Put the slices of one volume alone into a folder.</source>
        <translation>%1 immagini della sua serie si trovano nella stessa posizione, come «%2» e «%3», e nulla dice quali di esse vadano insieme. Mettere in una cartella solo gli strati di un volume.</translation>
    </message>
    <message>
        <source>number %1 of each place</source>
        <translation>numero %1 di ogni posizione</translation>
    </message>
    <message>
        <source>the file &apos;%1&apos; of its series does not say where it lies (ImagePositionPatient), and others do. Take it out of the folder, or export the series again.</source>
        <translation>il file «%1» della sua serie non dice dove si trova (ImagePositionPatient), mentre altri sì. Toglierlo dalla cartella, o esportare di nuovo la serie.</translation>
    </message>
    <message>
        <source>it is a single picture, and no other slices of its series are next to it. TAn reads volumes: put the files of the series into one folder and open one of them.</source>
        <translation>è una singola immagine, e accanto ad essa non ci sono altri strati della sua serie. TAn legge volumi: mettere i file della serie in una sola cartella e aprirne uno.</translation>
    </message>
    <message>
        <source>it is a single picture of another size or direction than the %1 slices of its series. Open one of these, such as &apos;%2&apos;.</source>
        <translation>è una singola immagine di dimensione o direzione diversa da quella dei %1 strati della sua serie. Aprire uno di questi, come «%2».</translation>
    </message>
    <message>
        <source>of another size or direction</source>
        <translation>di dimensione o direzione diversa</translation>
    </message>
    <message>
        <source>all pictures of its series lie at one place. TAn reads volumes: it needs slices.</source>
        <translation>tutte le immagini della sua serie si trovano nella stessa posizione. TAn legge volumi: gli servono strati.</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canale</translation>
    </message>
    <message>
        <source>Pictures with several channels: one of them, by name or number from 1; by default the first.</source>
        <translation>Di immagini con più canali: uno, con il nome o il numero da 1; se vuoto il primo.</translation>
    </message>
    <message>
        <source>Colour pictures: the number of one colour, from 0, or &apos;magnitude&apos;.</source>
        <translation>Di immagini a colori: il numero di un colore, da 0, o «magnitude».</translation>
    </message>
    <message>
        <source>Pictures at several times, or several volumes at one place: which one, from 1; 0 takes the first, or for DICOM files the one of the file.</source>
        <translation>Di immagini a più tempi, o di più volumi nella stessa posizione: quale, da 1; 0 prende il primo, e per file DICOM quello del file.</translation>
    </message>
    <message>
        <source>it is neither DICOM nor TIFF. Let TAn choose the reader.</source>
        <translation>non è né DICOM né TIFF. Lasciare a TAn la scelta della lettura.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libgdcm-dev libtiff-dev&apos;), or convert the file to NRRD.</source>
        <translation>Installare il pacchetto tan-vtk-readers, fornito con TAn: «apt install ./tan-vtk-readers_*.deb» dove si trova il file (se TAn è stato compilato in proprio: ricompilarlo dopo «apt install libgdcm-dev libtiff-dev»), o convertire il file in NRRD.</translation>
    </message>
    <message>
        <source>Install GDCM and libtiff with &apos;apt install libgdcm3.0 libtiff6&apos;.</source>
        <translation>Installare GDCM e libtiff con «apt install libgdcm3.0 libtiff6».</translation>
    </message>
    <message>
        <source>Export it again, or in another format (NRRD, NIfTI).</source>
        <translation>Esportarlo di nuovo, o in un altro formato (NRRD, NIfTI).</translation>
    </message>
    <message>
        <source>its OME description is not understood: %1. Export it again, or as NRRD.</source>
        <translation>la sua descrizione OME non è comprensibile: %1. Esportarlo di nuovo, o come NRRD.</translation>
    </message>
    <message>
        <source>it has %1 channels and describes %2</source>
        <translation>ha %1 canali e ne descrive %2</translation>
    </message>
    <message>
        <source>a plane lies beyond its %1 slices and %2 times</source>
        <translation>un piano sta oltre i suoi %1 strati e %2 tempi</translation>
    </message>
    <message>
        <source>it names a file of another folder, &apos;%1&apos;</source>
        <translation>nomina un file di un&apos;altra cartella, «%1»</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>it has no images; they may be in another file</source>
        <translation>non ha immagini; il file che le contiene può essere un altro</translation>
    </message>
    <message>
        <source>it has %1 images</source>
        <translation>ha %1 immagini</translation>
    </message>
    <message>
        <source>its image %1 has no pixels</source>
        <translation>la sua immagine %1 non ha pixel</translation>
    </message>
    <message>
        <source>it has %1 slices, channels or times</source>
        <translation>ha %1 strati, canali o tempi</translation>
    </message>
    <message>
        <source>it has more than %1 planes</source>
        <translation>ha più di %1 piani</translation>
    </message>
    <message>
        <source>its order of dimensions is &apos;%1&apos;</source>
        <translation>il suo ordine delle dimensioni è «%1»</translation>
    </message>
    <message>
        <source>this TAn was built without libtiff, which reads TIFF. Rebuild it after &apos;apt install libtiff-dev&apos;, or convert the file to NRRD.</source>
        <translation>questo TAn è compilato senza libtiff, che legge i file TIFF. Ricompilarlo dopo «apt install libtiff-dev», o convertire il file in NRRD.</translation>
    </message>
    <message>
        <source>libtiff says: %1. The file is damaged, or of a kind that libtiff does not support: copy or export it again.</source>
        <translation>libtiff segnala: %1. Il file è danneggiato, o di un tipo che libtiff non conosce: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it is divided into pieces of no size.</source>
        <translation>è diviso in pezzi di dimensione nulla.</translation>
    </message>
    <message>
        <source>its pieces have an impossible size.</source>
        <translation>i suoi pezzi hanno una dimensione impossibile.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;. Choose one from 1 to %3, or by its name.</source>
        <translation>non ha «%1» per «%2». Sceglierne uno da 1 a %3, oppure indicarne il nome.</translation>
    </message>
    <message>
        <source>It has %1 channels; the others are not read. Choose one with &apos;channel&apos;.</source>
        <translation>Ha %1 canali; gli altri non vengono letti. Sceglierne uno con «channel».</translation>
    </message>
    <message>
        <source>it holds one slice%1, and TAn reads volumes. Put the slices of one volume as numbered files into a folder, or as pages into one file.</source>
        <translation>contiene un solo strato%1, e TAn legge volumi. Mettere gli strati di un volume in una cartella come file numerati, o in un solo file come pagine.</translation>
    </message>
    <message>
        <source>its %1 times as slices</source>
        <translation>i suoi %1 tempi come strati</translation>
    </message>
    <message>
        <source>its OME description lists each plane many times. The file is damaged: export it again.</source>
        <translation>la sua descrizione OME nomina più volte ogni piano. Il file è danneggiato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its OME description does not tell where slice %1 is. Export the file again.</source>
        <translation>la sua descrizione OME non dice dove si trova lo strato %1. Esportare di nuovo il file.</translation>
    </message>
    <message>
        <source> of each of its %1 channels</source>
        <translation> di ciascuno dei suoi %1 canali</translation>
    </message>
    <message>
        <source>It holds %1 images; the others are not read. Choose one with &apos;series&apos;.</source>
        <translation>Contiene %1 immagini; le altre non vengono lette. Sceglierne una con «series».</translation>
    </message>
    <message>
        <source>ImageJ&apos;s description claims %1 slices, but some of their pixels are missing. It is cut short: copy the file again.</source>
        <translation>la descrizione di ImageJ dice che contiene %1 strati, ma i loro pixel non ci sono tutti. È troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>ImageJ&apos;s description lists %1 planes, and there are %2 pages; each is read as a slice.</source>
        <translation>La descrizione di ImageJ nomina %1 piani, ma le pagine sono %2; ciascuna viene presa come uno strato.</translation>
    </message>
    <message>
        <source>The numbers of its files, from %1 to %2, are not consecutive; the slices are taken to be evenly spaced.</source>
        <translation>I numeri dei suoi file, da %1 a %2, non sono consecutivi; si suppone che gli strati siano a distanze uguali.</translation>
    </message>
    <message>
        <source>Slices are missing among its numbered files: %1 (%2). The gaps stay, and values are interpolated over them.</source>
        <translation>Fra i suoi file numerati mancano degli strati: %1 (%2). Le lacune restano, e i valori vi vengono interpolati.</translation>
    </message>
    <message>
        <source>It has pages of its own; the %1 files next to it with the same kind of number are not read.</source>
        <translation>Ha più pagine proprie; i %1 file accanto, numerati come questo, non vengono letti.</translation>
    </message>
    <message>
        <source>its description refers to page %1, and it has %2. Export it again.</source>
        <translation>la sua descrizione nomina la pagina %1, ma ne ha %2. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>page %1 has another size or type than the first slice. The slices of one volume have one size.</source>
        <translation>la pagina %1 è di dimensione o tipo diversi dal primo strato. Gli strati di un volume hanno tutti la stessa dimensione.</translation>
    </message>
    <message>
        <source>its pixels have %1 components, and number %2 was requested. Choose one from 0 to %3, or &apos;magnitude&apos;.</source>
        <translation>i suoi pixel hanno %1 componenti, ed è stata chiesta la numero %2. Sceglierne una da 0 a %3, oppure «magnitude».</translation>
    </message>
    <message>
        <source>the magnitude of %1</source>
        <translation>il modulo di %1</translation>
    </message>
    <message>
        <source>%1 of 0 to %2</source>
        <translation>%1 (da 0 a %2)</translation>
    </message>
    <message>
        <source>Each pixel has %1 numbers, of which one value is made. Choose one with &apos;component&apos;.</source>
        <translation>Ogni pixel ha %1 numeri, da cui si ricava un solo valore. Sceglierne uno con «component».</translation>
    </message>
    <message>
        <source>its pixels are the numbers of colours in a palette. Convert it to shades of grey.</source>
        <translation>i suoi pixel sono i numeri dei colori di una tavolozza. Convertirlo in toni di grigio.</translation>
    </message>
    <message>
        <source>its colours are of a kind that TAn does not read (PhotometricInterpretation %1). Convert it to shades of grey.</source>
        <translation>i suoi colori sono di un tipo che TAn non legge (PhotometricInterpretation %1). Convertirlo in toni di grigio.</translation>
    </message>
    <message>
        <source>The colours of its palette are not used.</source>
        <translation>I colori della sua tavolozza non vengono usati.</translation>
    </message>
    <message>
        <source>Its pictures are meant to be shown with small values bright; the values are as the file has them.</source>
        <translation>Le sue immagini vanno mostrate con i valori piccoli chiari; i valori restano quelli del file.</translation>
    </message>
    <message>
        <source>its samples have %1 bits and the format %2 (SampleFormat), which TAn does not read. Write whole numbers or floating-point numbers of 32 bits.</source>
        <translation>i suoi campioni hanno %1 bit e il formato %2 (SampleFormat), che TAn non legge. Scrivere numeri interi o numeri in virgola mobile a 32 bit.</translation>
    </message>
    <message>
        <source>ImageJ&apos;s calibration of the values is not used: the stored values are.</source>
        <translation>La calibrazione dei valori di ImageJ non viene usata: i valori sono quelli memorizzati.</translation>
    </message>
    <message>
        <source>It states %1 pixels per inch, as pictures without a scale do; that is not used.</source>
        <translation>Dichiara %1 pixel per pollice, come fanno le immagini senza scala; il dato non viene usato.</translation>
    </message>
    <message>
        <source>slices 1 %1 apart, as ImageJ assumes without &apos;spacing&apos;</source>
        <translation>strati a distanza di 1 %1, come assume ImageJ senza «spacing»</translation>
    </message>
    <message>
        <source>slices as far apart as pixels, %1</source>
        <translation>strati distanti quanto i pixel, %1</translation>
    </message>
    <message>
        <source>%1 whole numbers of 64 bits were rounded to double precision.</source>
        <translation>%1 numeri interi a 64 bit sono stati arrotondati alla precisione doppia.</translation>
    </message>
    <message>
        <source>%1 of its pages are smaller copies of others, or masks.</source>
        <translation>%1 delle sue pagine sono copie ridotte di altre, o maschere.</translation>
    </message>
    <message>
        <source>Smaller copies of its pages (SubIFDs) are not read.</source>
        <translation>Le copie ridotte delle sue pagine (SubIFD) non vengono lette.</translation>
    </message>
    <message>
        <source>line %1 of its header, &apos;%2&apos;, is not &apos;KEY: value&apos;. Correct or remove it.</source>
        <translation>la riga %1 della sua intestazione, «%2», non è del tipo «KEY: value». Correggerla o toglierla.</translation>
    </message>
    <message>
        <source>its %1, &apos;%2&apos;, is not three numbers. Correct the line.</source>
        <translation>il suo campo %1, «%2», non è di tre numeri. Correggere la riga.</translation>
    </message>
    <message>
        <source>its header has no line &apos;%1:&apos;. Add it.</source>
        <translation>la sua intestazione non ha la riga «%1:». Aggiungerla.</translation>
    </message>
    <message>
        <source>its %1, &apos;%2&apos;, is not understood. Correct the line.</source>
        <translation>il suo campo %1, «%2», non è comprensibile. Correggere la riga.</translation>
    </message>
    <message>
        <source>The file does not state the byte order of its numbers: that of this computer was assumed.</source>
        <translation>Il file non indica l&apos;ordine dei byte dei suoi numeri: si è supposto quello di questo computer.</translation>
    </message>
    <message>
        <source>Its bytes from 0 to 255 were converted to the numbers from %1 to %2, as it states.</source>
        <translation>I suoi byte da 0 a 255 sono diventati i numeri da %1 a %2, come il file stesso indica.</translation>
    </message>
    <message>
        <source>the middles of the cells</source>
        <translation>i centri delle celle</translation>
    </message>
    <message>
        <source>the points</source>
        <translation>i punti</translation>
    </message>
    <message>
        <source>its data are divided among several files, &apos;%1&apos;. Join them into one, or save the volume from VisIt as VTK.</source>
        <translation>i suoi dati sono divisi fra più file, «%1». Riunirli in uno solo, o salvare il volume da VisIt come VTK.</translation>
    </message>
    <message>
        <source>its bricks repeat the values of their neighbours (HAS_BOUNDARY), which is not read. Save the volume from VisIt as VTK.</source>
        <translation>i suoi blocchi ripetono i valori dei blocchi vicini (HAS_BOUNDARY), cosa che non si legge. Salvare il volume da VisIt come VTK.</translation>
    </message>
    <message>
        <source>Its line &apos;%1: %2&apos; is not used.</source>
        <translation>La sua riga «%1: %2» non viene usata.</translation>
    </message>
    <message>
        <source>the number of atoms and the first point</source>
        <translation>il numero di atomi e il primo punto</translation>
    </message>
    <message>
        <source>a number of points and the step between them</source>
        <translation>un numero di punti e il passo fra di essi</translation>
    </message>
    <message>
        <source>it ends in its header, after line %1. It is cut short.</source>
        <translation>finisce nell&apos;intestazione, dopo la riga %1. È troncato.</translation>
    </message>
    <message>
        <source>line %1 of it is not %2, which a Gaussian cube has there. Correct the line, or write the file again.</source>
        <translation>la sua riga %1 non contiene %2, come è d&apos;obbligo lì in un file cube di Gaussian. Correggere la riga, o scrivere di nuovo il file.</translation>
    </message>
    <message>
        <source>an atom (its number, charge and position)</source>
        <translation>un atomo (numero, carica e posizione)</translation>
    </message>
    <message>
        <source>its number of atoms is negative, and no list of orbitals follows the atoms. Correct it, or write the file again.</source>
        <translation>il suo numero di atomi è negativo, ma agli atomi non segue un elenco di orbitali. Correggerlo, o scrivere di nuovo il file.</translation>
    </message>
    <message>
        <source>the list after its atoms does not have the numbers of %1 orbitals. Correct it, or write the file again.</source>
        <translation>l&apos;elenco dopo i suoi atomi non ha i numeri di %1 orbitali. Correggerlo, o scrivere di nuovo il file.</translation>
    </message>
    <message>
        <source>line 3 of it ends with &apos;%1&apos;, where a number of values at each point is expected. Correct it, or leave it out.</source>
        <translation>la sua riga 3 finisce con «%1», dove si vuole il numero di valori in ogni punto. Correggerlo, o ometterlo.</translation>
    </message>
    <message>
        <source>its numbers of points are negative along some axes, as if some steps were in angstrom and others in bohr. Make all of them positive or all negative.</source>
        <translation>i suoi numeri di punti sono negativi lungo alcuni assi, come se alcuni passi fossero in angstrom e altri in bohr. Renderli tutti positivi o tutti negativi.</translation>
    </message>
    <message>
        <source>It names 1 atom, which is not shown.</source>
        <translation>Nomina 1 atomo, che non viene mostrato.</translation>
    </message>
    <message>
        <source>It names %1 atoms, which are not shown.</source>
        <translation>Nomina %1 atomi, che non vengono mostrati.</translation>
    </message>
    <message>
        <source>its header requires %1 values at each point, and at most %2 are read. Write fewer orbitals into a file.</source>
        <translation>la sua intestazione chiede %1 valori in ogni punto, e se ne leggono al massimo %2. Scrivere meno orbitali in un file.</translation>
    </message>
    <message>
        <source>It holds %1 values at each point; the others are not read.</source>
        <translation>Contiene %1 valori in ogni punto; gli altri non vengono letti.</translation>
    </message>
    <message>
        <source>it is a table of colours for pictures, which has the same ending as Gaussian cubes. It holds no volume.</source>
        <translation>è una tabella di colori per immagini, che ha la stessa estensione dei file cube di Gaussian. Non contiene un volume.</translation>
    </message>
    <message>
        <source>its values have no positions in it. Export a field with its positions, all in one file.</source>
        <translation>i suoi valori vi stanno senza posizioni. Esportare un campo con le sue posizioni, tutto in un solo file.</translation>
    </message>
    <message>
        <source>its positions are of the class &apos;%1&apos;, and only &apos;gridpositions&apos; are read, a regular grid. Resample the field on a regular grid, or export its points as a table or its cells as .vtu.</source>
        <translation>le sue posizioni sono della classe «%1», e si legge solo «gridpositions», una griglia regolare. Ricampionare il campo su una griglia regolare, o esportarne i punti come tabella o le celle come .vtu.</translation>
    </message>
    <message>
        <source>the number of dimensions of its grid is %1, and a volume has three. Export a field of three.</source>
        <translation>il numero di dimensioni della sua griglia è %1, e un volume ne ha tre. Esportare un campo con tre dimensioni.</translation>
    </message>
    <message>
        <source>its &apos;gridpositions&apos; do not have one &apos;origin&apos; and three &apos;delta&apos; of three numbers each. Correct them.</source>
        <translation>il suo «gridpositions» non ha un solo «origin» e tre «delta», ciascuno di tre numeri. Correggerli.</translation>
    </message>
    <message>
        <source>its array has %1 items, and its grid %2 points. Correct the numbers, or export it again.</source>
        <translation>il suo array ha %1 elementi, e la sua griglia %2 punti. Correggere i numeri, o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its values are of the type &apos;%1&apos;, which is not read. Export real numbers.</source>
        <translation>i suoi valori sono di tipo «%1», che non si legge. Esportare numeri reali.</translation>
    </message>
    <message>
        <source>its array does not state where its data are. Export it again.</source>
        <translation>il suo array non dice dove stanno i suoi dati. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has no OpenDX field with data in it. Export one field with its positions and data, all in one file.</source>
        <translation>non ha un campo OpenDX che contenga dati. Esportare un solo campo con le sue posizioni e i suoi dati, tutto in un solo file.</translation>
    </message>
    <message>
        <source>It holds %1 fields; the others are not read.</source>
        <translation>Contiene %1 campi; gli altri non vengono letti.</translation>
    </message>
    <message>
        <source>it is not understood as an OpenDX file: %1. Write it again as one field with regular positions.</source>
        <translation>non è comprensibile come file OpenDX: %1. Scriverlo di nuovo come un solo campo con posizioni regolari.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; after &apos;%2&apos; is not a whole number</source>
        <translation>«%1» dopo «%2» non è un numero intero</translation>
    </message>
    <message>
        <source>no name follows &apos;data file&apos;</source>
        <translation>dopo «data file» non segue un nome</translation>
    </message>
    <message>
        <source>&apos;%1&apos; after &apos;data&apos; is not a position</source>
        <translation>«%1» dopo «data» non indica una posizione</translation>
    </message>
    <message>
        <source>an array has rank %1, and its shape %2 numbers</source>
        <translation>un array ha rango %1, e la sua forma %2 numeri</translation>
    </message>
    <message>
        <source>it has more than %1 objects</source>
        <translation>ha più di %1 oggetti</translation>
    </message>
    <message>
        <source>an object has more than %1 words</source>
        <translation>un oggetto ha più di %1 parole</translation>
    </message>
    <message>
        <source>an array of it should have %1 items, and the file ends before. It is cut short, or the number is wrong.</source>
        <translation>un suo array dovrebbe avere %1 elementi, ma il file finisce prima. È troncato, o il numero è sbagliato.</translation>
    </message>
    <message>
        <source>&apos;--%1&apos; selects among several volumes or components, and &apos;%2&apos; has one number for each point. Leave it out.</source>
        <translation>«--%1» sceglie fra più volumi o componenti, e «%2» ha un solo numero per ogni punto. Ometterlo.</translation>
    </message>
    <message>
        <source>NIfTI (*.nii *.hdr)</source>
        <translation>NIfTI (*.nii *.hdr)</translation>
    </message>
    <message>
        <source>MRC and CCP4 maps (*.mrc *.ccp4 *.map)</source>
        <translation>Mappe MRC e CCP4 (*.mrc *.ccp4 *.map)</translation>
    </message>
    <message>
        <source>its header names %1 files. Put the samples into fewer.</source>
        <translation>la sua intestazione nomina %1 file. Mettere i campioni in un numero minore di file.</translation>
    </message>
    <message>
        <source>its matrix turns space into its further axes. Write one volume of it.</source>
        <translation>la sua matrice ruota lo spazio nei suoi assi ulteriori. Scriverne un solo volume.</translation>
    </message>
    <message>
        <source>Its header gives the same quantity under two names, with different values: %1 was used, and %2 (%3) was not.</source>
        <translation>La sua intestazione indica la stessa cosa con due nomi, in modo diverso: è stato preso %1, e non %2 (%3).</translation>
    </message>
    <message>
        <source>it holds no image: its ObjectType is &apos;%1&apos;. TAn reads only images of this format.</source>
        <translation>non contiene un&apos;immagine: il suo ObjectType è «%1». Di questo formato TAn legge solo immagini.</translation>
    </message>
    <message>
        <source>it has %1 dimensions, and a volume has three. Write its pictures as one volume, or a part of it with three.</source>
        <translation>ha %1 dimensioni, e un volume ne ha tre. Scrivere le sue immagini come un solo volume, o una sua parte che ne ha tre.</translation>
    </message>
    <message>
        <source>Its header does not state the byte order of its numbers: that of this machine was assumed, %1 endian.</source>
        <translation>La sua intestazione non dice in quale ordine stanno i byte di un numero: è stato preso quello di questo computer, %1 endian.</translation>
    </message>
    <message>
        <source>Its header states how intensities follow from samples (times %1, plus %2), which was not applied.</source>
        <translation>La sua intestazione dice come le intensità si ricavano dai campioni (moltiplicare per %1, aggiungere %2), cosa che non è stata applicata.</translation>
    </message>
    <message>
        <source>Its CenterOfRotation was not used: a sample lies at Offset plus its directions times its distances, as in ITK.</source>
        <translation>Il suo CenterOfRotation non è stato usato: un campione sta in Offset più le direzioni per le distanze, come in ITK.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and the header of a map alone has %2. It is cut short, or not a map: copy the file again.</source>
        <translation>ha %1 byte, e la sola intestazione di una mappa ne ha %2. Non è una mappa, o è troncato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>Its cell angles are %1, which no cell has; right angles were used.</source>
        <translation>Gli angoli della sua cella sono %1, che nessuna cella ha; sono stati presi angoli retti.</translation>
    </message>
    <message>
        <source>Its header states that its columns, rows and sections run along the axes %1, %2 and %3, which is impossible; x, y and z were used.</source>
        <translation>La sua intestazione dice che colonne, righe e sezioni corrono lungo gli assi %1, %2 e %3, il che è impossibile; sono stati presi x, y e z.</translation>
    </message>
    <message>
        <source>Its ORIGIN is not a finite number and was not used.</source>
        <translation>Il suo ORIGIN non è un numero finito e non è stato usato.</translation>
    </message>
    <message>
        <source>By its NXSTART, NYSTART and NZSTART (%1) the first sample would lie at %2; its ORIGIN was used.</source>
        <translation>Secondo NXSTART, NYSTART e NZSTART (%1) il primo campione starebbe in %2; è stato preso il suo ORIGIN.</translation>
    </message>
    <message>
        <source>IMOD wrote it without the flag that its ORIGIN has the usual sign: the first sample may lie at the negative of it.</source>
        <translation>IMOD lo ha scritto senza l&apos;indicatore che il suo ORIGIN ha il segno usuale: il primo campione può stare nel suo opposto.</translation>
    </message>
    <message>
        <source>Its header has a matrix that turns the map (LSKFLG), which was not used.</source>
        <translation>La sua intestazione ha una matrice che ruota la mappa (LSKFLG), che non è stata usata.</translation>
    </message>
    <message>
        <source>Its bytes were read as unsigned, from 0 to 255, as IMOD&apos;s flag states.</source>
        <translation>I suoi byte sono stati presi senza segno, da 0 a 255, come dice l&apos;indicatore di IMOD.</translation>
    </message>
    <message>
        <source>Its bytes were read as unsigned, from 0 to 255, because its header states that the largest value is %1.</source>
        <translation>I suoi byte sono stati presi senza segno, da 0 a 255, perché la sua intestazione dice che il valore massimo è %1.</translation>
    </message>
    <message>
        <source>its samples have four bits each (mode 101), which is not read. Write it with bytes (mode 0), for instance with IMOD&apos;s &apos;newstack -mode 0&apos;.</source>
        <translation>i suoi campioni hanno quattro bit ciascuno (modo 101), cosa che non si legge. Scriverlo con byte (modo 0), per esempio con «newstack -mode 0» di IMOD.</translation>
    </message>
    <message>
        <source>its samples are of mode %1, which is not read. Write it with mode 2 (floating point).</source>
        <translation>i suoi campioni sono di modo %1, che non si legge. Scriverlo con il modo 2 (virgola mobile).</translation>
    </message>
    <message>
        <source>Its samples are complex numbers (mode %1), as of a Fourier transform: their places are not those of a body.</source>
        <translation>I suoi campioni sono numeri complessi (modo %1), come di una trasformata di Fourier: le loro posizioni non sono quelle di un corpo.</translation>
    </message>
    <message>
        <source>The machine stamp of its header does not state the byte order: the one in which its numbers are plausible was used, %1 endian.</source>
        <translation>Il contrassegno del computer (machine stamp) nella sua intestazione non dice in quale ordine stanno i byte: è stato preso quello in cui i numeri hanno senso, %1 endian.</translation>
    </message>
    <message>
        <source>Its header states that it is a stack of %1 pictures and not a volume (space group 0, MZ 1); it was read as a volume.</source>
        <translation>La sua intestazione dice che è una pila di %1 immagini e non un volume (gruppo spaziale 0, MZ 1); è stato letto come volume.</translation>
    </message>
    <message>
        <source>its header claims %1 x %2 x %3 points, after an extension of %4 bytes. It is damaged, or not a map: copy or export it again.</source>
        <translation>la sua intestazione dice che ha %1 x %2 x %3 punti, dopo un&apos;estensione di %4 byte. È danneggiato, o non è una mappa: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it does not begin like a header of NIfTI or Analyze 7.5. It is of another format, or damaged.</source>
        <translation>non comincia come le intestazioni di NIfTI e Analyze 7.5. È di un altro formato, o danneggiato.</translation>
    </message>
    <message>
        <source>it has %1 bytes, and a header of NIfTI has %2. It is cut short, or of another format: copy the file again.</source>
        <translation>ha %1 byte, e un&apos;intestazione NIfTI ne ha %2. È troncato, o di un altro formato: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>sconosciute</translation>
    </message>
    <message>
        <source>of the scanner</source>
        <translation>dello scanner</translation>
    </message>
    <message>
        <source>aligned to another scan</source>
        <translation>allineate a un&apos;altra scansione</translation>
    </message>
    <message>
        <source>of Talairach</source>
        <translation>di Talairach</translation>
    </message>
    <message>
        <source>of MNI 152</source>
        <translation>di MNI 152</translation>
    </message>
    <message>
        <source>of a template</source>
        <translation>di un modello di riferimento</translation>
    </message>
    <message>
        <source>Its qform would place it elsewhere, mirrored and up to %1 away; it was not used.</source>
        <translation>La sua qform lo collocherebbe altrove, specchiato e a una distanza fino a %1; non è stata usata.</translation>
    </message>
    <message>
        <source>Its qform would place it elsewhere, up to %1 away; it was not used.</source>
        <translation>La sua qform lo collocherebbe altrove, a una distanza fino a %1; non è stata usata.</translation>
    </message>
    <message>
        <source>Its pixdim states that samples are %1 x %2 x %3 apart, which was not used.</source>
        <translation>Il suo pixdim dice che i campioni distano %1 x %2 x %3, cosa che non è stata usata.</translation>
    </message>
    <message>
        <source>distances alone (pixdim)</source>
        <translation>solo le distanze (pixdim)</translation>
    </message>
    <message>
        <source>Its header states neither where it lies nor which side of it is the left one: it has no sform and no qform.</source>
        <translation>La sua intestazione non dice né dove si trova né quale lato è il sinistro: non ha né sform né qform.</translation>
    </message>
    <message>
        <source>distances, and the origin as SPM writes it</source>
        <translation>le distanze, e l&apos;origine come la scrive SPM</translation>
    </message>
    <message>
        <source>Its header, of Analyze 7.5, does not state which side of it is the left one. Convert it to NIfTI with a program that knows where it comes from.</source>
        <translation>La sua intestazione, di Analyze 7.5, non dice quale lato è il sinistro. Convertirlo in NIfTI con un programma che ne conosca la provenienza.</translation>
    </message>
    <message>
        <source>Its code for the orientation, %1, was not used.</source>
        <translation>Il suo codice per l&apos;orientamento, %1, non è stato usato.</translation>
    </message>
    <message>
        <source>Its sform is unusable (its steps lie in a plane, or are not finite numbers); it was not used.</source>
        <translation>La sua sform non porta da nessuna parte (i suoi passi stanno in un piano, o non sono numeri finiti); non è stata usata.</translation>
    </message>
    <message>
        <source>Its qform is unusable (its numbers are not finite, or too large or small); it was not used.</source>
        <translation>La sua qform non porta da nessuna parte (i suoi numeri non sono finiti, o sono troppo grandi o piccoli); non è stata usata.</translation>
    </message>
    <message>
        <source>sform, coordinates %1</source>
        <translation>sform, coordinate %1</translation>
    </message>
    <message>
        <source>qform, coordinates %1</source>
        <translation>qform, coordinate %1</translation>
    </message>
    <message>
        <source>its samples are floating-point numbers of 128 bits, which are not read: their layout differs from machine to machine. Write them with 64 bits.</source>
        <translation>i suoi campioni sono numeri in virgola mobile a 128 bit, che non si leggono: il loro significato cambia da computer a computer. Scriverli a 64 bit.</translation>
    </message>
    <message>
        <source>its samples are single bits, which are not read. Write them as bytes.</source>
        <translation>i suoi campioni sono singoli bit, che non si leggono. Scriverli come byte.</translation>
    </message>
    <message>
        <source>its samples are of the type %1, which NIfTI does not define. The file is damaged: copy or export it again.</source>
        <translation>i suoi campioni sono di tipo %1, che NIfTI non conosce. Il file è danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its header claims %1 dimensions. It is damaged: copy or export it again.</source>
        <translation>la sua intestazione dice che ha %1 dimensioni. È danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its header claims %1 points along its dimension %2. It is damaged: copy or export it again.</source>
        <translation>la sua intestazione dice che ha %1 punti lungo la dimensione %2. È danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>It holds %1 times as many samples along its last dimensions; the first were read.</source>
        <translation>Contiene %1 volte tanti campioni lungo le ultime dimensioni; sono stati letti i primi.</translation>
    </message>
    <message>
        <source>The samples were multiplied by %1, which SPM stores in the header&apos;s first unused field.</source>
        <translation>I campioni sono stati moltiplicati per %1, come SPM intende con il primo campo inutilizzato dell&apos;intestazione.</translation>
    </message>
    <message>
        <source>The samples were multiplied by %1, and %2 was added, as the header of the file requires.</source>
        <translation>I campioni sono stati moltiplicati per %1, e si è aggiunto %2, come chiede l&apos;intestazione del file.</translation>
    </message>
    <message>
        <source>its header states that its samples begin at byte %1, which is impossible. It is damaged: copy or export it again.</source>
        <translation>la sua intestazione dice che i campioni cominciano al byte %1, dove non possono stare. È danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its samples are in a file &apos;%1&apos;, which is missing. Copy it into the same folder: the two belong together.</source>
        <translation>i suoi campioni stanno in un file «%1», che manca. Copiarlo nella cartella di questo: i due vanno insieme.</translation>
    </message>
    <message>
        <source>its header is not that of a NumPy array: %1. Save the array again with numpy.save().</source>
        <translation>la sua intestazione non è quella di un array NumPy: %1. Salvare di nuovo l&apos;array con numpy.save().</translation>
    </message>
    <message>
        <source>it has no dictionary</source>
        <translation>non ha un dizionario</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood</source>
        <translation>«%1» non è comprensibile</translation>
    </message>
    <message>
        <source>&apos;descr&apos;, &apos;fortran_order&apos; or &apos;shape&apos; is missing</source>
        <translation>manca «descr», «fortran_order» o «shape»</translation>
    </message>
    <message>
        <source>its first bytes are different</source>
        <translation>i suoi primi byte sono altri</translation>
    </message>
    <message>
        <source>it has version %1 of NumPy&apos;s format, and versions 1 to 3 are read. Save it again with numpy.save() of an earlier NumPy.</source>
        <translation>ha la versione %1 del formato di NumPy, e si leggono le versioni da 1 a 3. Salvarlo di nuovo con numpy.save() di un NumPy meno recente.</translation>
    </message>
    <message>
        <source>it is cut short</source>
        <translation>ne manca la fine</translation>
    </message>
    <message>
        <source>its elements are records of several fields. Save one field on its own: numpy.save(name, array[&apos;field&apos;]).</source>
        <translation>i suoi elementi sono record di più campi. Salvare un solo campo: numpy.save(name, array[&apos;field&apos;]).</translation>
    </message>
    <message>
        <source>its elements are Python objects, which only Python can read. Save an array of numbers: array.astype(&apos;float32&apos;).</source>
        <translation>i suoi elementi sono oggetti di Python, che solo Python sa leggere. Salvare un array di numeri: array.astype(&apos;float32&apos;).</translation>
    </message>
    <message>
        <source>its elements have the type &apos;%1&apos;, which is not read. Save numbers of a usual type: array.astype(&apos;float64&apos;).</source>
        <translation>i suoi elementi sono di tipo «%1», che non si legge. Salvare numeri di un tipo usuale: array.astype(&apos;float64&apos;).</translation>
    </message>
    <message>
        <source>its array has the shape (%1), and a volume needs three dimensions of more than one element. Save a part that has them, such as array[0] or array[..., 0].</source>
        <translation>il suo array ha la forma (%1), e un volume richiede tre dimensioni di più di un elemento. Salvarne una parte che le ha, come array[0] o array[..., 0].</translation>
    </message>
    <message>
        <source>axes z, y, x: the last one runs fastest</source>
        <translation>assi z, y, x: l&apos;ultimo varia più in fretta</translation>
    </message>
    <message>
        <source>space directions</source>
        <translation>space directions</translation>
    </message>
    <message>
        <source>Its samples stand for numbers from %1 to %2 (&apos;old min&apos;, &apos;old max&apos;), from which they were quantized; they are used as stored.</source>
        <translation>I suoi campioni rappresentano numeri da %1 a %2 («old min», «old max»), da cui sono stati quantizzati; vengono presi come sono memorizzati.</translation>
    </message>
    <message>
        <source>Its spacings and the ends of its axes are not used: its space directions state where it lies.</source>
        <translation>Le sue spaziature e gli estremi dei suoi assi non vengono usati: le sue «space directions» dicono dove si trova.</translation>
    </message>
    <message>
        <source>its samples are of a type that has 4 bytes by the format, and there are %1 bytes for %2 samples: as many as for a type of 8 bytes. Write them as MET_INT or MET_LONG_LONG.</source>
        <translation>i suoi campioni sono di un tipo che secondo il formato ha 4 byte, ma ci sono %1 byte per %2 campioni: quanti ne richiede un tipo di 8 byte. Scriverli come MET_INT o MET_LONG_LONG.</translation>
    </message>
    <message>
        <source>%1 bytes after its samples were not read.</source>
        <translation>%1 byte dopo i suoi campioni non sono stati letti.</translation>
    </message>
    <message>
        <source>its header requires more samples than any file holds. It is damaged: copy or export it again.</source>
        <translation>la sua intestazione chiede più campioni di quanti un file possa contenerne. È danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has one time step, and number %1 was requested. Leave &apos;--time&apos; out.</source>
        <translation>ha un solo passo temporale, ed è stato chiesto il numero %1. Omettere «--time».</translation>
    </message>
    <message>
        <source>it has %1 time steps, and number %2 was requested. Give one from 1 to %1.</source>
        <translation>ha %1 passi temporali, ed è stato chiesto il numero %2. Indicarne uno da 1 a %1.</translation>
    </message>
    <message>
        <source>%1 of %2, time %3</source>
        <translation>%1 di %2, tempo %3</translation>
    </message>
    <message>
        <source>It holds %1 volumes; the others are not read.</source>
        <translation>Contiene %1 volumi; gli altri non vengono letti.</translation>
    </message>
    <message>
        <source>it has one number for each sample, and component &apos;%1&apos; was requested. Leave &apos;--component&apos; out.</source>
        <translation>ha un solo numero per ogni campione, ed è stata chiesta la componente «%1». Omettere «--component».</translation>
    </message>
    <message>
        <source>it has no component &apos;%1&apos;. Choose one from 0 to %2, or &apos;magnitude&apos;.</source>
        <translation>non ha una componente «%1». Sceglierne una da 0 a %2, oppure «magnitude».</translation>
    </message>
    <message>
        <source>magnitude of %1</source>
        <translation>modulo di %1</translation>
    </message>
    <message>
        <source>%1 of %2, counted from 0</source>
        <translation>%1 di %2, contando da 0</translation>
    </message>
    <message>
        <source>Each sample has %1 components; the others are not read.</source>
        <translation>Ogni campione ha %1 componenti; le altre non vengono lette.</translation>
    </message>
    <message>
        <source>%1 ...</source>
        <translation>%1 ...</translation>
    </message>
    <message>
        <source>Files with several sets of values (Gaussian cube, OpenDX): one of them, by name or by number from 1; by default the first.</source>
        <translation>File con più insiemi di valori (Gaussian cube, OpenDX): uno, per nome o per numero da 1; se vuoto, il primo.</translation>
    </message>
    <message>
        <source>it has only one array, and not &apos;%1&apos;. Leave &apos;--array&apos; out.</source>
        <translation>non ha un vettore «%1», ma uno solo. Omettere «--array».</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;. It has %2: %3.</source>
        <translation>non ha un vettore «%1». Ne ha %2: %3.</translation>
    </message>
    <message>
        <source>%1, number %2 of %3</source>
        <translation>%1, numero %2 di %3</translation>
    </message>
    <message>
        <source>%1 of %2, from 0</source>
        <translation>%1 di %2, da 0</translation>
    </message>
    <message>
        <source>NumPy array (*.npy)</source>
        <translation>Array NumPy (*.npy)</translation>
    </message>
    <message>
        <source>Gaussian cube (*.cube *.cub)</source>
        <translation>Gaussian cube (*.cube *.cub)</translation>
    </message>
    <message>
        <source>OpenDX (*.dx)</source>
        <translation>OpenDX (*.dx)</translation>
    </message>
    <message>
        <source>Brick of values (*.bov)</source>
        <translation>Brick of values (*.bov)</translation>
    </message>
    <message>
        <source>Install Python and meshio with &apos;apt install python3-meshio&apos;, or write the mesh as .vtu.</source>
        <translation>Installare Python e meshio con «apt install python3-meshio», o scrivere la mesh come .vtu.</translation>
    </message>
    <message>
        <source>Install Python and meshio with &apos;apt install python3-meshio&apos;.</source>
        <translation>Installare Python e meshio con «apt install python3-meshio».</translation>
    </message>
    <message>
        <source>Export it again, as .vtu if the program can.</source>
        <translation>Esportarlo di nuovo, come .vtu se il programma lo consente.</translation>
    </message>
    <message>
        <source>its format is not one that TAn leaves to meshio. Let TAn choose the reader.</source>
        <translation>non è di un formato che TAn lascia a meshio. Lasciare a TAn la scelta della lettura.</translation>
    </message>
    <message>
        <source>Gmsh mesh (*.msh)</source>
        <translation>Mesh Gmsh (*.msh)</translation>
    </message>
    <message>
        <source>MED mesh (*.med)</source>
        <translation>Mesh MED (*.med)</translation>
    </message>
    <message>
        <source>XDMF mesh (*.xdmf *.xmf)</source>
        <translation>Mesh XDMF (*.xdmf *.xmf)</translation>
    </message>
    <message>
        <source>Nastran mesh (*.bdf *.nas *.fem)</source>
        <translation>Mesh Nastran (*.bdf *.nas *.fem)</translation>
    </message>
    <message>
        <source>Abaqus mesh (*.inp)</source>
        <translation>Mesh Abaqus (*.inp)</translation>
    </message>
    <message>
        <source>Medit mesh (*.mesh *.meshb)</source>
        <translation>Mesh Medit (*.mesh *.meshb)</translation>
    </message>
    <message>
        <source>it refers to the file &apos;%1&apos;, which is not in its folder. Put the files into one folder.</source>
        <translation>nomina il file «%1», che non si trova nella sua cartella. Spostare i file insieme.</translation>
    </message>
    <message>
        <source>it holds a mesh, and no values at its points or cells. Export the results with the mesh, as .vtu if the program can.</source>
        <translation>contiene una mesh, ma nessun valore nei suoi punti o nelle sue celle. Esportare i risultati insieme alla mesh, come .vtu se il programma lo consente.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has the components 0 to %2, and no component %3.</source>
        <translation>il suo vettore «%1» ha le componenti da 0 a %2, e nessuna componente %3.</translation>
    </message>
    <message>
        <source>one of its cells has a corner that is not one of its %1 points. It is damaged.</source>
        <translation>una delle sue celle ha un vertice che non è uno dei suoi %1 punti. È danneggiato.</translation>
    </message>
    <message>
        <source>its points lie in a plane. A three-dimensional mesh is needed.</source>
        <translation>i suoi punti giacciono in un piano. Serve una mesh a tre dimensioni.</translation>
    </message>
    <message>
        <source>%1 cells of the kind &apos;%2&apos; were left out: TAn does not support them.</source>
        <translation>%1 celle del tipo «%2» sono state omesse: TAn non ne conosce di simili.</translation>
    </message>
    <message>
        <source>meshio, which reads such files, is not installed. Install it with &apos;apt install python3-meshio&apos; (other systems: &apos;pip install meshio&apos;), or write the mesh as .vtu.</source>
        <translation>meshio, che legge file di questo tipo, non è installato. Installarlo con «apt install python3-meshio» (altri sistemi: «pip install meshio»), o scrivere la mesh come .vtu.</translation>
    </message>
    <message>
        <source>meshio needs the Python module &apos;%1&apos; for it. Install it with &apos;apt install python3-%1&apos;, or write the mesh as .vtu.</source>
        <translation>meshio richiede per questo file il modulo Python «%1». Installarlo con «apt install python3-%1», o scrivere la mesh come .vtu.</translation>
    </message>
    <message>
        <source>the system says: %1. Check that the file and those that it refers to can be read.</source>
        <translation>il sistema segnala: %1. Verificare che il file e quelli che nomina siano leggibili.</translation>
    </message>
    <message>
        <source>meshio does not understand it (%1). Open it in the program that wrote it, and export it again, as .vtu if the program can.</source>
        <translation>meshio non lo capisce (%1). Aprirlo nel programma che l&apos;ha scritto ed esportarlo di nuovo, come .vtu se il programma lo consente.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;index&apos; is not understood. Give the name of each dimension with a number from 1, as in member=3,type=1.</source>
        <translation>«%1» per «index» non è comprensibile. Indicare il nome di ogni dimensione con un numero da 1, come in member=3,type=1.</translation>
    </message>
    <message>
        <source>its list &apos;%1&apos; is missing or shorter than its elements require. It is damaged: export it again.</source>
        <translation>il suo elenco «%1» manca o è più corto di quanto richiedono i suoi elementi. È danneggiato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its list &apos;%1&apos; contains number %2, and there are %3. It is damaged: export it again.</source>
        <translation>il suo elenco «%1» nomina il numero %2, e ce ne sono %3. È danneggiato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; does not have %2 values at time step %3. It is damaged or was not written completely: export it again.</source>
        <translation>la sua variabile «%1» non ha %2 valori al passo temporale %3. È danneggiato o non è stato scritto fino alla fine: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has no coordinates of its nodes (&apos;%1&apos;). Write it with a mesh.</source>
        <translation>non ha le coordinate dei suoi nodi («%1»). Scriverlo con una mesh.</translation>
    </message>
    <message>
        <source>its coordinates &apos;%1&apos; are not those of %2 nodes. It is damaged: export it again.</source>
        <translation>le sue coordinate «%1» non sono quelle di %2 nodi. È danneggiato: esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it lists a variable number %1 at its nodes but has no values of it. Export it again.</source>
        <translation>nomina una variabile numero %1 nei suoi nodi e non ne ha i valori. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 e altri %2</translation>
    </message>
    <message>
        <source>it has no part &apos;%1&apos;. Available: %2.</source>
        <translation>non ha una parte «%1». Parti presenti: %2.</translation>
    </message>
    <message>
        <source>it has no elements. Write it with a mesh.</source>
        <translation>non ha elementi. Scriverlo con una mesh.</translation>
    </message>
    <message>
        <source>its elements are of a shape that TAn does not support: %1. Divide them into simpler ones.</source>
        <translation>i suoi elementi sono di una forma che TAn non conosce: %1. Dividerli in elementi più semplici.</translation>
    </message>
    <message>
        <source>it is a mesh without results: no variables of nodes or elements. Open the file that the solver wrote, or write it with values.</source>
        <translation>è una mesh senza risultati: nessuna variabile di nodi o elementi. Aprire il file scritto dal risolutore, o scriverlo con i valori.</translation>
    </message>
    <message>
        <source>it has no variables of nodes or elements. Write it with one.</source>
        <translation>non ha variabili di nodi o elementi. Scriverlo con almeno una.</translation>
    </message>
    <message>
        <source>moved by &apos;%1&apos;</source>
        <translation>con lo spostamento «%1»</translation>
    </message>
    <message>
        <source>It has displacements (&apos;%1&apos;); its nodes are not moved by them. &apos;displace&apos; moves them.</source>
        <translation>Ha degli spostamenti («%1»); i suoi nodi restano dove erano prima. «displace» li sposta.</translation>
    </message>
    <message>
        <source>1 of its blocks has lines or surfaces and is left out.</source>
        <translation>1 dei suoi blocchi ha linee o superfici ed è omesso.</translation>
    </message>
    <message>
        <source>%1 of its blocks have lines or surfaces and are left out.</source>
        <translation>%1 dei suoi blocchi hanno linee o superfici e sono omessi.</translation>
    </message>
    <message>
        <source>%1 of its blocks have elements of a shape that TAn does not support (&apos;%2&apos;) and are left out.</source>
        <translation>%1 dei suoi blocchi hanno elementi di una forma che TAn non conosce («%2») e sono omessi.</translation>
    </message>
    <message>
        <source>it has no displacements, whose names begin with &apos;disp&apos;. Leave &apos;displace&apos; out.</source>
        <translation>non ha spostamenti, i cui nomi cominciano con «disp». Omettere «displace».</translation>
    </message>
    <message>
        <source>%1 elements have nodes beyond those of linear and quadratic shapes, which were left out.</source>
        <translation>%1 elementi hanno nodi oltre a quelli delle forme lineari e quadratiche, che sono stati omessi.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; has values for its surfaces, not its points. Choose an array of points.</source>
        <translation>il suo vettore «%1» ha valori per le sue superfici, non per i suoi punti. Scegliere un vettore di punti.</translation>
    </message>
    <message>
        <source>none of the blocks that are taken has &apos;%1&apos;. Choose another array or part.</source>
        <translation>nessuno dei blocchi presi ha «%1». Scegliere un altro vettore o un&apos;altra parte.</translation>
    </message>
    <message>
        <source>1 of its blocks has no &apos;%1&apos; and was left out.</source>
        <translation>1 dei suoi blocchi non ha «%1» ed è stato omesso.</translation>
    </message>
    <message>
        <source>%1 of its blocks have no &apos;%2&apos; and were left out.</source>
        <translation>%1 dei suoi blocchi non hanno «%2» e sono stati omessi.</translation>
    </message>
    <message>
        <source>it has no variable &apos;%1&apos; with three dimensions of space. Choose one of these: %2.</source>
        <translation>non ha una variabile «%1» con tre dimensioni spaziali. Sceglierne una di queste: %2.</translation>
    </message>
    <message>
        <source>it is a mesh that follows the conventions %1, which are not read. Convert it to .vtu, for instance with ParaView.</source>
        <translation>è una mesh secondo le convenzioni %1, che non si leggono. Convertirla in .vtu, per esempio con ParaView.</translation>
    </message>
    <message>
        <source>it holds no variables other than coordinates. Write it with values.</source>
        <translation>non contiene variabili, tranne le coordinate. Scriverlo con i valori.</translation>
    </message>
    <message>
        <source>none of its variables has numbers along three dimensions of space with two points or more: %1. TAn takes volumes: choose a file of several levels, or join files along one.</source>
        <translation>nessuna delle sue variabili ha numeri lungo tre dimensioni spaziali con due o più punti: %1. TAn accetta volumi: scegliere un file con più livelli, o unire più file lungo una dimensione.</translation>
    </message>
    <message>
        <source>its variable %1 does not extend along three dimensions of space with two points or more. Choose one that does.</source>
        <translation>la sua variabile %1 non si estende lungo tre dimensioni spaziali con due o più punti. Sceglierne una che lo fa.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; is of the type %2, which is not a number. Choose another one.</source>
        <translation>la sua variabile «%1» è di tipo %2, che non è un numero. Sceglierne un&apos;altra.</translation>
    </message>
    <message>
        <source>it has no time step: nothing was written along its dimension &apos;%1&apos;.</source>
        <translation>non ha passi temporali: nulla è stato scritto lungo la sua dimensione «%1».</translation>
    </message>
    <message>
        <source>it has %1 numbers along &apos;%2&apos;, and %3 was requested with &apos;index&apos;.</source>
        <translation>ha %1 numeri lungo «%2», e con «index» si chiede il numero %3.</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 di %3</translation>
    </message>
    <message>
        <source>its variable %1 has no further dimension &apos;%2&apos;, which was requested with &apos;index&apos;.</source>
        <translation>la sua variabile %1 non ha un&apos;altra dimensione «%2», che viene chiesta con «index».</translation>
    </message>
    <message>
        <source>%1, time %2</source>
        <translation>%1, tempo %2</translation>
    </message>
    <message>
        <source>%1, time %2 (%3)</source>
        <translation>%1, tempo %2 (%3)</translation>
    </message>
    <message>
        <source>%1, with which the NetCDF library fills what was never written</source>
        <translation>%1, con cui la libreria NetCDF riempie ciò che nessuno ha scritto</translation>
    </message>
    <message>
        <source>the NetCDF library says of %1: %2. Copy or export the file again.</source>
        <translation>la libreria NetCDF segnala (%1): %2. Copiare o esportare di nuovo il file.</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos;</source>
        <translation>la sua variabile «%1»</translation>
    </message>
    <message>
        <source>it does not begin like a NetCDF file. It is of another format, or damaged.</source>
        <translation>non comincia come i file NetCDF. È di un altro formato, o danneggiato.</translation>
    </message>
    <message>
        <source>the NetCDF library cannot open it: %1. Copy or export it again.</source>
        <translation>la libreria NetCDF non riesce ad aprirlo: %1. Copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its variables</source>
        <translation>le sue variabili</translation>
    </message>
    <message>
        <source>its groups</source>
        <translation>i suoi gruppi</translation>
    </message>
    <message>
        <source>its dimensions</source>
        <translation>le sue dimensioni</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; has a dimension that none of its enclosing groups has. It is damaged: copy or export it again.</source>
        <translation>la sua variabile «%1» ha una dimensione che nessun gruppo attorno a essa possiede. È danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>Its longitudes &apos;%1&apos; start again within it: they were continued in full turns of 360 degrees.</source>
        <translation>Le sue longitudini «%1» ricominciano da capo al suo interno: sono state proseguite con giri interi di 360 gradi.</translation>
    </message>
    <message>
        <source>numbers of &apos;%1&apos;</source>
        <translation>numeri di «%1»</translation>
    </message>
    <message>
        <source>Its coordinate &apos;%1&apos; counts downwards; it is used as z unchanged, so that up is where z decreases.</source>
        <translation>La sua coordinata «%1» conta verso il basso; viene presa come z così com&apos;è, perciò l&apos;alto è dove z diminuisce.</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>It states which map projection its coordinates belong to (&apos;%1&apos;), which is not used.</source>
        <translation>Dice a quale proiezione cartografica appartengono le sue coordinate («%1»), ma questa non viene usata.</translation>
    </message>
    <message>
        <source>all beyond %1 to %2</source>
        <translation>tutti quelli fuori dell&apos;intervallo da %1 a %2</translation>
    </message>
    <message>
        <source>all below %1</source>
        <translation>tutti quelli sotto %1</translation>
    </message>
    <message>
        <source>all above %1</source>
        <translation>tutti quelli sopra %1</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>numeri</translation>
    </message>
    <message>
        <source>%1, %2, height (PH + PHB) / 9.81 in m</source>
        <translation>%1, %2, altezza (PH + PHB) / 9.81 in m</translation>
    </message>
    <message>
        <source>Exodus variables with several components: the number of one, from 0, or &apos;magnitude&apos;.</source>
        <translation>Di variabili Exodus con più componenti: il numero di una, da 0, oppure «magnitude».</translation>
    </message>
    <message>
        <source>Further dimensions</source>
        <translation>Altre dimensioni</translation>
    </message>
    <message>
        <source>Variables with more dimensions than space and time: the number along each, from 1, as in member=3; by default the first.</source>
        <translation>Di variabili con più dimensioni di quelle di spazio e tempo: il numero lungo ciascuna, da 1, come in member=3; altrimenti si prende il primo.</translation>
    </message>
    <message>
        <source>Exodus files: one element block, by its name, its number from 1 or its id; by default all that have the values.</source>
        <translation>Di file Exodus: un blocco di elementi, per nome, per numero da 1 o per id; se vuoto, tutti quelli che hanno i valori.</translation>
    </message>
    <message>
        <source>Displace</source>
        <translation>Sposta</translation>
    </message>
    <message>
        <source>Exodus files with displacements: moves the nodes by them.</source>
        <translation>Di file Exodus con spostamenti: sposta i nodi secondo questi.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libnetcdf-dev&apos;), or convert the file to NRRD or VTU.</source>
        <translation>Installare il pacchetto tan-vtk-readers, fornito con TAn: «apt install ./tan-vtk-readers_*.deb» nella cartella in cui si trova il file (se TAn è stato compilato in proprio: ricompilarlo dopo «apt install libnetcdf-dev»), o convertire il file in NRRD o VTU.</translation>
    </message>
    <message>
        <source>Install the NetCDF library with &apos;apt install libnetcdf19&apos; (other systems: netcdf-c).</source>
        <translation>Installare la libreria NetCDF con «apt install libnetcdf19» (altri sistemi: netcdf-c).</translation>
    </message>
    <message>
        <source>Copy or export it again; &apos;ncdump -h&apos; shows its content.</source>
        <translation>Copiarlo o esportarlo di nuovo; «ncdump -h» dice che cosa contiene.</translation>
    </message>
    <message>
        <source>NetCDF (*.nc *.nc4 *.netcdf *.cdf *.ncdf)</source>
        <translation>NetCDF (*.nc *.nc4 *.netcdf *.cdf *.ncdf)</translation>
    </message>
    <message>
        <source>The solution states: Mach number %1, angle of attack %2, Reynolds number %3, time %4. They are not used.</source>
        <translation>La soluzione indica: numero di Mach %1, angolo di attacco %2, numero di Reynolds %3, tempo %4. Non vengono usati.</translation>
    </message>
    <message>
        <source>all %1 grids</source>
        <translation>tutte le %1 griglie</translation>
    </message>
    <message>
        <source>grid %1 of %2</source>
        <translation>griglia %1 di %2</translation>
    </message>
    <message>
        <source>It holds %1 grids; the others are not read.</source>
        <translation>Contiene %1 griglie; le altre non vengono lette.</translation>
    </message>
    <message>
        <source>its %1 grids do not make a mesh together. %2 Alternatively choose one of them: &apos;grid&apos; from 1 to %3.</source>
        <translation>le sue %1 griglie non formano insieme una mesh. %2 Oppure scegliere una di esse: «grid» da 1 a %3.</translation>
    </message>
    <message>
        <source>Which grid of a PLOT3D file with several, from 1; 0 joins all into one mesh.</source>
        <translation>Quale griglia di un file PLOT3D che ne contiene più d&apos;una, da 1; 0 le unisce tutte in una mesh.</translation>
    </message>
    <message>
        <source>it has numbers in %1 of its columns, and points need at least four: x, y, z and a value.</source>
        <translation>ha numeri in %1 delle sue colonne, e i punti ne richiedono almeno quattro: x, y, z e un valore.</translation>
    </message>
    <message>
        <source>which of its columns are x, y and z? It has %1. Name three of them with &apos;--positions&apos;, or in Import Options, as in --positions %2.</source>
        <translation>quali delle sue colonne sono x, y e z? Ha %1. Indicarne tre con «--positions», o nelle opzioni di importazione, come in --positions %2.</translation>
    </message>
    <message>
        <source>The points of its %1 parts were put together.</source>
        <translation>I punti delle sue %1 parti sono stati riuniti.</translation>
    </message>
    <message>
        <source>Tables of points: the columns of x, y and z, by name or number, as in a,b,c or 1,2,3; &apos;automatic&apos; finds them by their names, or takes the first three if there are no names.</source>
        <translation>Tabelle di punti: le colonne di x, y e z, per nome o numero, come in a,b,c o 1,2,3; «automatic» le trova dai loro nomi; se non ci sono nomi, prende le prime tre.</translation>
    </message>
    <message>
        <source>Its section &apos;%1&apos; is not read.</source>
        <translation>La sua sezione «%1» non viene letta.</translation>
    </message>
    <message>
        <source>Its coordinates are in different units (%1, %2, %3) and are used as they are.</source>
        <translation>Le sue coordinate sono in unità diverse (%1, %2, %3) e vengono prese così come sono.</translation>
    </message>
    <message>
        <source>Its depths (&apos;%1&apos;) are used for z as they are: if they are positive, the data are upside down.</source>
        <translation>Le sue profondità («%1») vengono prese come z così come sono: se sono positive, i dati risultano capovolti.</translation>
    </message>
    <message>
        <source>it has no section &apos;[Data]&apos;, and so no points.</source>
        <translation>non ha una sezione «[Data]», e quindi nemmeno punti.</translation>
    </message>
    <message>
        <source>line %1 announces %2 points, and there are more.</source>
        <translation>la riga %1 dice che seguono %2 punti, e ce ne sono di più.</translation>
    </message>
    <message>
        <source>line %1 announces %2 points, and there are %3. The copy may be incomplete: copy the file again.</source>
        <translation>la riga %1 dice che seguono %2 punti, e ce ne sono %3. La copia potrebbe essere incompleta: copiare di nuovo il file.</translation>
    </message>
    <message>
        <source>Its array &apos;%1&apos; has %2 values for %3 cells and is not read.</source>
        <translation>Il suo vettore «%1» ha %2 valori per %3 celle e non viene letto.</translation>
    </message>
    <message>
        <source>Its array &apos;%1&apos; has %2 values for %3 points and is not read.</source>
        <translation>Il suo vettore «%1» ha %2 valori per %3 punti e non viene letto.</translation>
    </message>
    <message>
        <source>it has cells of a shape that TAn does not support: %1. Divide them into simpler ones, in ParaView with the filter Tetrahedralize or Tessellate.</source>
        <translation>ha celle di una forma che TAn non conosce: %1. Dividerle in celle più semplici, in ParaView con il filtro Tetrahedralize o Tessellate.</translation>
    </message>
    <message>
        <source>a face of cell %1 (from 0) has %2 points, more than are listed, or fewer than three. It is damaged.</source>
        <translation>una faccia della cella %1 (da 0) ha %2 punti, più di quelli elencati, o meno di tre. È danneggiato.</translation>
    </message>
    <message>
        <source>1 cell has nodes in the middle of its faces, which were not used.</source>
        <translation>1 cella ha nodi nel mezzo delle sue facce, che non sono stati usati.</translation>
    </message>
    <message>
        <source>%1 cells have nodes in the middle of their faces, which were not used.</source>
        <translation>%1 celle hanno nodi nel mezzo delle loro facce, che non sono stati usati.</translation>
    </message>
    <message>
        <source>1 cell is of a higher order: it was read by its corners alone, with straight edges.</source>
        <translation>1 cella è di ordine superiore: è stata letta solo con i suoi vertici, con spigoli diritti.</translation>
    </message>
    <message>
        <source>%1 cells are of a higher order: they were read by their corners alone, with straight edges.</source>
        <translation>%1 celle sono di ordine superiore: sono state lette solo con i loro vertici, con spigoli diritti.</translation>
    </message>
    <message>
        <source>The patches of its boundary are not read: %1.</source>
        <translation>Le zone del suo contorno (patch) non vengono lette: %1.</translation>
    </message>
    <message>
        <source>Its zones of cells are not distinguished: %1.</source>
        <translation>Le sue zone di celle non vengono distinte: %1.</translation>
    </message>
    <message>
        <source>Its clouds of particles are not read.</source>
        <translation>Le sue nuvole di particelle non vengono lette.</translation>
    </message>
    <message>
        <source>its case is decomposed into folders that several processors share (processors2 ...), which VTK 9.1 does not read. Run reconstructPar, and open it again.</source>
        <translation>il suo caso è decomposto in cartelle condivise da più processori (processors2 ...), che VTK 9.1 non legge. Eseguire reconstructPar, e aprirlo di nuovo.</translation>
    </message>
    <message>
        <source>its case has no mesh: there is no &apos;constant/polyMesh&apos; in &apos;%1&apos;, and no folder of a processor. The file must lie in the folder of the case, beside &apos;constant&apos; and &apos;system&apos;.</source>
        <translation>il suo caso non ha una mesh: non c&apos;è «constant/polyMesh» in «%1», né la cartella di un processore. Il file deve stare nella cartella del caso, accanto a «constant» e «system».</translation>
    </message>
    <message>
        <source>the folders of %1 processors</source>
        <translation>le cartelle di %1 processori</translation>
    </message>
    <message>
        <source>Its case as a whole is not read: the folders of its processors contain later times.</source>
        <translation>Il suo caso intero non viene letto: le cartelle dei suoi processori arrivano a tempi successivi.</translation>
    </message>
    <message>
        <source>The folders of its %1 processors are not read: the case as a whole is.</source>
        <translation>Le cartelle dei suoi %1 processori non vengono lette: si legge il caso intero.</translation>
    </message>
    <message>
        <source>1 other part has no &apos;%1&apos; and is not read: %2.</source>
        <translation>1 altra parte non ha «%1» e non viene letta: %2.</translation>
    </message>
    <message>
        <source>%1 other parts have no &apos;%2&apos; and are not read: %3.</source>
        <translation>%1 altre parti non hanno «%2» e non vengono lette: %3.</translation>
    </message>
    <message>
        <source>1 other part is not read: %1.</source>
        <translation>1 altra parte non viene letta: %1.</translation>
    </message>
    <message>
        <source>%1 other parts are not read: %2.</source>
        <translation>%1 altre parti non vengono lette: %2.</translation>
    </message>
    <message>
        <source>Field data, which belong to no point or cell, are not read: %1.</source>
        <translation>I dati di campo (field data), che non appartengono a nessun punto e a nessuna cella, non vengono letti: %1.</translation>
    </message>
    <message>
        <source>%1 of %2, time %3, file &apos;%4&apos;</source>
        <translation>%1 di %2, tempo %3, file «%4»</translation>
    </message>
    <message>
        <source>VTK finds nothing in it that it can read. Export it in another format (.vtu, .vti).</source>
        <translation>VTK non vi trova nulla che possa leggere. Esportarlo in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>it refers to the file &apos;%1&apos;, which is not in its folder or below it. Put it there, and correct its name.</source>
        <translation>nomina il file «%1», che non si trova nella sua cartella o al di sotto di essa. Metterlo lì, e scriverne di nuovo il nome.</translation>
    </message>
    <message>
        <source>it has the time &apos;%1&apos;, which is not a number.</source>
        <translation>ha il tempo «%1», che non è un numero.</translation>
    </message>
    <message>
        <source>its XML ends or breaks in line %1. It is damaged or cut short: copy or export it again.</source>
        <translation>il suo XML finisce o si interrompe alla riga %1. È danneggiato o troncato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its JSON breaks at byte %1. It is damaged or cut short: copy or export it again.</source>
        <translation>il suo JSON si interrompe al byte %1. È danneggiato o troncato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it has no list of &apos;files&apos;.</source>
        <translation>non ha un elenco di «files».</translation>
    </message>
    <message>
        <source>its file number %1 does not have a &apos;name&apos; and a &apos;time&apos; that is a number.</source>
        <translation>il suo file numero %1 non è indicato da un «name» e da un «time» che sia un numero.</translation>
    </message>
    <message>
        <source>it has %1 bytes, more than a list of files has.</source>
        <translation>ha %1 byte, più di quanti ne ha un elenco di file.</translation>
    </message>
    <message>
        <source>it is a list of files, but names none.</source>
        <translation>è un elenco di file, e non ne nomina nessuno.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; is not of VTK&apos;s own formats. Open that file on its own.</source>
        <translation>il suo file «%1» non è di nessuno dei formati propri di VTK. Aprire quel file da solo.</translation>
    </message>
    <message>
        <source>VTK says: %1 TAn cannot tell whether the file is damaged or of a kind that VTK does not read. Compare it with its original, or export it in another format (.vtu, .vti).</source>
        <translation>VTK segnala: %1 TAn non può stabilire se il file è danneggiato o di un tipo che VTK non legge. Confrontarlo con il suo originale, o esportarlo in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>VTK reads different values each time: where the file has none, it returns what was in memory. The file is incomplete, or of a kind that VTK reads wrongly. Export it again, or in another format (.vtu, .vti).</source>
        <translation>VTK lo legge due volte e trova valori diversi: dove il file non ne ha, restituisce ciò che era in memoria. Il file è incompleto, o di un tipo che VTK legge in modo errato. Esportarlo di nuovo, o in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>Lists of VTK files (*.pvd *.series)</source>
        <translation>Elenchi di file VTK (*.pvd *.series)</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libvtk9-dev&apos;), or convert the file to NRRD or CSV.</source>
        <translation>Installare il pacchetto tan-vtk-readers, fornito con TAn: «apt install ./tan-vtk-readers_*.deb» nella cartella in cui si trova il file (se TAn è stato compilato in proprio: ricompilarlo dopo «apt install libvtk9-dev»), o convertire il file in NRRD o CSV.</translation>
    </message>
    <message>
        <source>Export it again, or in another format (.vtu, .vti).</source>
        <translation>Esportarlo di nuovo, o in un altro formato (.vtu, .vti).</translation>
    </message>
    <message>
        <source>Install the NetCDF library with &apos;apt install libnetcdf19&apos;.</source>
        <translation>Installare la libreria NetCDF con «apt install libnetcdf19».</translation>
    </message>
    <message>
        <source>its variable &apos;%1&apos; has %2 values, which do not fit into half of the memory of this machine. Choose a smaller one.</source>
        <translation>la sua variabile «%1» ha %2 valori, che non entrano in metà della memoria di questa macchina. Prenderne una più piccola.</translation>
    </message>
    <message>
        <source>The region does not lie in the grid, of which it takes the numbers of points, not coordinates: along %1 whole numbers from 0 to %2.</source>
        <translation>La regione non è nella griglia, di cui richiede i numeri dei punti e non le coordinate: lungo %1 numeri interi da 0 a %2.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a file of an OpenFOAM case, which is opened as a whole: open &apos;system/controlDict&apos; in its folder, or an empty file there whose name ends in &apos;.foam&apos;.%2</source>
        <translation>«%1» è un file di un caso OpenFOAM, che si apre per intero: con «system/controlDict» nella sua cartella, o con un file vuoto nella stessa cartella il cui nome finisce in «.foam».%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the folder of an OpenFOAM case. Open &apos;system/controlDict&apos; in it.</source>
        <translation>«%1» è la cartella di un caso OpenFOAM. Aprire «system/controlDict» al suo interno.</translation>
    </message>
    <message>
        <source>%1 It has %2 parts, of which &apos;part&apos; takes one: %3.</source>
        <translation>%1 Ha %2 parti, di cui «part» ne prende una: %3.</translation>
    </message>
    <message>
        <source>%1 needs more than %2 of memory for it, half of what this machine has. It may be damaged, or too large for this machine: take a part of it.</source>
        <translation>%1 richiede per questo file più di %2 di memoria, la metà di quella di questo computer. Il file può essere danneggiato, o troppo grande per questo computer: prenderne una parte.</translation>
    </message>
    <message>
        <source>%1 needs more than %2 of memory for it, which files of its size do not need. It may be damaged; if not, write it in another format (.vtu, .vti, .nrrd).</source>
        <translation>%1 richiede per questo file più di %2 di memoria, di cui file di queste dimensioni non hanno bisogno. Può essere danneggiato; altrimenti, scriverlo in un altro formato (.vtu, .vti, .nrrd).</translation>
    </message>
    <message>
        <source>%1 needs more than %2 seconds of processor time for it, which files of its size do not need. It may be damaged; if not, write it in another format (.vtu, .vti, .nrrd).</source>
        <translation>%1 richiede per questo file più di %2 secondi di processore, di cui file di queste dimensioni non hanno bisogno. Può essere danneggiato; altrimenti, scriverlo in un altro formato (.vtu, .vti, .nrrd).</translation>
    </message>
    <message>
        <source>%1&apos;s reader crashed, and TAn cannot tell why: the file may be damaged, or of a kind that %1 reads incorrectly. %2</source>
        <translation>Il lettore di %1 si è arrestato in modo anomalo, e TAn non sa dire perché: il file può essere danneggiato, o di un tipo che %1 legge male. %2</translation>
    </message>
    <message>
        <source>it has no values, of points or of cells. Write it with some.</source>
        <translation>non ha valori, né di punti né di celle. Scriverlo con dei valori.</translation>
    </message>
    <message>
        <source>it has polyhedra, but not their faces: these are in the arrays &apos;faces&apos; and &apos;faceoffsets&apos; or, since VTK 9.4, &apos;face_connectivity&apos;, &apos;face_offsets&apos;, &apos;polyhedron_to_faces&apos; and &apos;polyhedron_offsets&apos;. Save it again, or divide its cells into tetrahedra.</source>
        <translation>ha dei poliedri, ma non le loro facce: queste stanno nei vettori «faces» e «faceoffsets» oppure, da VTK 9.4, in «face_connectivity», «face_offsets», «polyhedron_to_faces» e «polyhedron_offsets». Salvarlo di nuovo, o dividere le sue celle in tetraedri.</translation>
    </message>
    <message>
        <source>the offsets of its faces do not rise, or point beyond their points.</source>
        <translation>gli inizi delle sue facce non crescono, o portano oltre i loro punti.</translation>
    </message>
    <message>
        <source>the polyhedron %1 has the face %2 of %3.</source>
        <translation>il poliedro %1 ha la faccia %2 di %3.</translation>
    </message>
    <message>
        <source>its polyhedra use its faces more often than cells of a mesh can.</source>
        <translation>i suoi poliedri usano le sue facce più spesso di quanto possano le celle di una mesh.</translation>
    </message>
    <message>
        <source>Give the number of a channel, from 1.</source>
        <translation>Indicare il numero di un canale, da 1.</translation>
    </message>
    <message>
        <source>The array to take, by its path in the file, as in /fields/density, or by number; &apos;automatic&apos; takes the one that the file shows first (NeXus), else the largest.</source>
        <translation>L&apos;array da prendere, con il suo percorso nel file, come in /fields/density, o con il numero; «automatic» prende quello che il file mostra per primo (NeXus), altrimenti il più grande.</translation>
    </message>
    <message>
        <source>Arrays with several time steps: which one, from 1.</source>
        <translation>Di array con più passi temporali: quale, da 1.</translation>
    </message>
    <message>
        <source>Arrays with several channels: the number of one, from 1; by default the first.</source>
        <translation>Di array con più canali: il numero di uno, da 1; se vuoto il primo.</translation>
    </message>
    <message>
        <source>Arrays with more dimensions than space, time and channels: the number along each, from 1, as in d2=3; by default the first.</source>
        <translation>Di array con altre dimensioni oltre a spazio, tempo e canali: il numero lungo ciascuna di esse, da 1, come in d2=3; altrimenti si prende il primo.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libhdf5-dev&apos;), or save the array as .npy, for instance with h5py and NumPy.</source>
        <translation>Installare il pacchetto tan-vtk-readers, fornito con TAn: «apt install ./tan-vtk-readers_*.deb» nella cartella in cui si trova il file (se TAn è stato compilato in proprio: ricompilarlo dopo «apt install libhdf5-dev»), o salvare l&apos;array come .npy, per esempio con h5py e NumPy.</translation>
    </message>
    <message>
        <source>Install the HDF5 library with &apos;apt install libhdf5-103-1&apos; (other systems: hdf5).</source>
        <translation>Installare la libreria HDF5 con «apt install libhdf5-103-1» (altri sistemi: hdf5).</translation>
    </message>
    <message>
        <source>Copy or export it again; &apos;h5dump -H&apos; shows its content.</source>
        <translation>Copiarlo o esportarlo di nuovo; «h5dump -H» mostra che cosa contiene.</translation>
    </message>
    <message>
        <source>it has %1 %2, and number %3 was requested with &apos;%4&apos;.</source>
        <translation>ha %1 %2, e con «%4» si chiede il numero %3.</translation>
    </message>
    <message>
        <source>components, counted from 0</source>
        <translation>componenti, contate da 0</translation>
    </message>
    <message>
        <source>numbers along &apos;%1&apos;</source>
        <translation>numeri lungo «%1»</translation>
    </message>
    <message>
        <source>its array %1 has no further dimension &apos;%2&apos;, which was requested with &apos;index&apos;.</source>
        <translation>il suo array %1 non ha un&apos;altra dimensione «%2», che viene chiesta con «index».</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>canali</translation>
    </message>
    <message>
        <source>its array %1 has fewer than three dimensions of space: the others are time or channels. TAn reads volumes: choose another array, or write one.</source>
        <translation>il suo array %1 ha meno di tre dimensioni spaziali: le altre sono di tempo o di canali. TAn accetta volumi: scegliere un altro array, o scriverne uno.</translation>
    </message>
    <message>
        <source>its array %1 needs %2 of memory, and this machine can spare %3. Write a part of it, or one with fewer points.</source>
        <translation>il suo array %1 richiede %2 di memoria, e questo computer può metterne a disposizione %3. Scriverne una parte, o uno con meno punti.</translation>
    </message>
    <message>
        <source>It has an attribute &apos;%1&apos;, which is not used.</source>
        <translation>Ha un attributo «%1», che non viene usato.</translation>
    </message>
    <message>
        <source>It holds other arrays, which are not read: %1.</source>
        <translation>Contiene altri array, che non vengono letti: %1.</translation>
    </message>
    <message>
        <source>%1, &apos;%2&apos; in the order of the array&apos;s axes</source>
        <translation>%1, «%2» nell&apos;ordine degli assi dell&apos;array</translation>
    </message>
    <message>
        <source>Its coordinates &apos;%1&apos; are the edges of bins: their midpoints were used.</source>
        <translation>Le sue coordinate «%1» sono i bordi di intervalli: ne sono stati presi i punti medi.</translation>
    </message>
    <message>
        <source>&apos;Origin&apos;, &apos;Spacing&apos; and &apos;Directions&apos; of ITK</source>
        <translation>«Origin», «Spacing» e «Directions» di ITK</translation>
    </message>
    <message>
        <source>the chunks of its array &apos;%1&apos;</source>
        <translation>i blocchi (chunk) del suo array «%1»</translation>
    </message>
    <message>
        <source>nothing was written to its array %1: it holds only a fill value. Choose another array, or write this one.</source>
        <translation>nel suo array %1 non è stato scritto nulla: ha soltanto un valore di riempimento. Scegliere un altro array, o scrivere questo.</translation>
    </message>
    <message>
        <source>only %1 of the %2 chunks of its array &apos;%3&apos; were written, and it has no fill value for the others. Write all of it.</source>
        <translation>sono stati scritti solo %1 dei %2 blocchi (chunk) del suo array «%3», che non ha un valore di riempimento per gli altri. Scriverlo per intero.</translation>
    </message>
    <message>
        <source>%1, the array&apos;s fill value</source>
        <translation>%1, il valore di riempimento dell&apos;array</translation>
    </message>
    <message>
        <source>%1, %2, the array&apos;s fill value</source>
        <translation>%1, %2, il valore di riempimento dell&apos;array</translation>
    </message>
    <message>
        <source>0 in %1 of %2 chunks, which were never written</source>
        <translation>0 in %1 di %2 blocchi (chunk), che non sono mai stati scritti</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos;</source>
        <translation>il suo array «%1»</translation>
    </message>
    <message>
        <source>Its numbers of more than 64 bits were converted to floating-point numbers, which are exact to 53 bits.</source>
        <translation>I suoi numeri di più di 64 bit sono diventati numeri in virgola mobile a 53 bit.</translation>
    </message>
    <message>
        <source>It holds more than %1 groups and arrays, or groups nested more than %2 levels deep: not all of them were examined.</source>
        <translation>Contiene più di %1 gruppi e array, o gruppi annidati a più di %2 livelli: non tutti sono stati esaminati.</translation>
    </message>
    <message>
        <source>Its links into other files are not followed: %1.</source>
        <translation>I suoi collegamenti ad altri file non vengono seguiti: %1.</translation>
    </message>
    <message>
        <source>it is a file of %1, which TAn recognises by its name. Give it the ending %2.</source>
        <translation>è un file di %1, che TAn riconosce dal nome. Dargli l&apos;estensione %2.</translation>
    </message>
    <message>
        <source>it is a MINC 2 file, whose numbers are scaled slice by slice; this is not read. Convert it with mnc2nii.</source>
        <translation>è un file MINC 2, i cui numeri sono scalati strato per strato; questo non si legge. Convertirlo con mnc2nii.</translation>
    </message>
    <message>
        <source>it holds no arrays of its own. %1 Open the file that holds them.</source>
        <translation>non contiene array propri. %1 Aprire il file che li contiene.</translation>
    </message>
    <message>
        <source>it holds no arrays. Write it with values.</source>
        <translation>non contiene array. Scriverlo con dei valori.</translation>
    </message>
    <message>
        <source>none of its arrays has numbers along three dimensions with two points or more: %1. TAn takes volumes: choose a file that holds one, or write one, for instance with h5py.</source>
        <translation>nessuno dei suoi array ha numeri lungo tre dimensioni con due o più punti: %1. TAn accetta volumi: scegliere un file che ne contenga uno, o scriverne uno, per esempio con h5py.</translation>
    </message>
    <message>
        <source>the values of its array &apos;%1&apos; lie in other files or arrays, which are not opened. Copy them into an array of their own, for instance with h5py.</source>
        <translation>i valori del suo array «%1» si trovano in altri file o array, che non vengono aperti. Copiarli in un array a parte, per esempio con h5py.</translation>
    </message>
    <message>
        <source>its array %1 holds no numbers that can be read. Choose another one.</source>
        <translation>il suo array %1 non contiene numeri che si leggano. Sceglierne un altro.</translation>
    </message>
    <message>
        <source>its array %1 does not extend along three dimensions with two points or more. Choose one that does.</source>
        <translation>il suo array %1 non si estende lungo tre dimensioni con due o più punti. Sceglierne uno che lo faccia.</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>l&apos;intero file</translation>
    </message>
    <message>
        <source>%1 (in other files)</source>
        <translation>%1 (in altri file)</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; does not state how it is packed. The file is damaged: copy or export it again.</source>
        <translation>il suo array «%1» non dice come è compresso. Il file è danneggiato: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos; is packed with the filter %2, which is not part of HDF5 and is not read. Write it with gzip or unpacked: &apos;h5repack -f GZIP=4 old.h5 new.h5&apos; does so where the filter is installed.</source>
        <translation>il suo array «%1» è compresso con il filtro %2, che non fa parte di HDF5 e non si legge. Scriverlo con gzip o senza compressione: «h5repack -f GZIP=4 old.h5 new.h5» lo fa dove il filtro è installato.</translation>
    </message>
    <message>
        <source>the HDF5 library says of %1: %2. Copy or export the file again.</source>
        <translation>errore della libreria HDF5 (%1): %2. Copiare o esportare di nuovo il file.</translation>
    </message>
    <message>
        <source>its size cannot be determined: %1.</source>
        <translation>la sua dimensione non si può determinare: %1.</translation>
    </message>
    <message>
        <source>it unpacks to more than %1, which pictures of so few bytes do not. It is damaged; if not, export it without compression.</source>
        <translation>decompresso supera %1, cosa che immagini in così pochi byte non fanno. È danneggiato; altrimenti, esportarlo senza compressione.</translation>
    </message>
    <message>
        <source>1 slice is missing between the others. The gap stays, and values are interpolated across it.</source>
        <translation>Tra le altre manca 1 strato. La lacuna resta, e i valori vi sono interpolati.</translation>
    </message>
    <message>
        <source>%1 slices are missing between the others. The gaps stay, and values are interpolated across them.</source>
        <translation>Tra le altre mancano %1 strati. Le lacune restano, e i valori vi sono interpolati.</translation>
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
        <translation>la sua cartella contiene una sola serie, e si chiede «%1». Omettere «series».</translation>
    </message>
    <message>
        <source>its folder holds %1 series, and &apos;%2&apos; was requested. Choose one with &apos;series&apos;, by its number from 1 or its description: %3.</source>
        <translation>la sua cartella contiene %1 serie, e si chiede «%2». Sceglierne una con «series», per numero a partire da 1 o per descrizione: %3.</translation>
    </message>
    <message>
        <source>Next to it is series %1: %2.</source>
        <translation>Accanto c&apos;è la serie %1: %2.</translation>
    </message>
    <message>
        <source>The series holds %1 volumes; the others are not read.</source>
        <translation>La serie contiene %1 volumi; gli altri non vengono letti.</translation>
    </message>
    <message>
        <source>A folder with several DICOM series, or an OME file with several images: which one, by number from 1, by its description or name, or by its SeriesInstanceUID; by default that of the file, or the first.</source>
        <translation>Di una cartella con più serie DICOM, o di un file OME con più immagini: quale, per numero a partire da 1, per descrizione o nome, o per SeriesInstanceUID; senza indicazione quella del file, o la prima.</translation>
    </message>
    <message>
        <source>a piece of %1 has %2 bytes, which cannot hold the %3 that its size requires.</source>
        <translation>un pezzo di %1 ha %2 byte, che non possono contenere i %3 che la sua dimensione richiede.</translation>
    </message>
    <message>
        <source>its description, or its resolution,</source>
        <translation>la sua descrizione, o la sua risoluzione,</translation>
    </message>
    <message>
        <source>page %1 is followed by no page, or by an earlier one.</source>
        <translation>dopo la pagina %1 non ne segue alcuna, o ne segue una già incontrata.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;, and nothing to choose from. Leave &apos;%2&apos; out.</source>
        <translation>non ha «%1» per «%2», né altro tra cui scegliere. Omettere «%2».</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;. Choose one from 1 to %3.</source>
        <translation>non ha «%1» per «%2». Sceglierne uno da 1 a %3.</translation>
    </message>
    <message>
        <source>it has no &apos;%1&apos; for &apos;%2&apos;. Choose one from 1 to %3, or by its name: %4.</source>
        <translation>non ha «%1» per «%2». Sceglierne uno da 1 a %3, oppure indicarne il nome: %4.</translation>
    </message>
    <message>
        <source>It has %1 channels; the others are not read.</source>
        <translation>Ha %1 canali; gli altri non vengono letti.</translation>
    </message>
    <message>
        <source>%1, %2 %3</source>
        <translation>%1, %2 %3</translation>
    </message>
    <message>
        <source>It has %1 time steps; the others are not read.</source>
        <translation>Ha %1 passi temporali; gli altri non vengono letti.</translation>
    </message>
    <message>
        <source>It holds %1 images; the others are not read.</source>
        <translation>Contiene %1 immagini; le altre non vengono lette.</translation>
    </message>
    <message>
        <source>its type &apos;%1&apos; is not known. Use uint8, int8, uint16, int16, uint32, int32, int64, uint64, float or double.</source>
        <translation>il suo tipo «%1» non è noto. Ci sono uint8, int8, uint16, int16, uint32, int32, int64, uint64, float e double.</translation>
    </message>
    <message>
        <source>its samples are matrices of %1 numbers (&apos;%2&apos;), whose magnitude has no meaning. Choose one of them with &apos;--component&apos;, from 0.</source>
        <translation>i suoi campioni sono matrici di %1 numeri («%2»), il cui modulo non significa nulla. Sceglierne uno con «--component», da 0.</translation>
    </message>
    <message>
        <source>%1 numbers of type %2, %3 bytes</source>
        <translation>%1 numeri di tipo %2, %3 byte</translation>
    </message>
    <message>
        <source>its array has the shape %1. Export it again.</source>
        <translation>il suo array ha la forma %1. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it names &apos;%1&apos;, which is not a regular file. Copy its content into one first.</source>
        <translation>nomina «%1», che non è un file ordinario. Copiarne prima il contenuto in uno.</translation>
    </message>
    <message>
        <source>its values &apos;%1&apos; refer to a node or an element %2, which it does not have.</source>
        <translation>i suoi valori «%1» nominano un nodo o un elemento %2, che non ha.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 steps; the last one is read.</source>
        <translation>Di «%1» ha %2 passi; si legge l&apos;ultimo.</translation>
    </message>
    <message>
        <source>%1, %2 (%3 %4)</source>
        <translation>%1, %2 (%3 %4)</translation>
    </message>
    <message>
        <source>NetCDF and Exodus files: the variable, by name or number; &apos;automatic&apos; takes the first that is not constant.</source>
        <translation>Di file NetCDF ed Exodus: la variabile, per nome o numero; «automatic» prende la prima che non è costante.</translation>
    </message>
    <message>
        <source>%1: it is of another format that begins with whole numbers, such as a surface of MOVIE.BYU, or only the beginning of a grid. Export its data as PLOT3D, .vtu or a table.</source>
        <translation>%1: è di un altro formato che comincia con numeri interi, come una superficie di MOVIE.BYU, o è solo l&apos;inizio di una griglia. Esportarne i dati come PLOT3D, .vtu o tabella.</translation>
    </message>
    <message>
        <source>Tables of points: the column of the values, by its name or its number in the table, from 1; &apos;automatic&apos; takes the first that is measured, not a counter or a constant.</source>
        <translation>Tabelle di punti: la colonna dei valori, con il suo nome o il suo numero nella tabella, da 1; «automatic» prende la prima di valori misurati, non di un contatore o di una costante.</translation>
    </message>
    <message>
        <source>The line of units below its names has %1 of them for %2 columns.</source>
        <translation>La riga delle unità sotto i suoi nomi ne ha %1 per %2 colonne.</translation>
    </message>
    <message>
        <source>Its file &apos;%1&apos; ends without an end of line: if it was cut short there, its last number is wrong.</source>
        <translation>Il suo file «%1» finisce senza fine riga: se è stato troncato lì, il suo ultimo numero è sbagliato.</translation>
    </message>
    <message>
        <source>cell %1 (from 0) is a polyhedron, and VTK 9.1 finds no faces of it: since VTK 9.4 they are written differently, which TAn reads in a single .vtu that is not compressed, or compressed with zlib. Save it as one.</source>
        <translation>la cella %1 (da 0) è un poliedro, e VTK 9.1 non ne trova le facce: da VTK 9.4 in poi sono scritte in un altro modo, che TAn legge in un singolo .vtu non compresso, o compresso con zlib. Salvare i dati così.</translation>
    </message>
    <message>
        <source>VTK reads its positions in single precision: they may be up to %1 from those in the file.</source>
        <translation>VTK ne legge le posizioni in precisione singola: possono discostarsi fino a %1 da quelle del file.</translation>
    </message>
    <message>
        <source>Its families (boundary conditions and the like) are not distinguished: %1.</source>
        <translation>Le sue famiglie (condizioni al contorno e simili) non vengono distinte: %1.</translation>
    </message>
    <message>
        <source>its part &apos;%1&apos; has %2 points, and its size states another number.</source>
        <translation>la sua parte «%1» ha %2 punti, e la sua dimensione dice un altro numero.</translation>
    </message>
    <message>
        <source>Its grids do not make a mesh together, and only the first one is read. %1</source>
        <translation>Le sue griglie non formano insieme una mesh, e si legge solo la prima. %1</translation>
    </message>
    <message>
        <source>Files with several blocks or parts: one, by name or number from 1; by default all volumes that have the values, as one mesh.</source>
        <translation>Di file con più blocchi o parti: uno, con il nome o il numero da 1; se vuoto tutti i volumi che hanno i valori, come una sola mesh.</translation>
    </message>
    <message>
        <source>%1 Export the image again.</source>
        <translation>%1 Esportare di nuovo l&apos;immagine.</translation>
    </message>
    <message>
        <source>one of its axes has no name.</source>
        <translation>uno dei suoi assi non ha nome.</translation>
    </message>
    <message>
        <source>it has %1 axes.</source>
        <translation>ha %1 assi.</translation>
    </message>
    <message>
        <source>its transformation &apos;%1&apos; is in a separate array, which TAn does not read.</source>
        <translation>la sua trasformazione «%1» sta in un array a parte, che TAn non legge.</translation>
    </message>
    <message>
        <source>its transformation &apos;%1&apos; does not have one number for each of its %2 axes.</source>
        <translation>la sua trasformazione «%1» non ha un numero per ciascuno dei suoi %2 assi.</translation>
    </message>
    <message>
        <source>its transformation is of the kind &apos;%1&apos;, and TAn reads &apos;scale&apos; and &apos;translation&apos;.</source>
        <translation>la sua trasformazione è di tipo «%1», e TAn legge «scale» e «translation».</translation>
    </message>
    <message>
        <source>one of its levels has no path.</source>
        <translation>uno dei suoi livelli non ha un percorso.</translation>
    </message>
    <message>
        <source>it names no levels.</source>
        <translation>non nomina livelli.</translation>
    </message>
    <message>
        <source>its list of images (&apos;multiscales&apos;) is empty.</source>
        <translation>il suo elenco di immagini («multiscales») è vuoto.</translation>
    </message>
    <message>
        <source>Its group describes %1 images; only the first of them is read.</source>
        <translation>Il suo gruppo descrive %1 immagini; se ne legge solo la prima.</translation>
    </message>
    <message>
        <source>its array &apos;%1&apos;: %2</source>
        <translation>il suo array «%1»: %2</translation>
    </message>
    <message>
        <source>its metadata have no usable &apos;%1&apos;. Copy or export it again.</source>
        <translation>i suoi metadati non hanno un valore utilizzabile per «%1». Copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>%1, which TAn does not read. %2</source>
        <translation>%1, cosa che TAn non legge. %2</translation>
    </message>
    <message>
        <source>Write it with Blosc, Zstandard, gzip or zlib.</source>
        <translation>Scriverlo con Blosc, Zstandard, gzip o zlib.</translation>
    </message>
    <message>
        <source>its chunks have %1 axes, and it has %2. It is damaged.</source>
        <translation>i suoi blocchi (chunk) hanno %1 assi, e il suo array ne ha %2. È danneggiato.</translation>
    </message>
    <message>
        <source>its chunks have no size. It is damaged.</source>
        <translation>i suoi blocchi (chunk) non hanno dimensione. È danneggiato.</translation>
    </message>
    <message>
        <source>its chunks would have more bytes than any machine. It is damaged.</source>
        <translation>i suoi blocchi (chunk) avrebbero più byte di qualsiasi computer. È danneggiato.</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;</source>
        <translation>i suoi blocchi (chunk) sono compressi con «%1»</translation>
    </message>
    <message>
        <source>its numbers were passed through the filter &apos;%1&apos;</source>
        <translation>i suoi numeri sono passati per il filtro «%1»</translation>
    </message>
    <message>
        <source>Write it without filters.</source>
        <translation>Scriverlo senza filtri.</translation>
    </message>
    <message>
        <source>its elements are records of several fields</source>
        <translation>i suoi elementi sono record di più campi</translation>
    </message>
    <message>
        <source>its elements are of the type &apos;%1&apos;</source>
        <translation>i suoi elementi sono di tipo «%1»</translation>
    </message>
    <message>
        <source>Write whole numbers, or floating-point numbers of 16, 32 or 64 bits.</source>
        <translation>Scrivere numeri interi, o numeri in virgola mobile a 16, 32 o 64 bit.</translation>
    </message>
    <message>
        <source>its codec &apos;%1&apos; is in an unusual place</source>
        <translation>il suo codec «%1» sta in una posizione insolita</translation>
    </message>
    <message>
        <source>its chunks were passed through the codec &apos;%1&apos;</source>
        <translation>i suoi blocchi (chunk) sono passati per il codec «%1»</translation>
    </message>
    <message>
        <source>its shards are not a whole number of chunks. It is damaged.</source>
        <translation>i suoi shard non sono composti da un numero intero di blocchi (chunk). È danneggiato.</translation>
    </message>
    <message>
        <source>the index of its shards is packed</source>
        <translation>l&apos;indice dei suoi shard è compresso</translation>
    </message>
    <message>
        <source>Write it unpacked.</source>
        <translation>Scriverlo senza compressione.</translation>
    </message>
    <message>
        <source>the names of its chunks are of the kind &apos;%1&apos;</source>
        <translation>i nomi dei suoi blocchi (chunk) sono di tipo «%1»</translation>
    </message>
    <message>
        <source>Write it with the names &apos;default&apos;.</source>
        <translation>Scriverlo con i nomi «default».</translation>
    </message>
    <message>
        <source>it has the storage transformer &apos;%1&apos;</source>
        <translation>usa la trasformazione di memorizzazione (storage transformer) «%1»</translation>
    </message>
    <message>
        <source>Write it without one.</source>
        <translation>Scriverlo senza.</translation>
    </message>
    <message>
        <source>its chunks lie in a grid of the kind &apos;%1&apos;</source>
        <translation>i suoi blocchi (chunk) stanno in una griglia di tipo «%1»</translation>
    </message>
    <message>
        <source>Write it in chunks of one size.</source>
        <translation>Scriverlo in blocchi (chunk) di una sola dimensione.</translation>
    </message>
    <message>
        <source>it is of version %1 of Zarr&apos;s format</source>
        <translation>è della versione %1 del formato Zarr</translation>
    </message>
    <message>
        <source>TAn reads the versions 2 and 3.</source>
        <translation>TAn legge le versioni 2 e 3.</translation>
    </message>
    <message>
        <source>it has no level &apos;%1&apos;. Choose one from 0 to %2 with &apos;part&apos;.</source>
        <translation>non ha un livello «%1». Sceglierne uno da 0 a %2 con «part».</translation>
    </message>
    <message>
        <source>It has %1 levels of detail, 0 being the finest; the others are not read. Choose one with &apos;part&apos;.</source>
        <translation>Ha %1 livelli di dettaglio, di cui 0 è il più fine; gli altri non vengono letti. Sceglierne uno con «part».</translation>
    </message>
    <message>
        <source>it has no array &apos;%1&apos;.</source>
        <translation>non ha un array «%1».</translation>
    </message>
    <message>
        <source>Its labels, which number the parts of a picture, are not read.</source>
        <translation>Le sue etichette, che numerano le parti di un&apos;immagine, non vengono lette.</translation>
    </message>
    <message>
        <source>It holds %1 other arrays (%2), which are not read. Choose one with &apos;array&apos;.</source>
        <translation>Contiene altri %1 array (%2), che non vengono letti. Sceglierne uno con «array».</translation>
    </message>
    <message>
        <source>%1 of its groups and arrays have metadata that cannot be read.</source>
        <translation>%1 dei suoi gruppi e array hanno metadati che non si possono leggere.</translation>
    </message>
    <message>
        <source>It has more groups and arrays than are listed; &apos;array&apos; takes any of them by its path.</source>
        <translation>Ha più gruppi e array di quanti se ne esaminino; «array» ne prende uno qualsiasi dal suo percorso.</translation>
    </message>
    <message>
        <source>it is an array with %1 axes, and TAn reads volumes, which have three.</source>
        <translation>è un array con %1 assi, e TAn legge volumi, che ne hanno tre.</translation>
    </message>
    <message>
        <source>it holds %1 arrays, and none of numbers along three axes or more.</source>
        <translation>contiene %1 array, e nessuno di numeri lungo tre o più assi.</translation>
    </message>
    <message>
        <source>it holds no array. Open the folder that contains the arrays, or copy it again.</source>
        <translation>non contiene un array. Aprire la cartella in cui si trovano gli array, o copiarla di nuovo.</translation>
    </message>
    <message>
        <source>it has %1 of &apos;%2&apos;, and number %3 was requested. Choose one from 1 to %1.</source>
        <translation>ha %1 di «%2», e si chiede il numero %3. Sceglierne uno da 1 a %1.</translation>
    </message>
    <message>
        <source>%1, time %2 %3</source>
        <translation>%1, tempo %2 %3</translation>
    </message>
    <message>
        <source>It has %1 volumes along its axis &apos;%2&apos;, of which the first is read. Choose one with &apos;index&apos;, as in %2=2.</source>
        <translation>Ha %1 volumi lungo il suo asse «%2», di cui si legge il primo. Sceglierne uno con «index», come in %2=2.</translation>
    </message>
    <message>
        <source>it has no further axis &apos;%1&apos; for &apos;index&apos;.</source>
        <translation>non ha un ulteriore asse «%1» per «index».</translation>
    </message>
    <message>
        <source>it holds no values: its size is %1.</source>
        <translation>non contiene valori: la sua dimensione è %1.</translation>
    </message>
    <message>
        <source>it holds pictures, not volumes: it has fewer than three axes of space (its size is %1).</source>
        <translation>contiene immagini, non volumi: ha meno di tre assi spaziali (la sua dimensione è %1).</translation>
    </message>
    <message>
        <source>x, y and z along its axes %1, %2 and %3</source>
        <translation>x, y e z lungo i suoi assi %1, %2 e %3</translation>
    </message>
    <message>
        <source>Its axes x, y and z have different units, or none (%1), which are not converted.</source>
        <translation>I suoi assi x, y e z hanno unità diverse, o nessuna (%1), e non vengono convertite.</translation>
    </message>
    <message>
        <source>Its axes x, y and z have different units (%1): all are converted to %2.</source>
        <translation>I suoi assi x, y e z hanno unità diverse (%1): tutte vengono convertite in %2.</translation>
    </message>
    <message>
        <source>its scale along an axis of space is 0. Export it again.</source>
        <translation>la sua scala lungo un asse spaziale è 0. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>Its attributes %1 are not used: the stored values are.</source>
        <translation>I suoi attributi %1 non vengono usati: i valori sono come sono memorizzati.</translation>
    </message>
    <message>
        <source>It holds %1 arrays of volumes; the others are not read. Choose one with &apos;array&apos;.</source>
        <translation>Contiene %1 array di volumi; gli altri non vengono letti. Sceglierne uno con «array».</translation>
    </message>
    <message>
        <source>its level &apos;%1&apos; has %2 axes, and it describes %3. Export it again.</source>
        <translation>il suo livello «%1» ha %2 assi, e ne sono descritti %3. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its level &apos;%1&apos; is missing. The copy is not complete: copy the folder again, or choose another level with &apos;part&apos;.</source>
        <translation>il suo livello «%1» non c&apos;è. La copia non è completa: copiare di nuovo la cartella, o scegliere un altro livello con «part».</translation>
    </message>
    <message>
        <source>it is damaged: %1. Copy or export it again.</source>
        <translation>è danneggiato: %1. Copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it unpacks to more than the expected %1 bytes</source>
        <translation>decompresso dà più dei %1 byte che dovrebbe dare</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>non si può decomprimere</translation>
    </message>
    <message>
        <source>Zstandard says &apos;%1&apos;</source>
        <translation>Zstandard segnala «%1»</translation>
    </message>
    <message>
        <source>it does not begin like Blosc data, or is cut short</source>
        <translation>non comincia come scrive Blosc, o è troncato</translation>
    </message>
    <message>
        <source>it unpacks to %1 bytes, more than the expected %2</source>
        <translation>decompresso dà %1 byte, più dei %2 che dovrebbe dare</translation>
    </message>
    <message>
        <source>Blosc cannot unpack it (%1)</source>
        <translation>Blosc non riesce a decomprimerlo (%1)</translation>
    </message>
    <message>
        <source>its checksum is wrong</source>
        <translation>la sua somma di controllo è sbagliata</translation>
    </message>
    <message>
        <source>its differences of numbers of 16 bits (the filter &apos;delta&apos;) are not read. Write it without them.</source>
        <translation>le sue differenze di numeri a 16 bit (il filtro «delta») non si leggono. Scriverlo senza.</translation>
    </message>
    <message>
        <source>it has %1 bytes, more than its %2 bytes of numbers can yield</source>
        <translation>ha %1 byte, più di quanti ne possano risultare dai suoi %2 byte di numeri</translation>
    </message>
    <message>
        <source>it has %1 bytes of numbers instead of %2</source>
        <translation>ha %1 byte di numeri invece di %2</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; cannot be read (%2). Check its permissions.</source>
        <translation>il suo file «%1» non si può leggere (%2). Controllarne i permessi.</translation>
    </message>
    <message>
        <source>it cannot be read (%1). Check the name and the permissions.</source>
        <translation>non si può leggere (%1). Controllare il nome e i permessi.</translation>
    </message>
    <message>
        <source>it refers to &apos;%1&apos;, which is not a path inside the folder. Only what is in the folder is read.</source>
        <translation>nomina «%1», che non è un percorso all&apos;interno della cartella. Si legge solo ciò che si trova nella cartella.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is a link to something that does not exist. Copy the folder together with the targets of its links.</source>
        <translation>il suo elemento «%1» è un collegamento a qualcosa che non c&apos;è. Copiare la cartella con ciò a cui portano i suoi collegamenti.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is a link that leads out of the folder. Only what is in the folder is read: put a copy in its place.</source>
        <translation>il suo elemento «%1» è un collegamento che porta fuori dalla cartella. Si legge solo ciò che si trova nella cartella: metterne una copia al suo posto.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is not a file. Copy or export it again.</source>
        <translation>il suo elemento «%1» non è un file. Copiare o esportare di nuovo la cartella.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; is larger than metadata are (%2). It is damaged, or not Zarr.</source>
        <translation>il suo file «%1» è più grande di quanto lo siano dei metadati (%2). È danneggiato, o non è Zarr.</translation>
    </message>
    <message>
        <source>its &apos;%1&apos; %2</source>
        <translation>il suo file «%1» %2</translation>
    </message>
    <message>
        <source>is not JSON: %1 at byte %2. Copy or export it again.</source>
        <translation>non è JSON: %1 al byte %2. Copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>holds no JSON object. Copy or export it again.</source>
        <translation>non contiene un oggetto JSON. Copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>its file &apos;%1&apos; was changed while it was read. Try again.</source>
        <translation>il suo file «%1» è cambiato durante la lettura. Riprovare.</translation>
    </message>
    <message>
        <source>none of the %1 files with its values exists, such as &apos;%2&apos;. The copy is not complete, or they were never written: copy or export it again.</source>
        <translation>nessuno dei %1 file con i suoi valori è presente, per esempio «%2». La copia non è completa, o non sono mai stati scritti: copiarlo o esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>%1 of its %2 chunks are missing: as the format specifies, their values are the fill value %3.</source>
        <translation>%1 dei suoi %2 blocchi (chunk) non ci sono: come prevede il formato, i loro valori sono il valore di riempimento %3.</translation>
    </message>
    <message>
        <source>%1 of its %2 chunks are missing, and it has no fill value: %3 is assumed.</source>
        <translation>%1 dei suoi %2 blocchi (chunk) non ci sono, e non ha un valore di riempimento: si assume %3.</translation>
    </message>
    <message>
        <source>it lies in %1 files, more than %2. Write it in larger chunks.</source>
        <translation>si trova in %1 file, più di %2. Scriverlo in blocchi (chunk) più grandi.</translation>
    </message>
    <message>
        <source>none of its %1 chunks was written. Export it again.</source>
        <translation>nessuno dei suoi %1 blocchi (chunk) è stato scritto. Esportarlo di nuovo.</translation>
    </message>
    <message>
        <source>it is shorter than the index of its chunks</source>
        <translation>è più corto dell&apos;indice dei suoi blocchi (chunk)</translation>
    </message>
    <message>
        <source>the checksum of the index of its chunks is wrong</source>
        <translation>la somma di controllo dell&apos;indice dei suoi blocchi (chunk) è sbagliata</translation>
    </message>
    <message>
        <source>the index of its chunks points beyond its end</source>
        <translation>l&apos;indice dei suoi blocchi (chunk) porta oltre la sua fine</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;index&apos; is not understood. Give the name of each axis with a number from 1, as in angle=3,type=1.</source>
        <translation>«%1» per «index» non si capisce. Indicare il nome di ogni asse con un numero da 1, come in angle=3,type=1.</translation>
    </message>
    <message>
        <source>Zarr groups: the array to take, or the image, by its path in the folder; &apos;automatic&apos; takes the first.</source>
        <translation>Di gruppi Zarr: l&apos;array da prendere, o l&apos;immagine, con il suo percorso nella cartella; «automatic» prende il primo.</translation>
    </message>
    <message>
        <source>OME-Zarr with several images: one, by its path or number from 1; by default the first.</source>
        <translation>Di OME-Zarr con più immagini: una, con il suo percorso o il numero da 1; se vuoto la prima.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Livello</translation>
    </message>
    <message>
        <source>OME-Zarr: the level of detail, by its path or by its number, 0 being the finest, which is the default.</source>
        <translation>Di OME-Zarr: il livello di dettaglio, con il suo percorso o il suo numero, dove 0 è il più fine; se vuoto quello.</translation>
    </message>
    <message>
        <source>Pictures at several times: which one, from 1; 0 takes the first.</source>
        <translation>Di immagini a più tempi: quale, da 1; 0 prende la prima.</translation>
    </message>
    <message>
        <source>Further axes</source>
        <translation>Altri assi</translation>
    </message>
    <message>
        <source>Arrays with more axes than space, time and channels: the number along each, from 1, as in angle=3; an axis without a name is called by its number from 1. By default the first is taken.</source>
        <translation>Di array con altri assi oltre a spazio, tempo e canali: il numero lungo ciascuno di essi, da 1, come in angle=3; un asse senza nome si indica con il suo numero da 1. Altrimenti si prende il primo.</translation>
    </message>
    <message>
        <source>it is neither a Zarr folder nor a file that describes one (zarr.json, .zarray, .zattrs, .zgroup). Let TAn choose the reader.</source>
        <translation>non è una cartella Zarr, né un file che ne descrive una (zarr.json, .zarray, .zattrs, .zgroup). Lasciare a TAn la scelta della lettura.</translation>
    </message>
    <message>
        <source>Install the package tan-vtk-readers, which comes with TAn: &apos;apt install ./tan-vtk-readers_*.deb&apos; in the folder of that file (if you built TAn yourself: rebuild it after &apos;apt install libblosc-dev libzstd-dev&apos;), or save the array as NumPy&apos;s (.npy).</source>
        <translation>Installare il pacchetto tan-vtk-readers, fornito con TAn: «apt install ./tan-vtk-readers_*.deb» nella cartella in cui si trova il file (se TAn è stato compilato in proprio: ricompilarlo dopo «apt install libblosc-dev libzstd-dev»), o salvare l&apos;array nel formato di NumPy (.npy).</translation>
    </message>
    <message>
        <source>Install Blosc and Zstandard with &apos;apt install libblosc1 libzstd1&apos;.</source>
        <translation>Installare Blosc e Zstandard con «apt install libblosc1 libzstd1».</translation>
    </message>
    <message>
        <source>Copy or export it again, or save the array as NumPy&apos;s (.npy).</source>
        <translation>Copiarlo o esportarlo di nuovo, o salvare l&apos;array nel formato di NumPy (.npy).</translation>
    </message>
    <message>
        <source>Zarr, OME-Zarr (*.zarr zarr.json .zattrs .zgroup .zarray)</source>
        <translation>Zarr, OME-Zarr (*.zarr zarr.json .zattrs .zgroup .zarray)</translation>
    </message>
    <message>
        <source>Install the HDF5 library with &apos;apt install libhdf5-103-1&apos;.</source>
        <translation>Installare la libreria HDF5 con «apt install libhdf5-103-1».</translation>
    </message>
    <message>
        <source>a MATLAB file older than version 7.3</source>
        <translation>un file MATLAB anteriore alla versione 7.3</translation>
    </message>
    <message>
        <source>Save the array with the option &apos;-v7.3&apos;, or as NIfTI, by niftiwrite().</source>
        <translation>Salvare l&apos;array con l&apos;opzione «-v7.3», o come NIfTI, con niftiwrite().</translation>
    </message>
    <message>
        <source>The scale &apos;%1&apos; is not understood. Give &apos;linear&apos;, &apos;log&apos;, or &apos;log:&apos; and the positive number that replaces smaller values, as in log:1e-6.</source>
        <translation>La scala «%1» non è comprensibile. Indicare «linear», «log», oppure «log:» seguito dal numero positivo che prende il posto dei valori minori, come in log:1e-6.</translation>
    </message>
    <message>
        <source>None of the %1 values is positive, so they have no logarithms. Choose the linear scale.</source>
        <translation>Nessuno dei %1 valori è positivo, quindi non hanno logaritmi. Usare la scala lineare.</translation>
    </message>
    <message>
        <source>No value is larger than %1, which is to replace smaller ones: the largest is %2. Give a smaller number.</source>
        <translation>Nessun valore è maggiore di %1, il numero che deve prendere il posto dei valori minori: il massimo è %2. Indicare un numero più piccolo.</translation>
    </message>
    <message>
        <source>%1 of %2 values are not positive, so they have no logarithm. The smallest positive value is %3: with the scale log:%3 smaller ones are replaced by that value.</source>
        <translation>%1 di %2 valori non sono positivi, quindi non hanno logaritmo. Il minimo valore positivo è %3: con la scala log:%3 questo valore prende il posto di quelli minori.</translation>
    </message>
    <message>
        <source>%1 of %2 values are smaller than %3, and were replaced by %3.</source>
        <translation>%1 di %2 valori sono minori di %3, e sono stati presi come %3.</translation>
    </message>
    <message>
        <source>Not enough memory for the logarithms of the values. Take a part of the data.</source>
        <translation>La memoria non basta per i logaritmi dei valori. Prendere una parte dei dati.</translation>
    </message>
    <message>
        <source>error in the grid</source>
        <translation>errore nella griglia</translation>
    </message>
    <message>
        <source>error in space</source>
        <translation>errore nello spazio</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>errori</translation>
    </message>
    <message>
        <source>errors in the grid</source>
        <translation>errori nella griglia</translation>
    </message>
    <message>
        <source>errors in space</source>
        <translation>errori nello spazio</translation>
    </message>
    <message>
        <source>Error in the grid</source>
        <translation>Errore nella griglia</translation>
    </message>
    <message>
        <source>Error in space</source>
        <translation>Errore nello spazio</translation>
    </message>
    <message>
        <source>in the grid; in space it may be larger</source>
        <translation>nella griglia; nello spazio può essere maggiore</translation>
    </message>
    <message>
        <source>in the grid and in space</source>
        <translation>nella griglia e nello spazio</translation>
    </message>
    <message>
        <source>The guarantee is for the error in the grid; the error in space, at the place where you look, may be larger.</source>
        <translation>È garantito l&apos;errore nella griglia; l&apos;errore nello spazio, nel punto che si guarda, può essere maggiore.</translation>
    </message>
    <message>
        <source>The error in the grid and the error in space, at the place where you look, are both guaranteed at every accuracy; in a focus or a field, the error in the grid alone.</source>
        <translation>L&apos;errore nella griglia e l&apos;errore nello spazio, nel punto che si guarda, sono entrambi garantiti a ogni accuratezza; in un focus o in un campo d&apos;errore, solo l&apos;errore nella griglia.</translation>
    </message>
    <message>
        <source>&apos;tan verify&apos; measures the error in space.</source>
        <translation>«tan verify» misura l&apos;errore nello spazio.</translation>
    </message>
    <message>
        <source>The isovalue %1 is within the displayed error, %2, of the end of the data range, %3: what you see of its surface may be error alone.</source>
        <translation>L&apos;isovalore %1 dista dall&apos;estremo dei valori dei dati, %3, non più dell&apos;errore mostrato, %2: ciò che si vede della sua superficie può essere soltanto errore.</translation>
    </message>
    <message>
        <source>The isovalue %1 is within the displayed error, %2, of %3, the value of most of the domain: what you see of its surface may be error alone.</source>
        <translation>L&apos;isovalore %1 dista da %3, il valore della maggior parte del dominio, non più dell&apos;errore mostrato, %2: ciò che si vede della sua superficie può essere soltanto errore.</translation>
    </message>
    <message>
        <source>The transfer function shows values from %1 on, which is within the displayed error, %2, of %3, the value of most of the domain: what you see there may be error alone.</source>
        <translation>La funzione di trasferimento mostra i valori a partire da %1, che dista da %3, il valore della maggior parte del dominio, non più dell&apos;errore mostrato, %2: ciò che si vede lì può essere soltanto errore.</translation>
    </message>
    <message>
        <source>The values that the transfer function shows around %1 span less than the displayed error, %2: the mesh cannot distinguish them from others.</source>
        <translation>I valori che la funzione di trasferimento mostra attorno a %1 formano un intervallo più stretto dell&apos;errore mostrato, %2: la mesh non può distinguerli da altri.</translation>
    </message>
    <message>
        <source>Choose other values.</source>
        <translation>Scegliere altri valori.</translation>
    </message>
    <message>
        <source>An error of at most %1 % would be enough, everywhere or for values near %2 alone.</source>
        <translation>Basterebbe un errore di al massimo %1 %, ovunque o solo per i valori vicini a %2.</translation>
    </message>
    <message>
        <source>Lit</source>
        <translation>Illuminato</translation>
    </message>
    <message>
        <source>Lights surfaces in the colours of values, so that their shape is easier to see; their colours then differ from those of the colour bar.</source>
        <translation>Illumina le superfici nei colori dei valori, così che se ne veda meglio la forma; i loro colori non sono più quelli della barra dei colori.</translation>
    </message>
    <message>
        <source>The preset covers 0 to 1, and is stretched over the values of the data, %1 to %2.</source>
        <translation>La preimpostazione va da 0 a 1 e viene estesa a tutti i valori dei dati, da %1 a %2.</translation>
    </message>
    <message>
        <source>it has no time step at %1. The nearest one is number %2, at %3.</source>
        <translation>non ha un passo temporale a %1. Il più vicino è il numero %2, a %3.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; for &apos;--time&apos; is not understood. Give the number of a time step, from 1, &apos;first&apos;, &apos;last&apos;, or a time, as in t=0.25.</source>
        <translation>«%1» per «--time» non è comprensibile. Indicare il numero di un passo temporale, da 1, «first», «last», o un tempo, come in t=0.25.</translation>
    </message>
    <message>
        <source>it has more time steps than can be listed. Give the number of one, from 1, for &apos;--time&apos;.</source>
        <translation>ha più passi temporali di quanti se ne possano elencare. Indicare per «--time» il numero di uno di essi, da 1.</translation>
    </message>
    <message>
        <source>it has one time step, and states no time. Leave &apos;--time&apos; out.</source>
        <translation>ha un solo passo temporale, e non indica alcun tempo. Omettere «--time».</translation>
    </message>
    <message>
        <source>The series holds %1 volumes; the others are not read. Choose one with &apos;--time&apos;.</source>
        <translation>La serie contiene %1 volumi; gli altri non vengono letti. Sceglierne uno con «--time».</translation>
    </message>
    <message>
        <source>It has %1 time steps; the others are not read. Choose one with &apos;--time&apos;.</source>
        <translation>Ha %1 passi temporali; gli altri non vengono letti. Sceglierne uno con «--time».</translation>
    </message>
    <message>
        <source>the array&apos;s dimensions are z, y, x</source>
        <translation>le dimensioni dell&apos;array sono z, y, x</translation>
    </message>
    <message>
        <source>the array&apos;s dimensions are x, y, z</source>
        <translation>le dimensioni dell&apos;array sono x, y, z</translation>
    </message>
    <message>
        <source>the array&apos;s dimensions are x, y, z; give &apos;--axes zyx&apos; if they are z, y, x, as in stacks of images</source>
        <translation>le dimensioni dell&apos;array sono x, y, z; indicare «--axes zyx» se sono z, y, x, come quelle delle pile di immagini</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>NumPy arrays: whether they are indexed as array[x, y, z], or as array[z, y, x], as stacks of images by scikit-image, imageio and tifffile are.</source>
        <translation>Array NumPy: se sono indicizzati come array[x, y, z], o come array[z, y, x], come le pile di immagini di scikit-image, imageio e tifffile.</translation>
    </message>
    <message>
        <source>&apos;--%1&apos; says how a NumPy array is indexed, and &apos;%2&apos; is not one. Leave it out.</source>
        <translation>«--%1» dice come è indicizzato un array NumPy, e «%2» non lo è. Ometterlo.</translation>
    </message>
    <message>
        <source>Its values &apos;%1&apos; at the corners of elements are not read: elements that share a node may have different ones there.</source>
        <translation>I suoi valori «%1» ai vertici degli elementi non vengono letti: elementi che condividono un nodo possono averne lì di diversi.</translation>
    </message>
    <message>
        <source>None of the isovalues lies within the model&apos;s values, %1 to %2, so their surfaces are empty.</source>
        <translation>Nessuno degli isovalori è fra i valori del modello, da %1 a %2, perciò le loro superfici sono vuote.</translation>
    </message>
    <message>
        <source>Only curvilinear grids can be decimated in one space or the other, and &apos;%1&apos; is not one.</source>
        <translation>Solo le griglie curvilinee possono essere decimate in uno spazio o nell&apos;altro, e «%1» non lo è.</translation>
    </message>
    <message>
        <source>The grid &apos;%1&apos; cannot be used as a mesh: %2 Refine it instead.</source>
        <translation>La griglia «%1» non può essere presa come mesh: %2 Raffinarla invece.</translation>
    </message>
    <message>
        <source>The grid has %1 cells, whose mesh takes up to %2 of memory, of %3. Refine it instead, or take a region of it or fewer samples.</source>
        <translation>La griglia ha %1 celle, la cui mesh richiede fino a %2 di memoria, su %3. Raffinarla invece, oppure prenderne una parte o meno campioni.</translation>
    </message>
    <message>
        <source>%1 of its points lie at the same place as another and have another value.</source>
        <translation>%1 dei suoi punti si trovano nel posto di un altro e hanno un altro valore.</translation>
    </message>
    <message>
        <source>%1 of its cells are folded, overlap others, or are so warped that no tetrahedra fill them.</source>
        <translation>%1 delle sue celle sono piegate, si sovrappongono ad altre o sono così deformate che nessun tetraedro le riempie.</translation>
    </message>
    <message>
        <source>%1 of its points belong only to cells without volume.</source>
        <translation>%1 dei suoi punti appartengono solo a celle senza volume.</translation>
    </message>
    <message>
        <source>it has %1 points, and the limit is %2.</source>
        <translation>ha %1 punti, e il massimo è %2.</translation>
    </message>
    <message>
        <source>%1 corners of its cells are folded.</source>
        <translation>%1 angoli delle sue celle sono piegati.</translation>
    </message>
    <message>
        <source>For grids whose points lie anywhere: &apos;physical&apos; builds where they lie, by decimation from the mesh of the grid&apos;s cells, or by refinement (of rectilinear grids) from the points alone; &apos;computational&apos; by their indices, as the paper did, which takes less memory and supports blocks.</source>
        <translation>Per griglie i cui punti si trovano ovunque: «fisico» costruisce dove si trovano, per decimazione dalla mesh delle celle della griglia, per raffinamento (di griglie rettilinee) dai soli punti; «computazionale» secondo i loro indici, come nell&apos;articolo, il che richiede meno memoria e permette i blocchi.</translation>
    </message>
    <message>
        <source>A curvilinear grid: decimation uses the mesh of its cells, and needs the fewest tetrahedra for an error in space, where the points lie.</source>
        <translation>Una griglia curvilinea: la decimazione prende la mesh delle sue celle e richiede il minor numero di tetraedri per un errore nello spazio, cioè dove si trovano i punti.</translation>
    </message>
    <message>
        <source>For curvilinear data: &apos;grid&apos; keeps the error in the grid, at the points&apos; indices, as the paper did; &apos;space&apos; also the error in space, where the points lie, which is what you see. That takes more vertices and time, and the whole grid in memory. &apos;automatic&apos; keeps both for grids of up to a million points that are refined as a whole, using both thresholds.</source>
        <translation>Per dati curvilinei: «nella griglia» mantiene l&apos;errore nella griglia, agli indici dei punti, come nell&apos;articolo; «nello spazio» anche l&apos;errore nello spazio, dove si trovano i punti, cioè quello che si vede. Ciò richiede più vertici e tempo, e tutta la griglia in memoria. «automatico» li mantiene entrambi per griglie fino a un milione di punti raffinate per intero e secondo entrambe le soglie.</translation>
    </message>
    <message>
        <source>A curvilinear grid: refinement in computational space bounds the error in the grid and the warping, even where cells of the grid are folded, and can bound the error in space.</source>
        <translation>Una griglia curvilinea: il raffinamento nello spazio computazionale limita l&apos;errore nella griglia e la deformazione, anche dove le celle della griglia sono piegate, e può limitare l&apos;errore nello spazio.</translation>
    </message>
    <message>
        <source>it is a list of EnSight cases, which VTK 9.1 does not read. Open one of the cases that it names.</source>
        <translation>è un elenco di casi EnSight, che VTK 9.1 non legge. Aprire uno dei casi che nomina.</translation>
    </message>
    <message>
        <source>its files refer to each other more than %1 levels deep.</source>
        <translation>i suoi file si nominano a vicenda per più di %1 livelli.</translation>
    </message>
    <message>
        <source>it refers to the file &apos;%1&apos;, which refers back to it.</source>
        <translation>nomina il file «%1», che a sua volta lo nomina.</translation>
    </message>
    <message>
        <source>it lists the file &apos;%1&apos; twice for one time. Write each part once.</source>
        <translation>nomina il file «%1» due volte per un istante. Scrivere ogni parte una volta.</translation>
    </message>
    <message>
        <source>its chunks were passed through %1 codecs, more than %2</source>
        <translation>i suoi blocchi (chunk) sono passati per %1 codec, più di %2</translation>
    </message>
    <message>
        <source>the values of one of its arrays lie in other files or arrays, which are not opened. Copy them into an array of their own, for instance with h5py.</source>
        <translation>i valori di uno dei suoi array si trovano in altri file o array, che non vengono aperti. Copiarli in un array proprio, per esempio con h5py.</translation>
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
        <translation>la %1 o un commento che la precede supera %2 byte, perciò non è di una tabella di punti.</translation>
    </message>
    <message>
        <source>%1 has %2 columns, and at most %3 are read. Write a file with only the columns of positions and values that you need.</source>
        <translation>la %1 ha %2 colonne, e se ne leggono al massimo %3. Scrivere un file con le colonne delle posizioni e dei valori che servono.</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>un numero maggiore di 0</translation>
    </message>
    <message>
        <source>a factor of %1</source>
        <translation>fattore %1</translation>
    </message>
    <message>
        <source>HDF5 (*.h5 *.hdf5 *.hdf *.he5 *.nxs *.nx5 *.mat *.ims)</source>
        <translation>HDF5 (*.h5 *.hdf5 *.hdf *.he5 *.nxs *.nx5 *.mat *.ims)</translation>
    </message>
    <message>
        <source>&apos;ExtMin&apos; and &apos;ExtMax&apos; of Imaris</source>
        <translation>«ExtMin» e «ExtMax» di Imaris</translation>
    </message>
    <message>
        <source>It has %1 levels of detail, 0 being the finest; the others are not read. Choose one by its array, such as &apos;%2&apos;.</source>
        <translation>Ha %1 livelli di dettaglio, di cui 0 è il più fine; gli altri non vengono letti. Sceglierne uno con il suo array, per esempio «%2».</translation>
    </message>
    <message>
        <source>%1 has values whose closing bracket directly follows the last one, of which VTK then drops a digit. Put an end of line before the bracket, or export the file again.</source>
        <translation>%1 ha valori la cui parentesi sta subito dietro l&apos;ultimo, del quale VTK tralascia allora una cifra. Mettere un a capo prima della parentesi, o esportare di nuovo il file.</translation>
    </message>
    <message>
        <source>it lists %1 files %2 times in all.</source>
        <translation>nomina %1 file %2 volte in tutto.</translation>
    </message>
    <message>
        <source>names more than %1 variables. Take out those that are not needed.</source>
        <translation>nomina più di %1 variabili. Togliere quelle che non servono.</translation>
    </message>
    <message>
        <source>it has more than %1 zones. Write files of fewer zones.</source>
        <translation>ha più di %1 zone. Scrivere file con meno zone.</translation>
    </message>
    <message>
        <source>Its chunks are unpacked whole, however little of them is needed, which takes %1 MB of memory.</source>
        <translation>I suoi blocchi (chunk) vengono spacchettati per intero, per quanto poco ne serva: occorrono %1 MB di memoria.</translation>
    </message>
    <message>
        <source>its model cannot have %1 bytes</source>
        <translation>il suo modello non può avere %1 byte</translation>
    </message>
    <message>
        <source>It is written for plugin interface %1 of an earlier TAn, and this program has %2. Install a newer version of the plugin, or build it again with the headers of this TAn.</source>
        <translation>È scritto per l&apos;interfaccia dei plugin %1 di un TAn precedente, e questo programma ha la %2. Installare una versione più recente del plugin, o ricompilarlo con gli header di questo TAn.</translation>
    </message>
    <message>
        <source>It was built for an earlier version of TAn. Install a later version of the plugin, or build it again with the headers of this TAn.</source>
        <translation>È stato compilato per una versione precedente di TAn. Installare una versione più recente del plugin, o ricompilarlo con gli header di questo TAn.</translation>
    </message>
    <message>
        <source>it is not a shared library for this machine.</source>
        <translation>non è una libreria condivisa per questa macchina.</translation>
    </message>
    <message>
        <source>it ends too early.</source>
        <translation>finisce troppo presto.</translation>
    </message>
    <message>
        <source>Its metadata are malformed: %1 Ask the plugin&apos;s author for a fixed version.</source>
        <translation>I suoi metadati non sono corretti: %1 Chiedere all&apos;autore del plugin una versione corretta.</translation>
    </message>
    <message>
        <source>its metadata are damaged.</source>
        <translation>i suoi metadati sono danneggiati.</translation>
    </message>
    <message>
        <source>it has no metadata.</source>
        <translation>non ha metadati.</translation>
    </message>
    <message>
        <source>The view cannot be read: %1</source>
        <translation>La vista non può essere letta: %1</translation>
    </message>
    <message>
        <source>it must be an object, in braces.</source>
        <translation>deve essere un oggetto, tra graffe.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a plane: give x, y or z and a position, as in z=12.5, or nx,ny,nz,offset for the points with nx x + ny y + nz z = offset, the first three not all zero.</source>
        <translation>«%1» non è un piano: dare x, y o z con una posizione, come z=12.5, oppure nx,ny,nz,distanza per i punti con nx x + ny y + nz z = distanza, i primi tre non tutti nulli.</translation>
    </message>
    <message>
        <source>The plane &apos;%1&apos; misses the data, which extend from %2 to %3 in its direction.</source>
        <translation>Il piano «%1» non incontra i dati, che nella sua direzione vanno da %2 a %3.</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>massimo</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>minimo</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Proiezione</translation>
    </message>
    <message>
        <source>Which value along each line of sight is shown: the largest (&apos;maximum&apos;) or the smallest (&apos;minimum&apos;).</source>
        <translation>Quale valore lungo ogni linea di vista si mostra: il più grande («massimo») o il più piccolo («minimo»).</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tutti</translation>
    </message>
    <message>
        <source>opaque</source>
        <translation>opaca</translation>
    </message>
    <message>
        <source>function</source>
        <translation>funzione</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Asse</translation>
    </message>
    <message>
        <source>The axis perpendicular to the plane; &apos;all&apos; shows three planes, one for each axis.</source>
        <translation>L&apos;asse a cui il piano è perpendicolare; «tutti» mostra tre piani, uno per ciascuno.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Where the plane lies along its axis: 0 where the data begin, 100 where they end.</source>
        <translation>Dove si trova il piano lungo il suo asse: a 0 dove i dati iniziano, a 100 dove finiscono.</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Piani</translation>
    </message>
    <message>
        <source>Planes instead of those perpendicular to the axes: each by its axis and its position in the coordinates of the data, as in z=12.5, or in any direction: nx,ny,nz,offset, for the points with nx x + ny y + nz z = offset.</source>
        <translation>Piani al posto di quelli degli assi: ciascuno con il suo asse e la sua posizione nelle coordinate dei dati, come z=12.5, o in qualsiasi direzione: nx,ny,nz,distanza, per i punti con nx x + ny y + nz z = distanza.</translation>
    </message>
    <message>
        <source>Whether slices hide what is behind them (&apos;opaque&apos;), or each value is as opaque as the transfer &apos;function&apos; makes a layer of its unit of thickness.</source>
        <translation>Se le sezioni nascondono ciò che sta dietro («opaca») o se ogni valore è opaco quanto la «funzione» di trasferimento rende uno strato del suo spessore unitario.</translation>
    </message>
    <message>
        <source>The slices have their default position: the saved ones are for another domain.</source>
        <translation>Le sezioni sono come all&apos;inizio: i loro piani sono di un altro dominio.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>%1 %2 at the target</source>
        <translation>%1 %2 alla distanza del punto mirato</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>1 unit at the target</source>
        <translation>1 unità alla distanza del punto mirato</translation>
    </message>
    <message>
        <source>1 unit</source>
        <translation>1 unità</translation>
    </message>
    <message>
        <source>%1 units at the target</source>
        <translation>%1 unità alla distanza del punto mirato</translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation>%1 unità</translation>
    </message>
    <message>
        <source>This system has no font to write into pictures. Install one, such as the package fonts-dejavu-core of Debian, or take the picture without annotations.</source>
        <translation>Questo sistema non ha nessun tipo di carattere per scrivere nelle immagini. Installarne uno, come il pacchetto fonts-dejavu-core di Debian, o fare l&apos;immagine senza annotazioni.</translation>
    </message>
    <message>
        <source>No renderer plugin could be loaded, so there is no way to show a model. %1</source>
        <translation>Nessun plugin di resa ha potuto essere caricato, perciò non c&apos;è modo di mostrare un modello. %1</translation>
    </message>
    <message>
        <source>There is no frame %1 in this film, which has %2 of them.</source>
        <translation>Questo filmato non ha il fotogramma %1: ne ha %2.</translation>
    </message>
    <message>
        <source>%1 %2 in the focus, %3 outside</source>
        <translation>%1 %2 nel focus, %3 all&apos;esterno</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 da %2 a %3</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1, in space up to %2</source>
        <translation>%1, nello spazio fino a %2</translation>
    </message>
    <message>
        <source>%1 (in space up to %2)</source>
        <translation>%1 (nello spazio fino a %2)</translation>
    </message>
    <message>
        <source>What tools have in the picture is left out: it is for another domain.</source>
        <translation>Ciò che gli strumenti hanno nell&apos;immagine è tralasciato: vale per un altro dominio.</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>strumento</translation>
    </message>
    <message>
        <source>&quot;kind&quot; is &quot;%1&quot;, which is not one of builder, renderer, reader, writer, editor, tool</source>
        <translation>«kind» è «%1», che non è nessuno di builder, renderer, reader, writer, editor, tool</translation>
    </message>
    <message>
        <source>what it keeps is too long</source>
        <translation>ciò che conserva è troppo lungo</translation>
    </message>
    <message>
        <source>what it keeps is no text</source>
        <translation>ciò che conserva non è un testo</translation>
    </message>
    <message>
        <source>Clip plane</source>
        <translation>Piano di taglio</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Move Plane</source>
        <translation>Sposta piano</translation>
    </message>
    <message>
        <source>Turn Plane</source>
        <translation>Ruota piano</translation>
    </message>
    <message>
        <source>This rendering mode has neither clip planes nor slices.</source>
        <translation>Questa modalità di visualizzazione non ha né piani di taglio né sezioni.</translation>
    </message>
    <message>
        <source>Centre of the plane</source>
        <translation>Centro del piano</translation>
    </message>
    <message>
        <source>Direction of the plane</source>
        <translation>Direzione del piano</translation>
    </message>
    <message>
        <source>Add Plane</source>
        <translation>Aggiungi piano</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>What is moved: a plane that cuts the picture open, or one that shows the data.</source>
        <translation>Ciò che si muove: un piano che taglia l&apos;immagine, o uno che mostra i dati.</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Piano</translation>
    </message>
    <message>
        <source>Which of the planes is moved.</source>
        <translation>Quale dei piani si muove.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
    </message>
    <message>
        <source>Across the plane, along x, y and z; of a clip plane towards what is shown.</source>
        <translation>Perpendicolare al piano, lungo x, y e z; di un piano di taglio verso ciò che si mostra.</translation>
    </message>
    <message>
        <source>Place along it</source>
        <translation>Posizione lungo la direzione</translation>
    </message>
    <message>
        <source>How far the plane lies from the origin in its direction, in the data&apos;s unit of length.</source>
        <translation>Quanto il piano dista dall&apos;origine nella sua direzione, nell&apos;unità di lunghezza dei dati.</translation>
    </message>
    <message>
        <source>Choose Plane</source>
        <translation>Scegli piano</translation>
    </message>
    <message>
        <source>Cut through the middle of the data, across the axis that one looks along</source>
        <translation>Tagliare a metà i dati, perpendicolarmente all&apos;asse lungo cui si guarda</translation>
    </message>
    <message>
        <source>Flip Plane</source>
        <translation>Inverti piano</translation>
    </message>
    <message>
        <source>Show what was cut away, and cut away what was shown</source>
        <translation>Mostrare ciò che era tagliato e tagliare ciò che si mostrava</translation>
    </message>
    <message>
        <source>Align with Axis</source>
        <translation>Allinea a un asse</translation>
    </message>
    <message>
        <source>Turn the plane across the nearest axis; Shift does so while it is turned</source>
        <translation>Ruotare il piano perpendicolarmente all&apos;asse più vicino; Maiusc lo fa durante la rotazione</translation>
    </message>
    <message>
        <source>Remove Plane</source>
        <translation>Rimuovi piano</translation>
    </message>
    <message>
        <source>Remove the plane that is moved</source>
        <translation>Rimuovere il piano che si muove</translation>
    </message>
    <message>
        <source>%1 units of the file</source>
        <translation>%1 unità del file</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Place %1 of ruler %2</source>
        <translation>Punto %1 del righello %2</translation>
    </message>
    <message>
        <source>Measure Distance</source>
        <translation>Misura distanza</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>Misura angolo</translation>
    </message>
    <message>
        <source>Move Ruler</source>
        <translation>Sposta righello</translation>
    </message>
    <message>
        <source>Ruler %1</source>
        <translation>Righello %1</translation>
    </message>
    <message>
        <source>%1 and %2, %3 between them</source>
        <translation>%1 e %2, con %3 tra loro</translation>
    </message>
    <message>
        <source>New Ruler</source>
        <translation>Nuovo righello</translation>
    </message>
    <message>
        <source>Begin another ruler at the next click, without an angle</source>
        <translation>Iniziare un altro righello al prossimo clic, senza angolo</translation>
    </message>
    <message>
        <source>Remove Ruler</source>
        <translation>Rimuovi righello</translation>
    </message>
    <message>
        <source>Remove the selected ruler, or else the last one</source>
        <translation>Rimuovere il righello selezionato, o altrimenti l&apos;ultimo</translation>
    </message>
    <message>
        <source>Remove All Rulers</source>
        <translation>Rimuovi tutti i righelli</translation>
    </message>
    <message>
        <source>Remove all rulers from the picture</source>
        <translation>Rimuovere tutti i righelli dall&apos;immagine</translation>
    </message>
    <message>
        <source>Remove Rulers</source>
        <translation>Rimuovi righelli</translation>
    </message>
    <message>
        <source>Complete Ruler</source>
        <translation>Completa righello</translation>
    </message>
    <message>
        <source>Opacity of the boundary</source>
        <translation>Opacità del contorno</translation>
    </message>
    <message>
        <source>The setting &apos;%1&apos; cannot be used: %2</source>
        <translation>L’impostazione «%1» non è utilizzabile: %2</translation>
    </message>
    <message>
        <source>its table for the loader is damaged.</source>
        <translation>la sua tabella per il caricatore è danneggiata.</translation>
    </message>
    <message>
        <source>It has no function %1, so it is not a complete plugin. Install it again, or ask its author for a complete one.</source>
        <translation>Non ha la funzione %1, quindi non è un plugin completo. Installarlo di nuovo o chiederne uno completo all’autore.</translation>
    </message>
    <message>
        <source>Some values of the model are not finite numbers, so no largest or smallest one can be shown. Choose another mode.</source>
        <translation>Alcuni valori del modello non sono numeri finiti, perciò non si può mostrare né il più grande né il più piccolo. Scegliere un’altra modalità.</translation>
    </message>
    <message>
        <source>Opacity of slices</source>
        <translation>Opacità delle sezioni</translation>
    </message>
    <message>
        <source>The table of an optical model has %1 entries; at most %2 can be used.</source>
        <translation>La tabella di un modello ottico ha %1 voci; se ne possono usare al massimo %2.</translation>
    </message>
    <message>
        <source>The plugin &apos;%1&apos; has an optical model with a table of %2 entries; at most %3 can be used. This is a fault of the plugin; tell its author.</source>
        <translation>Il plugin «%1» ha un modello ottico con una tabella di %2 voci; se ne possono usare al massimo %3. È un difetto del plugin; segnalarlo al suo autore.</translation>
    </message>
    <message>
        <source>Points that the moved boundary leaves outside the mesh are compared with a place within the warping; at the nearest place they may be off by more, which &apos;tan verify&apos; measures.</source>
        <translation>I punti che il bordo spostato lascia fuori dalla mesh sono confrontati con un luogo entro la deformazione; nel luogo più vicino possono scostarsi di più, il che è misurato da «tan verify».</translation>
    </message>
    <message>
        <source>Between vertices interpolate &apos;%1&apos;, and take the power of ten afterwards: the factor holds for that. &apos;%2&apos;, interpolated itself, may be off by much more.</source>
        <translation>Tra i vertici interpolare «%1» e prendere poi la potenza di dieci: il fattore vale per questo. «%2», interpolato direttamente, può scostarsi di molto di più.</translation>
    </message>
    <message>
        <source>The model has no finer mesh than this, which keeps less than requested.</source>
        <translation>Il modello non ha una mesh più fine di questa, che mantiene meno di quanto richiesto.</translation>
    </message>
    <message>
        <source>Lights the volume as if a surface lay perpendicular to the direction in which its values change most; the background is then dark, unless you choose another one.</source>
        <translation>Illumina il volume come se una superficie giacesse perpendicolare alla direzione in cui i valori cambiano di più; lo sfondo è allora scuro, se non se ne sceglie un altro.</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Osso</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Pelle</translation>
    </message>
    <message>
        <source>Flesh</source>
        <translation>Carne</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Acciaio</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Pietra</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Acqua</translation>
    </message>
    <message>
        <source>Chalk</source>
        <translation>Gesso</translation>
    </message>
    <message>
        <source>1 point belongs to no cell with a volume and was left out.</source>
        <translation>1 punto non appartiene a nessuna cella con un volume ed è stato omesso.</translation>
    </message>
    <message>
        <source>%1 points belong to no cell with a volume and were left out.</source>
        <translation>%1 punti non appartengono a nessuna cella con un volume e sono stati omessi.</translation>
    </message>
    <message>
        <source>Cells have a corner whose position is not finite, or too large to compute with (%1 in all, the first is cell %2). Correct the points, or blank the cells.</source>
        <translation>Delle celle hanno un vertice la cui posizione non è finita, o è troppo grande per i calcoli (%1 in tutto, la prima è la cella %2). Correggere i punti, o escludere le celle.</translation>
    </message>
    <message>
        <source>The mesh does not have a finite value for each point, and a finite position that is not too large to compute with.</source>
        <translation>La mesh non ha per ogni punto un valore finito e una posizione finita che non sia troppo grande per i calcoli.</translation>
    </message>
    <message>
        <source>more than %1 pairs of tetrahedra that overlap, one at %2</source>
        <translation>più di %1 coppie di tetraedri sovrapposti, uno in %2</translation>
    </message>
    <message>
        <source>the first axis, of %1 points; if it holds colours, the header has to say so (&apos;kinds: RGB-color domain domain&apos;)</source>
        <translation>il primo asse, di %1 punti; se contiene dei colori, l&apos;intestazione deve dirlo («kinds: RGB-color domain domain»)</translation>
    </message>
    <message>
        <source>it is not a PLOT3D file: it does not begin with the sizes of its grids. If it is of another program, export VTK, or a table of points with values.</source>
        <translation>non è un file PLOT3D: non comincia con le dimensioni delle griglie. Se è di un altro programma, esportare VTK o una tabella di punti con valori.</translation>
    </message>
    <message>
        <source>it has no array with a number for each point or cell. Write it with one, of points or cells that fill a volume.</source>
        <translation>non ha vettori con un numero per ogni punto o cella. Scriverlo con uno, di punti o celle che riempiano un volume.</translation>
    </message>
    <message>
        <source>Its units are not known: it has too many nodes to be looked at, or not those that CGNS&apos;s library writes.</source>
        <translation>Le sue unità non sono note: ha troppi nodi per esaminarli, o non quelli che scrive la libreria di CGNS.</translation>
    </message>
    <message>
        <source>All points of &apos;%1&apos; lie in a plane, or there are fewer than four. TAn needs points that have a volume between them.</source>
        <translation>Tutti i punti di «%1» giacciono in un piano, o sono meno di quattro. TAn ha bisogno di punti che racchiudano un volume.</translation>
    </message>
    <message>
        <source>The preset is for Hounsfield units, and the values are assumed to be these: they are whole numbers from %1 to %2.</source>
        <translation>La preimpostazione è per unità Hounsfield, e si assume che i valori lo siano: sono numeri interi da %1 a %2.</translation>
    </message>
    <message>
        <source>The preset is for Hounsfield units, which the data do not seem to have: it is stretched over their values, %1 to %2, as if these were -1024 to 3071.</source>
        <translation>La preimpostazione è per unità Hounsfield, che i dati non sembrano avere: viene distesa sui loro valori, da %1 a %2, come se fossero da -1024 a 3071.</translation>
    </message>
    <message>
        <source>This TAn was built without cairo, which writes PDF files. Save the picture as PNG.</source>
        <translation>Questo TAn è stato compilato senza cairo, che scrive i file PDF. Salvare l&apos;immagine come PNG.</translation>
    </message>
    <message>
        <source>The picture cannot be written as a PDF file: %1.</source>
        <translation>L&apos;immagine non può essere scritta come file PDF: %1.</translation>
    </message>
    <message>
        <source>JPEG pictures have no transparency. Save it as PNG, TIFF or PDF, or with a background.</source>
        <translation>Le immagini JPEG non hanno trasparenza. Salvarla come PNG, TIFF o PDF, o con uno sfondo.</translation>
    </message>
    <message>
        <source>This TAn was built without libjpeg, which writes JPEG files. Save the picture as PNG.</source>
        <translation>Questo TAn è stato compilato senza libjpeg, che scrive i file JPEG. Salvare l&apos;immagine come PNG.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not end in .png, .tif, .tiff, .jpg, .jpeg or .pdf, the formats in which pictures are written.</source>
        <translation>«%1» non termina in .png, .tif, .tiff, .jpg, .jpeg o .pdf, i formati in cui si scrivono le immagini.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be written: this TAn was built without the library for its format. Save the picture as PNG.</source>
        <translation>«%1» non può essere scritto: questo TAn è stato compilato senza la libreria per il suo formato. Salvare l&apos;immagine come PNG.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be transparent, as JPEG pictures have no transparency. Save it as PNG, TIFF or PDF, or with a background.</source>
        <translation>«%1» non può essere trasparente, perché le immagini JPEG non hanno trasparenza. Salvarla come PNG, TIFF o PDF, o con uno sfondo.</translation>
    </message>
    <message>
        <source>This TAn was built without libtiff, which writes TIFF files. Save the picture as PNG.</source>
        <translation>Questo TAn è stato compilato senza libtiff, che scrive i file TIFF. Salvare l&apos;immagine come PNG.</translation>
    </message>
    <message>
        <source>All its points lie in a plane: there is no volume between them, and no model can be built of them.</source>
        <translation>Tutti i punti giacciono in un piano: non racchiudono un volume, e non se ne può costruire un modello.</translation>
    </message>
    <message>
        <source>Reading the data</source>
        <translation>Lettura dei dati</translation>
    </message>
    <message>
        <source>The data of &apos;%1&apos; cannot be shown: %2 Put the file from which the model was built, &apos;%3&apos;, beside the model.</source>
        <translation>I dati di «%1» non possono essere mostrati: %2 Metti il file da cui il modello è stato costruito, «%3», accanto al modello.</translation>
    </message>
    <message>
        <source>the model holds %1 of the %2 samples.</source>
        <translation>il modello contiene %1 dei %2 campioni.</translation>
    </message>
    <message>
        <source>the file of that name beside it contains other values.</source>
        <translation>il file con quel nome accanto a esso contiene altri valori.</translation>
    </message>
    <message>
        <source>Not enough memory to show the data beside the mesh. Close other programs.</source>
        <translation>Memoria insufficiente per mostrare i dati accanto alla mesh. Chiudi altri programmi.</translation>
    </message>
    <message>
        <source>Only the samples of a lattice can be shown beside the mesh, and these data are %1.</source>
        <translation>Solo i campioni di un reticolo possono essere mostrati accanto alla mesh, e questi dati sono di tipo %1.</translation>
    </message>
    <message>
        <source>OpenGL does not draw the samples of a lattice, nor differences to them. Let the CPU draw this picture.</source>
        <translation>OpenGL non disegna i campioni di un reticolo né le differenze da essi. Fai disegnare questa immagine al processore.</translation>
    </message>
    <message>
        <source>Preparing the data</source>
        <translation>Preparazione dei dati</translation>
    </message>
    <message>
        <source>Only the samples of a whole lattice can be shown beside the mesh.</source>
        <translation>Solo i campioni di un reticolo intero possono essere mostrati accanto alla mesh.</translation>
    </message>
    <message>
        <source>The samples of the scene and their transfer function do not belong together.</source>
        <translation>I campioni della scena e la loro funzione di trasferimento non corrispondono.</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>mesh</translation>
    </message>
    <message>
        <source>data</source>
        <translation>dati</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>differenza</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>the data themselves</source>
        <translation>i dati stessi</translation>
    </message>
    <message>
        <source>difference to the data, %1 times as bright, of a mesh with %2</source>
        <translation>differenza dai dati, %1 volte più luminosa, di una mesh con %2</translation>
    </message>
    <message>
        <source>All values are the same, so there are no standard deviations. Give a value of the data.</source>
        <translation>Tutti i valori sono uguali, quindi non ci sono deviazioni standard. Indicare un valore dei dati.</translation>
    </message>
    <message>
        <source>The model is at its server and keeps no mean and no standard deviation of its values, as those of density maps do. Give a value of the data.</source>
        <translation>Il modello si trova sul suo server e non contiene la media e la deviazione standard dei suoi valori, come fanno quelli delle mappe di densità. Indicare un valore dei dati.</translation>
    </message>
    <message>
        <source>Not enough memory for the mean of the values. Give a value of the data.</source>
        <translation>La memoria non basta per la media dei valori. Indicare un valore dei dati.</translation>
    </message>
    <message>
        <source>What the volume is drawn from: the mesh; the samples of the data themselves, so that you see what the mesh leaves out; or the difference between the two pictures, made brighter. A moving picture always shows the mesh, and so does one with a focus, a crop box, a filter of values or a range of accuracies.</source>
        <translation>Da che cosa è disegnato il volume: dalla mesh; dai campioni dei dati stessi, così da vedere ciò che la mesh tralascia; oppure la differenza tra le due immagini, resa più luminosa. Un&apos;immagine in movimento mostra sempre la mesh, e così una con un fuoco, una finestra, un intervallo di valori o un intervallo di accuratezze.</translation>
    </message>
    <message>
        <source>%1; data are not shown with a range of accuracies</source>
        <translation>%1; con un intervallo di accuratezze i dati non sono mostrati</translation>
    </message>
    <message>
        <source>%1; data are not shown with a crop box</source>
        <translation>%1; con una finestra i dati non sono mostrati</translation>
    </message>
    <message>
        <source>%1; data are not shown with a filter of values</source>
        <translation>%1; con un intervallo di valori i dati non sono mostrati</translation>
    </message>
    <message>
        <source>%1; data are not shown with a focus</source>
        <translation>%1; con un fuoco i dati non sono mostrati</translation>
    </message>
    <message>
        <source>Full opacity at gradient</source>
        <translation>Opacità piena dal gradiente</translation>
    </message>
    <message>
        <source>Of a shaded volume, how steeply the values must change, in units of the values for one of length, to be as opaque as the transfer function says; where they change less, the opacity is less in proportion, so that boundaries stand out. 0: the opacity does not depend on it.</source>
        <translation>Quanto rapidamente devono cambiare i valori di un volume ombreggiato, in unità dei valori per unità di lunghezza, per essere opachi come dice la funzione di trasferimento; dove cambiano meno, l&apos;opacità è minore in proporzione, così che i confini risaltano. 0: l&apos;opacità non ne dipende.</translation>
    </message>
    <message>
        <source>%1 of %2 bookmarks cannot be shown as they were saved.</source>
        <translation>%1 segnalibri su %2 non possono essere mostrati come sono stati salvati.</translation>
    </message>
    <message>
        <source>The look is one of &apos;%1&apos;, and these values are &apos;%2&apos;: title and names are left out, and colours and isovalues are spread over the range of these.</source>
        <translation>L&apos;aspetto è di «%1», e questi valori sono «%2»: titolo e nomi sono omessi, e colori e isovalori sono distribuiti sull&apos;intervallo di questi.</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isosuperfici</translation>
    </message>
    <message>
        <source>Shows the isosurfaces beside the slices.</source>
        <translation>Mostra le isosuperfici accanto alle sezioni.</translation>
    </message>
    <message>
        <source>its meshes do not grow with their accuracy</source>
        <translation>le sue mesh non crescono con la loro accuratezza</translation>
    </message>
    <message>
        <source>work files %1</source>
        <translation>file di lavoro %1</translation>
    </message>
    <message>
        <source>A build is cut into parts where its blocks are. Choose the edge of a block, such as 32 cells.</source>
        <translation>Una costruzione si divide lungo i suoi blocchi. Scegliere lo spigolo di un blocco, per esempio 32 celle.</translation>
    </message>
    <message>
        <source>Waiting for part %1</source>
        <translation>In attesa della parte %1</translation>
    </message>
    <message>
        <source>Part %1 of %2 has done what it can until part %3 has found out what it needs of their common faces. Start it again after that: it goes on from here.</source>
        <translation>La parte %1 di %2 ha fatto quanto può finché la parte %3 non avrà trovato che cosa le serve sulle facce comuni. Avviarla di nuovo dopo: riprende da qui.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to another build: of other data, with other options, or by another version of TAn. Remove it, or choose another folder.</source>
        <translation>«%1» appartiene a un&apos;altra costruzione: di altri dati, con altre opzioni o di un&apos;altra versione di TAn. Eliminare il file o scegliere un&apos;altra cartella.</translation>
    </message>
    <message>
        <source>Checking what is done already</source>
        <translation>Verifica di ciò che è già pronto</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged. Build that part again: it keeps what is whole.</source>
        <translation>«%1» è danneggiato. Costruire di nuovo quella parte: ciò che è intatto viene conservato.</translation>
    </message>
    <message>
        <source>No part of the build in &apos;%1&apos; is finished yet.</source>
        <translation>Nessuna parte della costruzione in «%1» è ancora finita.</translation>
    </message>
    <message>
        <source>Parts of the build in &apos;%1&apos; are missing, and those that are there are of different divisions. Build all parts of one of them.</source>
        <translation>Mancano parti della costruzione in «%1», e quelle presenti sono di suddivisioni diverse. Costruire tutte le parti di una di esse.</translation>
    </message>
    <message>
        <source>Of the %1 parts of the build in &apos;%2&apos; these are not finished yet: %3%4.</source>
        <translation>Delle %1 parti della costruzione in «%2» queste non sono ancora finite: %3%4.</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, which this build wrote, is not what was written. Start the same command again.</source>
        <translation>«%1» non contiene più ciò che questa costruzione aveva scritto. Eseguire di nuovo lo stesso comando.</translation>
    </message>
    <message>
        <source>The builder &apos;%1&apos; has no parameter &apos;%2&apos;, which the plan of this build sets. Use one version of it for all parts.</source>
        <translation>«%1» non ha il parametro «%2», che il piano di questa costruzione imposta. Usare la stessa versione per tutte le parti.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changed since the build was prepared. Prepare it anew, in another folder.</source>
        <translation>«%1» è cambiato da quando la costruzione è stata preparata. Prepararla di nuovo, in un&apos;altra cartella.</translation>
    </message>
    <message>
        <source>This builder does not build in parts.</source>
        <translation>Questo metodo non costruisce in parti.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be built in parts with these options: that takes a regular lattice or a curvilinear grid, refined in blocks. Build it as a whole.</source>
        <translation>«%1» non può essere costruito in parti con queste opzioni: serve un reticolo regolare o una griglia curvilinea, raffinati a blocchi. Costruire il modello per intero.</translation>
    </message>
    <message>
        <source>There is no part %1 of %2. Parts are numbered from 1.</source>
        <translation>Non esiste la parte %1 di %2. Le parti sono numerate da 1.</translation>
    </message>
    <message>
        <source>Cannot use the plan &apos;%1&apos;: %2</source>
        <translation>Impossibile usare il piano «%1»: %2</translation>
    </message>
    <message>
        <source>There is no build to share in &apos;%1&apos;. Prepare one there first.</source>
        <translation>In «%1» non c&apos;è una costruzione da condividere. Prepararne prima una.</translation>
    </message>
    <message>
        <source>it was made by TAn %1, and this is TAn %2. Use one version for all parts.</source>
        <translation>è stato creato da TAn %1, e questo è TAn %2. Usare la stessa versione per tutte le parti.</translation>
    </message>
    <message>
        <source>it is damaged. Prepare the build again.</source>
        <translation>è danneggiato. Preparare di nuovo la costruzione.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not empty. The processes that share a build need a folder of their own: name another one.</source>
        <translation>«%1» non è vuota. I processi che si dividono una costruzione hanno bisogno di una cartella propria: indicarne un&apos;altra.</translation>
    </message>
    <message>
        <source>A build of &apos;%1&apos; cannot be shared, as its name or a folder&apos;s is no text in UTF-8. Rename it.</source>
        <translation>Una costruzione da «%1» non può essere condivisa, perché il nome del file o di una cartella non è un testo UTF-8. Rinominarlo.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds another build: of other data, with other options, or by another version of TAn. Remove it, or name another folder.</source>
        <translation>«%1» contiene un&apos;altra costruzione: di altri dati, con altre opzioni o di un&apos;altra versione di TAn. Eliminarla o indicare un&apos;altra cartella.</translation>
    </message>
</context>
<context>
    <name>tetra::MessageBar</name>
    <message>
        <source>Show or hide the older messages</source>
        <translation>Mostra o nasconde i messaggi meno recenti</translation>
    </message>
    <message>
        <source>Close All</source>
        <translation>Chiudi tutti</translation>
    </message>
    <message>
        <source>Dismiss all messages</source>
        <translation>Chiude tutti i messaggi</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>Mostra meno</translation>
    </message>
    <message>
        <source>Show %1 more</source>
        <translation>Mostra altri %1</translation>
    </message>
</context>
<context>
    <name>tetra::MessageRow</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Rimuovi questo messaggio</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 volte</translation>
    </message>
</context>
<context>
    <name>tetra::ModeActions</name>
    <message>
        <source>Show %1 (%2)</source>
        <translation>Mostra %1 (%2)</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
</context>
<context>
    <name>tetra::Opening</name>
    <message>
        <source>Models (*.tan)</source>
        <translation>Modelli (*.tan)</translation>
    </message>
    <message>
        <source>All supported files (%1)</source>
        <translation>Tutto ciò che si può aprire (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Sessions (*.tansession)</source>
        <translation>Sessioni (*.tansession)</translation>
    </message>
    <message>
        <source>Pictures saved by TAn (*.png)</source>
        <translation>Immagini con le loro sessioni (*.png)</translation>
    </message>
    <message>
        <source>Datasets compressed with gzip (*.gz)</source>
        <translation>Dati compressi con gzip (*.gz)</translation>
    </message>
</context>
<context>
    <name>tetra::OrientationActions</name>
    <message>
        <source>Turn Upside Down</source>
        <translation>Capovolgi</translation>
    </message>
    <message>
        <source>Flip the up axis</source>
        <translation>Capovolge l&apos;asse verticale</translation>
    </message>
    <message>
        <source>Roll Clockwise</source>
        <translation>Ruota in senso orario</translation>
    </message>
    <message>
        <source>Turn the picture by 90° clockwise</source>
        <translation>Ruota l&apos;immagine di 90° in senso orario</translation>
    </message>
    <message>
        <source>Roll Anticlockwise</source>
        <translation>Ruota in senso antiorario</translation>
    </message>
    <message>
        <source>Turn the picture by 90° anticlockwise</source>
        <translation>Ruota l&apos;immagine di 90° in senso antiorario</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Raddrizza</translation>
    </message>
    <message>
        <source>Remove the roll: make the up axis vertical</source>
        <translation>Annulla l&apos;inclinazione: l&apos;asse in alto è verticale</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging turns the model freely in any direction, instead of around the up axis</source>
        <translation>Trascinando, il modello ruota liberamente in ogni direzione anziché intorno all&apos;asse verticale</translation>
    </message>
    <message>
        <source>Show the model with this axis upright</source>
        <translation>Mostra il modello con questo asse in verticale</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>The picture is not rolled</source>
        <translation>L&apos;immagine non è inclinata</translation>
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
        <translation>per esempio %1</translation>
    </message>
</context>
<context>
    <name>tetra::PickActions</name>
    <message>
        <source>&amp;Pick</source>
        <translation>&amp;Scegli</translation>
    </message>
    <message>
        <source>Pick the value at the pointer, or in the centre of the picture</source>
        <translation>Sceglie il valore sotto il puntatore, o al centro dell&apos;immagine</translation>
    </message>
    <message>
        <source>&amp;Isosurface at This Value</source>
        <translation>&amp;Isosuperficie a questo valore</translation>
    </message>
    <message>
        <source>Add an isosurface of the picked value</source>
        <translation>Aggiunge un&apos;isosuperficie del valore scelto</translation>
    </message>
    <message>
        <source>Add &amp;Transfer-Function Point</source>
        <translation>Aggiungi punto della funzione di &amp;trasferimento</translation>
    </message>
    <message>
        <source>Add a point to the transfer function at the picked value</source>
        <translation>Aggiunge un punto alla funzione di trasferimento al valore scelto</translation>
    </message>
    <message>
        <source>&amp;Clear Mark</source>
        <translation>&amp;Cancella segno</translation>
    </message>
    <message>
        <source>Clear the picked value</source>
        <translation>Cancella il valore scelto</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>Click or pick a place in the picture first</source>
        <translation>Fare prima clic su un punto dell&apos;immagine o sceglierne uno</translation>
    </message>
</context>
<context>
    <name>tetra::PictureDialog</name>
    <message>
        <source>Store &amp;how it was made in the file</source>
        <translation>Indica nel &amp;file come è stata fatta</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Salva immagine</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Salva…</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copia</translation>
    </message>
    <message>
        <source>Cl&amp;ose</source>
        <translation>&amp;Chiudi</translation>
    </message>
    <message>
        <source>Copy it to the clipboard</source>
        <translation>La mette negli appunti</translation>
    </message>
    <message>
        <source>Program, model, accuracy, camera, transfer function and isovalues, so that the picture can be reproduced: opening it as PNG offers its view</source>
        <translation>Programma, modello, accuratezza, camera, funzione di trasferimento e isovalori, così che l&apos;immagine si possa rifare: aprendola come PNG viene offerta la sua vista</translation>
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
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Larghezza in pixel</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Altezza in pixel</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Risoluzione</translation>
    </message>
    <message>
        <source>Trans&amp;parent background</source>
        <translation>Sfondo tras&amp;parente</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Come sullo schermo</translation>
    </message>
    <message>
        <source>Twice the screen size</source>
        <translation>Doppio dello schermo</translation>
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
        <translation>A scelta</translation>
    </message>
    <message>
        <source>Annotations and lines take up the same share of the picture as of the view</source>
        <translation>Annotazioni e linee occupano nell&apos;immagine quanto nella vista</translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation>&amp;Grandezza</translation>
    </message>
    <message>
        <source>Pixe&amp;ls</source>
        <translation>Pi&amp;xel</translation>
    </message>
    <message>
        <source>Leave out the background, to place the picture over something else</source>
        <translation>Omette lo sfondo, per sovrapporre l&apos;immagine a qualcos&apos;altro</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Sfondo</translation>
    </message>
    <message>
        <source>Annotations</source>
        <translation>Annotazioni</translation>
    </message>
    <message>
        <source>&amp;Keep proportions</source>
        <translation>&amp;Mantieni le proporzioni</translation>
    </message>
    <message>
        <source>Width and height change together, so that nothing is added or cut off</source>
        <translation>Larghezza e altezza si seguono, così che nulla venga aggiunto o tagliato</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Printed width</source>
        <translation>Larghezza di stampa</translation>
    </message>
    <message>
        <source>Width of the print in centimetres; the pixels follow from it and the resolution</source>
        <translation>Larghezza della stampa in centimetri; ne seguono, con la risoluzione, i pixel</translation>
    </message>
    <message>
        <source>Printed height</source>
        <translation>Altezza di stampa</translation>
    </message>
    <message>
        <source>Height of the print in centimetres; the pixels follow from it and the resolution</source>
        <translation>Altezza della stampa in centimetri; ne seguono, con la risoluzione, i pixel</translation>
    </message>
    <message>
        <source>Pri&amp;nt size</source>
        <translation>Dime&amp;nsioni di stampa</translation>
    </message>
    <message>
        <source>Print resolution in pixels per inch; the number of pixels changes only after a size in centimetres was entered</source>
        <translation>Risoluzione di stampa in pixel per pollice; il numero di pixel cambia solo dopo che è stata data una grandezza in centimetri</translation>
    </message>
    <message>
        <source>Print &amp;resolution</source>
        <translation>&amp;Risoluzione di stampa</translation>
    </message>
</context>
<context>
    <name>tetra::PluginWindow</name>
    <message>
        <source>Plugins</source>
        <translation>Plugin</translation>
    </message>
    <message>
        <source>Plugin</source>
        <translation>Plugin</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Genere</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>The plugin %1 cannot be used. %2</source>
        <translation>Il plugin %1 non può essere usato. %2</translation>
    </message>
    <message>
        <source>The plugins found, and why some are not used. Space turns a plugin on or off.</source>
        <translation>Che cosa si è trovato, e perché qualcosa non si usa. La barra spaziatrice attiva o disattiva un plugin.</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versione</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Changes take effect when TAn is restarted.</source>
        <translation>Le modifiche hanno effetto al prossimo avvio di TAn.</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>Co&amp;pia</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Copia per una segnalazione di errore</translation>
    </message>
    <message>
        <source>Searched in: %1</source>
        <translation>Cercati in: %1</translation>
    </message>
</context>
<context>
    <name>tetra::PointNumbers</name>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Value of the selection, in data units; selected points move together</source>
        <translation>Valore della selezione, nelle unità dei dati; i punti selezionati si spostano insieme</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacità</translation>
    </message>
    <message>
        <source>Opacity of the selected points: percentage of light absorbed per unit distance</source>
        <translation>Opacità dei punti selezionati: percentuale di luce assorbita per distanza unitaria</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>Colore della selezione</translation>
    </message>
    <message>
        <source>Unit distance</source>
        <translation>Distanza unitaria</translation>
    </message>
    <message>
        <source>The thickness of a layer to which the opacities apply, in data units: a smaller one makes everything denser</source>
        <translation>Lo spessore, nelle unità dei dati, che uno strato deve avere perché valgano le opacità: meno rende tutto più denso</translation>
    </message>
    <message>
        <source>Val&amp;ue</source>
        <translation>Val&amp;ore</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>O&amp;pacità</translation>
    </message>
    <message>
        <source>U&amp;nit distance</source>
        <translation>Dista&amp;nza unitaria</translation>
    </message>
</context>
<context>
    <name>tetra::PointTable</name>
    <message>
        <source>Points of the transfer function</source>
        <translation>Punti della funzione di trasferimento</translation>
    </message>
    <message>
        <source>Double click or F2 edits a cell; Del removes the selected points</source>
        <translation>Doppio clic o F2 modifica una cella; Canc elimina i punti selezionati</translation>
    </message>
</context>
<context>
    <name>tetra::PointTableModel</name>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Opacity, %</source>
        <translation>Opacità, %</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Colore</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppo</translation>
    </message>
    <message>
        <source>In data units</source>
        <translation>Nelle unità dei dati</translation>
    </message>
    <message>
        <source>Fraction absorbed per unit distance</source>
        <translation>Frazione assorbita per distanza unitaria</translation>
    </message>
    <message>
        <source>As a name or as #rrggbb</source>
        <translation>Come nome o come #rrggbb</translation>
    </message>
    <message>
        <source>0 to 9, or empty</source>
        <translation>Da 0 a 9, o vuoto</translation>
    </message>
</context>
<context>
    <name>tetra::PresetPopup</name>
    <message>
        <source>&amp;Save as preset…</source>
        <translation>&amp;Salva come preimpostazione…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Elimina</translation>
    </message>
    <message>
        <source>Search for a preset</source>
        <translation>Cerca una preimpostazione</translation>
    </message>
    <message>
        <source>Parts of a preset to apply</source>
        <translation>Parti di una preimpostazione da applicare</translation>
    </message>
    <message>
        <source>Colours and opacities</source>
        <translation>Colori e opacità</translation>
    </message>
    <message>
        <source>Colours alone</source>
        <translation>Solo i colori</translation>
    </message>
    <message>
        <source>Opacities alone</source>
        <translation>Solo le opacità</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preimpostazioni</translation>
    </message>
    <message>
        <source>Keep the current transfer function for this and other models</source>
        <translation>Conserva la funzione di trasferimento com&apos;è ora, per questo e per altri modelli</translation>
    </message>
    <message>
        <source>Delete the selected preset, if it is one of your own</source>
        <translation>Elimina la preimpostazione scelta, se è propria</translation>
    </message>
    <message>
        <source>Your own preset</source>
        <translation>Propria</translation>
    </message>
    <message>
        <source>Save as Preset</source>
        <translation>Salva come preimpostazione</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>Nome della preimpostazione:</translation>
    </message>
    <message>
        <source>Search: bone, lung, metal, plasma…</source>
        <translation>Cerca: ossa, polmoni, metallo, plasma…</translation>
    </message>
    <message>
        <source>Values in Hounsfield units (HU)</source>
        <translation>Valori in unità Hounsfield (HU)</translation>
    </message>
    <message>
        <source>No preset with opacities matches “%1”.</source>
        <translation>Nessuna preimpostazione con opacità corrisponde a «%1».</translation>
    </message>
    <message>
        <source>No preset matches “%1”.</source>
        <translation>Nessuna preimpostazione corrisponde a «%1».</translation>
    </message>
</context>
<context>
    <name>tetra::RegionActions</name>
    <message>
        <source>Focus: &amp;Sphere</source>
        <translation>Focus: &amp;sfera</translation>
    </message>
    <message>
        <source>More accurate in a sphere</source>
        <translation>Più accurato in una sfera</translation>
    </message>
    <message>
        <source>Focus: &amp;Box</source>
        <translation>Focus: &amp;box</translation>
    </message>
    <message>
        <source>More accurate in a box</source>
        <translation>Più accurato in un parallelepipedo</translation>
    </message>
    <message>
        <source>Focus to &amp;Centre of View</source>
        <translation>Focus al &amp;centro della vista</translation>
    </message>
    <message>
        <source>Move the focus to the camera&apos;s target</source>
        <translation>Sposta il focus al punto mirato dalla camera</translation>
    </message>
    <message>
        <source>Crop Bo&amp;x</source>
        <translation>&amp;Finestra</translation>
    </message>
    <message>
        <source>Show only the part of the domain in a box</source>
        <translation>Mostra solo la parte del dominio in un parallelepipedo</translation>
    </message>
    <message>
        <source>Turn on a focus first</source>
        <translation>Attivare prima un focus</translation>
    </message>
    <message>
        <source>Open a model first</source>
        <translation>Aprire prima un modello</translation>
    </message>
    <message>
        <source>&amp;Lens</source>
        <translation>&amp;Lente</translation>
    </message>
    <message>
        <source>Enlarge a part of the picture, at its own accuracy</source>
        <translation>Ingrandisce una parte dell&apos;immagine, con un&apos;accuratezza propria</translation>
    </message>
</context>
<context>
    <name>tetra::RegionPanel</name>
    <message>
        <source>&amp;Only a crop box</source>
        <translation>Solo una fin&amp;estra</translation>
    </message>
    <message>
        <source>Show only the part of the domain in a box (W)</source>
        <translation>Mostra solo la parte del dominio in un parallelepipedo (W)</translation>
    </message>
    <message>
        <source>Corners of the crop box, in data coordinates</source>
        <translation>Limiti della finestra, nelle coordinate dei dati</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;A</translation>
    </message>
    <message>
        <source>Cut exactly</source>
        <translation>Taglio esatto</translation>
    </message>
    <message>
        <source>Keep tetrahedra that touch it</source>
        <translation>Tetraedri che la toccano</translation>
    </message>
    <message>
        <source>Keep tetrahedra inside</source>
        <translation>Solo tetraedri all&apos;interno</translation>
    </message>
    <message>
        <source>Tetrahedra at the border</source>
        <translation>Tetraedri al bordo</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Bordo</translation>
    </message>
    <message>
        <source>Make the crop box as large as the domain</source>
        <translation>Rende la finestra grande quanto il dominio</translation>
    </message>
    <message>
        <source>In data units: %1 to %2</source>
        <translation>Nelle unità dei dati: da %1 a %2</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Valore minimo</translation>
    </message>
    <message>
        <source>Largest value</source>
        <translation>Valore massimo</translation>
    </message>
    <message>
        <source>&amp;Limit to a range of values</source>
        <translation>&amp;Limita a un intervallo di valori</translation>
    </message>
    <message>
        <source>Fro&amp;m</source>
        <translation>&amp;Da</translation>
    </message>
    <message>
        <source>&amp;Reset to Whole Domain</source>
        <translation>&amp;Ripristina tutto il dominio</translation>
    </message>
    <message>
        <source>&amp;Smallest</source>
        <translation>Mi&amp;nimo</translation>
    </message>
    <message>
        <source>&amp;Largest</source>
        <translation>Ma&amp;ssimo</translation>
    </message>
    <message>
        <source>Show only tetrahedra that can contain a value in a range. Isosurfaces of other values disappear, or are shown only in part.</source>
        <translation>Mostra solo i tetraedri che possono contenere un valore di un intervallo. Isosuperfici di altri valori non si vedono, o solo in parte.</translation>
    </message>
    <message>
        <source>How tetrahedra at the border of the crop box are treated: cut exactly there, or kept or left out whole</source>
        <translation>Come finisce la finestra: i tetraedri al suo bordo si tagliano esattamente lì, o si tengono o tralasciano interi</translation>
    </message>
    <message>
        <source>All tetrahedra in a range of &amp;errors</source>
        <translation>Tutti i tetraedri in un intervallo di &amp;errori</translation>
    </message>
    <message>
        <source>Overlay the tetrahedra of every mesh between two errors, as surfaces. The crop box does not cut them.</source>
        <translation>Al posto di una mesh mostra i tetraedri di tutte le mesh tra due errori, sovrapposti, come superfici. Una finestra li lascia interi.</translation>
    </message>
    <message>
        <source>in percent of the value range; 100 means no limit</source>
        <translation>in percento dell&apos;intervallo dei valori; 100 non pone limiti</translation>
    </message>
    <message>
        <source>F&amp;inest</source>
        <translation>Più f&amp;ine</translation>
    </message>
    <message>
        <source>Smallest error of the range</source>
        <translation>Errore minimo dell&apos;intervallo</translation>
    </message>
    <message>
        <source>The mesh of this error is the finest of the range, in percent of the value range</source>
        <translation>La mesh di questo errore è la più fine dell&apos;intervallo, in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>&amp;Coarsest</source>
        <translation>Più &amp;grossolana</translation>
    </message>
    <message>
        <source>Largest error of the range</source>
        <translation>Errore massimo dell&apos;intervallo</translation>
    </message>
    <message>
        <source>The mesh of this error is the coarsest of the range, in percent of the value range</source>
        <translation>La mesh di questo errore è la più grossolana dell&apos;intervallo, in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>&amp;Appear above</source>
        <translation>&amp;Nati sopra</translation>
    </message>
    <message>
        <source>Appear above</source>
        <translation>Nati sopra</translation>
    </message>
    <message>
        <source>Only tetrahedra that first appear above this error, in percent of the value range</source>
        <translation>Solo i tetraedri presenti nelle mesh a partire da un errore maggiore di questo, in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Appear &amp;up to</source>
        <translation>Nati fino &amp;a</translation>
    </message>
    <message>
        <source>Appear up to</source>
        <translation>Nati fino a</translation>
    </message>
    <message>
        <source>Only tetrahedra that first appear at or below this error, %1</source>
        <translation>Solo i tetraedri che non sono in mesh di errore maggiore di questo, %1</translation>
    </message>
    <message>
        <source>&amp;Disappear from</source>
        <translation>Sostituiti &amp;da</translation>
    </message>
    <message>
        <source>Disappear from</source>
        <translation>Sostituiti da</translation>
    </message>
    <message>
        <source>Only tetrahedra that are replaced at this error or a larger one, in percent of the value range</source>
        <translation>Solo i tetraedri sostituiti a questo errore o prima, in percento dell&apos;intervallo dei valori</translation>
    </message>
    <message>
        <source>Disap&amp;pear up to</source>
        <translation>Sostituiti &amp;fino a</translation>
    </message>
    <message>
        <source>Disappear up to</source>
        <translation>Sostituiti fino a</translation>
    </message>
    <message>
        <source>Only tetrahedra that are still in the mesh of this error, %1</source>
        <translation>Solo i tetraedri ancora presenti nella mesh di questo errore, %1</translation>
    </message>
</context>
<context>
    <name>tetra::RenderingPanel</name>
    <message>
        <source>Rendering mode</source>
        <translation>Modalità di resa</translation>
    </message>
    <message>
        <source>Automatic (%1 frames/s)</source>
        <translation>Automatica (%1 fotogrammi/s)</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fotogrammi/s</translation>
    </message>
    <message>
        <source>The frame rate to keep while something moves. If the machine is too slow, frames are drawn smaller and with fewer tetrahedra; the still picture is always complete.</source>
        <translation>La frequenza da mantenere mentre qualcosa si muove. Se il computer è troppo lento, i fotogrammi sono più piccoli e con meno tetraedri; l&apos;immagine ferma è sempre completa.</translation>
    </message>
    <message>
        <source>Frame rate while moving</source>
        <translation>Frequenza durante il movimento</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>M&amp;ostra</translation>
    </message>
    <message>
        <source>Frame r&amp;ate</source>
        <translation>Frequen&amp;za</translation>
    </message>
    <message>
        <source>What to draw while moving</source>
        <translation>Che cosa disegnare durante il movimento</translation>
    </message>
    <message>
        <source>What to draw while something moves. The still picture is always complete.</source>
        <translation>Che cosa disegnare mentre qualcosa si muove. L&apos;immagine ferma è sempre completa.</translation>
    </message>
    <message>
        <source>As the frame rate allows</source>
        <translation>Quanto consente la frequenza</translation>
    </message>
    <message>
        <source>A mesh of a fixed error</source>
        <translation>Una mesh di errore fisso</translation>
    </message>
    <message>
        <source>A share of the tetrahedra</source>
        <translation>Una parte dei tetraedri</translation>
    </message>
    <message>
        <source>Always full quality</source>
        <translation>Sempre qualità piena</translation>
    </message>
    <message>
        <source>Error while moving</source>
        <translation>Errore durante il movimento</translation>
    </message>
    <message>
        <source>The error of the mesh that is drawn while something moves, in percent of the value range.</source>
        <translation>L&apos;errore della mesh disegnata mentre qualcosa si muove, in percento dell&apos;intervallo dei valori.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Share of the tetrahedra while moving</source>
        <translation>Parte dei tetraedri durante il movimento</translation>
    </message>
    <message>
        <source>How many of the tetrahedra are drawn while something moves, in percent.</source>
        <translation>Quanti dei tetraedri si disegnano mentre qualcosa si muove, in percento.</translation>
    </message>
    <message>
        <source>Time until the full picture</source>
        <translation>Tempo fino all&apos;immagine completa</translation>
    </message>
    <message>
        <source>The full picture is drawn when nothing has moved for this long, in milliseconds.</source>
        <translation>Quando nulla si è mosso per questo tempo, in millisecondi, si disegna l&apos;immagine completa.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>While &amp;moving</source>
        <translation>Durante il &amp;movimento</translation>
    </message>
    <message>
        <source>&amp;Error</source>
        <translation>&amp;Errore</translation>
    </message>
    <message>
        <source>&amp;Tetrahedra</source>
        <translation>&amp;Tetraedri</translation>
    </message>
    <message>
        <source>&amp;Full picture after</source>
        <translation>Immagine &amp;completa dopo</translation>
    </message>
</context>
<context>
    <name>tetra::ScaleInput</name>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>Linear uses the values as they are. Logarithmic uses their logarithms to base 10, for values spanning many powers of ten: errors are then factors, the same for large and small values</source>
        <translation>Lineare prende i valori come sono. Logaritmica prende i loro logaritmi in base 10, per valori che coprono molte potenze di dieci: gli errori sono allora fattori, gli stessi per valori grandi e piccoli</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lineare</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logaritmica</translation>
    </message>
    <message>
        <source>Smallest value</source>
        <translation>Valore minimo</translation>
    </message>
    <message>
        <source>all values are positive</source>
        <translation>tutti i valori sono positivi</translation>
    </message>
    <message>
        <source>Values smaller than this are replaced by it, including zero and negative ones, which have no logarithm. Leave empty if all values are positive</source>
        <translation>Il valore che prende il posto di quelli minori, anche zero e negativi: questi non hanno logaritmo. Vuoto: tutti i valori devono essere positivi</translation>
    </message>
</context>
<context>
    <name>tetra::SceneService</name>
    <message>
        <source>No renderer plugin could be loaded, so models cannot be shown. %1</source>
        <translation>Nessun plugin di resa ha potuto essere caricato, perciò non c&apos;è modo di mostrare un modello. %1</translation>
    </message>
</context>
<context>
    <name>tetra::SessionFile</name>
    <message>
        <source>Not all of the session could be kept.</source>
        <translation>Non è stato possibile mantenere tutta la sessione.</translation>
    </message>
    <message>
        <source>The session %1 is not changed; saving will ask for another file name.</source>
        <translation>La sessione %1 resta com&apos;è; al salvataggio verrà chiesto un altro nome di file.</translation>
    </message>
    <message>
        <source>The view saved in the session is applied.</source>
        <translation>Lo si mostra come dice la sessione.</translation>
    </message>
    <message>
        <source>It will be offered again the next time.</source>
        <translation>Verrà offerta di nuovo al prossimo avvio.</translation>
    </message>
</context>
<context>
    <name>tetra::SessionOpening</name>
    <message>
        <source>Apply Look</source>
        <translation>Applica aspetto</translation>
    </message>
    <message>
        <source>Not all of the look of %1 could be applied.</source>
        <translation>Non è stato possibile applicare tutto l&apos;aspetto di %1.</translation>
    </message>
</context>
<context>
    <name>tetra::SlicePreview</name>
    <message>
        <source>Preview of a layer</source>
        <translation>Anteprima di uno strato</translation>
    </message>
    <message>
        <source>Axis of the layers</source>
        <translation>Asse degli strati</translation>
    </message>
    <message>
        <source>Axis perpendicular to the layer</source>
        <translation>Asse perpendicolare allo strato</translation>
    </message>
    <message>
        <source>Across %1</source>
        <translation>Di traverso a %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Strato</translation>
    </message>
    <message>
        <source>Layer shown, counted from 0</source>
        <translation>Lo strato mostrato, contando da 0</translation>
    </message>
    <message>
        <source>No preview: the layout is incomplete</source>
        <translation>Nessuna anteprima: il formato è incompleto</translation>
    </message>
    <message>
        <source>%1 to the right, %2 up; black %3, white %4</source>
        <translation>%1 verso destra, %2 in alto; nero %3, bianco %4</translation>
    </message>
</context>
<context>
    <name>tetra::SolidDialog</name>
    <message>
        <source>&amp;Largest part only</source>
        <translation>Solo la parte più &amp;grande</translation>
    </message>
    <message>
        <source>&amp;Measure the deviation</source>
        <translation>&amp;Misura lo scostamento</translation>
    </message>
    <message>
        <source>Save Solids</source>
        <translation>Salva solidi</translation>
    </message>
    <message>
        <source>The displayed isosurfaces are closed where they meet the boundary of the mesh, so that each is the surface of a solid, as 3D printing requires.</source>
        <translation>Le isosuperfici mostrate vengono chiuse dove incontrano il contorno della mesh, in modo che ciascuna sia la superficie di un solido, come serve a una stampante 3D.</translation>
    </message>
    <message>
        <source>Values above the isovalue</source>
        <translation>Valori sopra l&apos;isovalore</translation>
    </message>
    <message>
        <source>Values below the isovalue</source>
        <translation>Valori sotto l&apos;isovalore</translation>
    </message>
    <message>
        <source>None: leave them open</source>
        <translation>Nessuno: lasciarle aperte</translation>
    </message>
    <message>
        <source>Where the solid lies: on which side of the isosurface</source>
        <translation>Dove si trova il solido: da quale lato dell&apos;isosuperficie</translation>
    </message>
    <message>
        <source>Save only the part of each surface with the largest area</source>
        <translation>Salva di ogni superficie solo la parte con l&apos;area maggiore</translation>
    </message>
    <message>
        <source>Also measure how far the surfaces are from those of the finest mesh; this takes as long as showing the model at error 0</source>
        <translation>Misura anche quanto le superfici distano da quelle della mesh più fine; richiede quanto mostrare il modello con errore 0</translation>
    </message>
    <message>
        <source>S&amp;olid:</source>
        <translation>S&amp;olido:</translation>
    </message>
</context>
<context>
    <name>tetra::StatisticsPanel</name>
    <message>
        <source>Mesh sizes</source>
        <translation>Dimensioni delle mesh</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>Co&amp;pia</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Salva…</translation>
    </message>
    <message>
        <source>Copy as text, with tabs between the columns</source>
        <translation>Copia come testo, con tabulazioni fra le colonne</translation>
    </message>
    <message>
        <source>Save the table as CSV or JSON (percent, decimal point)</source>
        <translation>Salva la tabella come CSV o JSON (percentuali, punto decimale)</translation>
    </message>
    <message>
        <source>Show &amp;faulty cells</source>
        <translation>Mostra le celle &amp;difettose</translation>
    </message>
    <message>
        <source>Outline, over the picture, the cells that were left out because something is wrong with them, and the cells of a grid that are folded or have no volume</source>
        <translation>Contorna, sopra l&apos;immagine, le celle tralasciate perché hanno un difetto e quelle di una griglia che sono ripiegate o senza volume</translation>
    </message>
    <message>
        <source>This model lists no faulty cells: its data have none, or an earlier version of TAn built it</source>
        <translation>Questo modello non elenca celle difettose: i suoi dati non ne hanno, oppure l&apos;ha costruito una versione precedente di TAn</translation>
    </message>
    <message>
        <source>What the mesh of each error costs: its error in percent of the value range and in units of the values or as a factor, its size, the time to extract it, measured on this computer, and the memory that it occupies. Choose a row to see that mesh.</source>
        <translation>Quanto costa la mesh di ogni errore: l&apos;errore in percento dell&apos;intervallo dei valori e nelle loro unità o come fattore, la dimensione, il tempo per estrarla, come misurato qui, e la memoria che occupa. Scegliere una riga per vedere quella mesh.</translation>
    </message>
</context>
<context>
    <name>tetra::StatusLine</name>
    <message>
        <source>Drawing the picture at the chosen accuracy</source>
        <translation>Disegno dell&apos;immagine con l&apos;accuratezza scelta</translation>
    </message>
    <message>
        <source>Vertices of the mesh shown</source>
        <translation>Vertici della mesh mostrata</translation>
    </message>
    <message>
        <source>Tetrahedra of the mesh shown</source>
        <translation>Tetraedri della mesh mostrata</translation>
    </message>
    <message>
        <source>Triangles of all surfaces shown</source>
        <translation>Triangoli di tutte le superfici mostrate</translation>
    </message>
    <message>
        <source>Time to extract the mesh from the model</source>
        <translation>Tempo per estrarre la mesh dal modello</translation>
    </message>
    <message>
        <source>Memory used by the program, including mapped files</source>
        <translation>Memoria occupata dal programma, compresi i file mappati</translation>
    </message>
    <message>
        <source>Rendering back end: OpenGL or the CPU</source>
        <translation>Disegno con OpenGL o con il processore</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 vertici</translation>
    </message>
    <message>
        <source>%1 tetrahedra</source>
        <translation>%1 tetraedri</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triangoli</translation>
    </message>
    <message>
        <source>extracted in %1</source>
        <translation>estratta in %1</translation>
    </message>
    <message>
        <source>%1 per frame</source>
        <translation>%1 per fotogramma</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 fotogrammi/s</translation>
    </message>
    <message>
        <source>size 1/%1</source>
        <translation>dimensione 1/%1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Picked value and its position, in data units. Click elsewhere to pick another; Esc clears the mark.</source>
        <translation>Valore scelto e la sua posizione, nelle unità dei dati. Un clic altrove ne sceglie un altro, Esc toglie il segno.</translation>
    </message>
    <message>
        <source>Time to draw the last picture; during movement, the frame rate, and the reduced size and number of tetrahedra</source>
        <translation>Tempo per disegnare l&apos;ultima immagine; in movimento la frequenza dei fotogrammi, la dimensione ridotta e il numero ridotto di tetraedri</translation>
    </message>
    <message>
        <source>The server is extracting the mesh, or the picture is being drawn</source>
        <translation>Il server trova la mesh, o l&apos;immagine viene disegnata</translation>
    </message>
    <message>
        <source>part may be error</source>
        <translation>una parte può essere errore</translation>
    </message>
</context>
<context>
    <name>tetra::TaskLine</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
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
        <translation>Nessun plugin di strumenti ha potuto essere caricato.</translation>
    </message>
    <message>
        <source>Choose a tool in the menu Tools: to measure, say, or to cut.</source>
        <translation>Scegliere uno strumento nel menu Strumenti: per misurare, ad esempio, o per tagliare.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Letture</translation>
    </message>
    <message>
        <source>What the tool tells of the places in the picture</source>
        <translation>Ciò che lo strumento dice dei punti nell&apos;immagine</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Copy the readings as text, for a table</source>
        <translation>Copiare le letture come testo, per una tabella</translation>
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
        <translation>Funzione di trasferimento</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>Point %1 of %2: value %3, opacity %4</source>
        <translation>Punto %1 di %2: valore %3, opacità %4</translation>
    </message>
    <message>
        <source>Opacity against value. Drag points, click the curve or double click to add one, Delete removes; arrow keys move (finer with Ctrl, farther with Shift), Tab goes to the next. A frame or Ctrl+click selects several. The wheel zooms the values, with Ctrl the opacities; Home shows all. Ctrl+digit makes a group, the digit selects it. Behind: how often the values occur in the mesh.</source>
        <translation>L&apos;opacità secondo il valore. Trascinare i punti, fare clic sulla curva o doppio clic per aggiungerne uno, Canc elimina; le frecce spostano (più fine con Ctrl, più lontano con Maiusc), Tab va al prossimo. Un riquadro o Ctrl+clic ne seleziona più d&apos;uno. La rotella ingrandisce i valori, con Ctrl le opacità; Inizio mostra tutto. Ctrl+cifra forma un gruppo, la cifra lo seleziona. Sullo sfondo: quanto sono frequenti i valori nella mesh.</translation>
    </message>
    <message>
        <source>%1 points are selected</source>
        <translation>%1 punti selezionati</translation>
    </message>
    <message>
        <source>Value %1, opacity %2</source>
        <translation>Valore %1, opacità %2</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>gruppo %1</translation>
    </message>
    <message>
        <source>Isovalue %1 of %2: %3</source>
        <translation>Isovalore %1 di %2: %3</translation>
    </message>
    <message>
        <source>Lower end of the mask: %1</source>
        <translation>Estremo inferiore della maschera: %1</translation>
    </message>
    <message>
        <source>Upper end of the mask: %1</source>
        <translation>Estremo superiore della maschera: %1</translation>
    </message>
</context>
<context>
    <name>tetra::TransferPanel</name>
    <message>
        <source>S&amp;tep</source>
        <translation>&amp;Gradino</translation>
    </message>
    <message>
        <source>Lo&amp;garithmic</source>
        <translation>Lo&amp;garitmico</translation>
    </message>
    <message>
        <source>Give the point two sides: one colour and opacity for the values below it, another for those above</source>
        <translation>Dà al punto due lati: ciò che sta sotto il suo valore finisce lì, e ciò che sta sopra vi comincia</translation>
    </message>
    <message>
        <source>Show how often values occur on a logarithmic scale, so that rare ones are visible</source>
        <translation>Mostra in scala logaritmica quanto spesso si presentano i valori, così che si vedano quelli rari</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Transfer-function presets</source>
        <translation>Preimpostazioni di funzioni di trasferimento</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambia</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Carica…</translation>
    </message>
    <message>
        <source>Load a transfer function: TAn&apos;s own, or ParaView presets (JSON or XML)</source>
        <translation>Prende una funzione di trasferimento da un file: una di TAn o preimpostazioni di ParaView (JSON o XML)</translation>
    </message>
    <message>
        <source>The file holds several presets:</source>
        <translation>Il file contiene più preimpostazioni:</translation>
    </message>
    <message>
        <source>Save for &amp;ParaView…</source>
        <translation>Salva per &amp;ParaView…</translation>
    </message>
    <message>
        <source>Save Transfer Function for ParaView</source>
        <translation>Salva funzione di trasferimento per ParaView</translation>
    </message>
    <message>
        <source>ParaView presets (*.json)</source>
        <translation>Preimpostazioni di ParaView (*.json)</translation>
    </message>
    <message>
        <source>Transfer functions (*.json *.xml)</source>
        <translation>Funzioni di trasferimento (*.json *.xml)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Save the transfer function as a JSON file, which “tan render” also accepts</source>
        <translation>Salva la funzione di trasferimento come file JSON, accettato anche da «tan render»</translation>
    </message>
    <message>
        <source>Load Transfer Function</source>
        <translation>Carica funzione di trasferimento</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Funzioni di trasferimento (*.json)</translation>
    </message>
    <message>
        <source>Save Transfer Function</source>
        <translation>Salva funzione di trasferimento</translation>
    </message>
    <message>
        <source>Axis of opacities</source>
        <translation>Asse delle opacità</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Lineare</translation>
    </message>
    <message>
        <source>S&amp;quare root</source>
        <translation>Radice &amp;quadrata</translation>
    </message>
    <message>
        <source>L&amp;ogarithmic: fine near zero</source>
        <translation>L&amp;ogaritmico: fine vicino allo zero</translation>
    </message>
    <message>
        <source>Zoom to the &amp;selected points</source>
        <translation>Ingrandisci i punti &amp;selezionati</translation>
    </message>
    <message>
        <source>Zoom to the &amp;values of the data</source>
        <translation>Ingrandisci i &amp;valori dei dati</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostra &amp;tutto</translation>
    </message>
    <message>
        <source>Value, opacity, colour and frequency of occurrence, at the pointer</source>
        <translation>Valore, opacità, colore e frequenza, al puntatore</translation>
    </message>
    <message>
        <source>Add a point after the selected one; or click the curve, or double-click the plot</source>
        <translation>Aggiunge un punto dopo quello selezionato; oppure fare clic sulla curva, o doppio clic nel grafico</translation>
    </message>
    <message>
        <source>Remove the selection (Del)</source>
        <translation>Rimuove la selezione (Canc)</translation>
    </message>
    <message>
        <source>Change the selected points, or all</source>
        <translation>Modifica i punti selezionati, o tutti</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>How the plot is shown</source>
        <translation>Come si mostra il grafico</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maschera</translation>
    </message>
    <message>
        <source>Show only the values between two draggable lines</source>
        <translation>Mostra solo i valori fra due linee trascinabili</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabella</translation>
    </message>
    <message>
        <source>Edit all points in a table</source>
        <translation>Modifica tutti i punti in una tabella</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Aggiungi un punto</translation>
    </message>
    <message>
        <source>Remove the selection</source>
        <translation>Rimuove la selezione</translation>
    </message>
    <message>
        <source>Read-out</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Axis of values</source>
        <translation>Asse dei valori</translation>
    </message>
    <message>
        <source>Li&amp;near</source>
        <translation>Li&amp;neare</translation>
    </message>
    <message>
        <source>Logarithmic: by &amp;factors</source>
        <translation>Logaritmico: per &amp;fattori</translation>
    </message>
    <message>
        <source>Transfer function to edit</source>
        <translation>Funzione di trasferimento da modificare</translation>
    </message>
    <message>
        <source>Fun&amp;ction</source>
        <translation>Fun&amp;zione</translation>
    </message>
</context>
<context>
    <name>tetra::ValuePick</name>
    <message>
        <source>%1 at (%2, %3, %4)</source>
        <translation>%1 in (%2, %3, %4)</translation>
    </message>
</context>
<context>
    <name>tetra::ViewPanel</name>
    <message>
        <source>&amp;Load Camera…</source>
        <translation>&amp;Carica camera…</translation>
    </message>
    <message>
        <source>Sa&amp;ve Camera…</source>
        <translation>&amp;Salva camera…</translation>
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
        <translation>Elevazione</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>From the camera to the target, in data units</source>
        <translation>Dalla camera al punto mirato, nelle unità dei dati</translation>
    </message>
    <message>
        <source>View angle</source>
        <translation>Angolo di vista</translation>
    </message>
    <message>
        <source>View angle along the shorter side of the picture, in degrees</source>
        <translation>Angolo di vista lungo il lato più corto dell&apos;immagine, in gradi</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Prospettica</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallela</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Proiezione</translation>
    </message>
    <message>
        <source>Perspective: distant parts look smaller (Ctrl+P)</source>
        <translation>Prospettiva: ciò che è lontano appare più piccolo (Ctrl+P)</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Mira</translation>
    </message>
    <message>
        <source>The camera&apos;s target, in data units</source>
        <translation>Il punto mirato dalla camera, nelle unità dei dati</translation>
    </message>
    <message>
        <source>A&amp;zimuth</source>
        <translation>A&amp;zimut</translation>
    </message>
    <message>
        <source>E&amp;levation</source>
        <translation>E&amp;levazione</translation>
    </message>
    <message>
        <source>D&amp;istance</source>
        <translation>D&amp;istanza</translation>
    </message>
    <message>
        <source>View &amp;angle</source>
        <translation>An&amp;golo di vista</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>&amp;Proiezione</translation>
    </message>
    <message>
        <source>Look from this side</source>
        <translation>Guarda da questo lato</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Adatta</translation>
    </message>
    <message>
        <source>Background colour, also in saved pictures</source>
        <translation>Colore di sfondo, anche nelle immagini salvate</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Colore di sfondo</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predefinito</translation>
    </message>
    <message>
        <source>Load the camera from a JSON file</source>
        <translation>Carica la camera da un file JSON</translation>
    </message>
    <message>
        <source>Save the camera as a JSON file, which “tan render --camera” also accepts</source>
        <translation>Salva la camera come file JSON, accettato anche da «tan render --camera»</translation>
    </message>
    <message>
        <source>Bac&amp;kground</source>
        <translation>Sfon&amp;do</translation>
    </message>
    <message>
        <source>Load Camera</source>
        <translation>Carica camera</translation>
    </message>
    <message>
        <source>Cameras (*.json)</source>
        <translation>Camere (*.json)</translation>
    </message>
    <message>
        <source>Save Camera</source>
        <translation>Salva camera</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retro</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Basso</translation>
    </message>
    <message>
        <source>Direction around the up axis, in degrees</source>
        <translation>Direzione intorno all&apos;asse verticale, in gradi</translation>
    </message>
    <message>
        <source>Height above the plane perpendicular to the up axis, in degrees</source>
        <translation>Altezza sul piano perpendicolare all&apos;asse verticale, in gradi</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollio</translation>
    </message>
    <message>
        <source>Clockwise roll of the picture, in degrees</source>
        <translation>Inclinazione oraria dell&apos;immagine, in gradi</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Asse in alto</translation>
    </message>
    <message>
        <source>Which axis of the data points up</source>
        <translation>Quale asse dei dati punta verso l&apos;alto</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Piatto girevole</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Trascinamento</translation>
    </message>
    <message>
        <source>Whether dragging turns the model around the up axis, or freely in any direction (Ctrl+T)</source>
        <translation>Se trascinando il modello ruota intorno all&apos;asse verticale o liberamente in ogni direzione (Ctrl+T)</translation>
    </message>
    <message>
        <source>&amp;Roll</source>
        <translation>&amp;Rollio</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>&amp;Alto</translation>
    </message>
    <message>
        <source>Dra&amp;gging</source>
        <translation>&amp;Trascina</translation>
    </message>
    <message>
        <source>Frame what is shown, or the focus; press again for the whole domain (Home)</source>
        <translation>Inquadra ciò che si mostra, o il focus; ancora una volta: l&apos;intero dominio (Home)</translation>
    </message>
    <message>
        <source>The colour that fits the window, light or dark; dark behind a shaded volume</source>
        <translation>Il colore che si adatta alla finestra, chiaro o scuro; scuro dietro un volume ombreggiato</translation>
    </message>
</context>
<context>
    <name>tetra::Viewport</name>
    <message>
        <source>OpenGL cannot be used; the CPU draws the picture instead. %1</source>
        <translation>OpenGL non si può usare, l&apos;immagine è disegnata dal processore. %1</translation>
    </message>
</context>
</TS>
