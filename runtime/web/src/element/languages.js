// What the element says, by language: in the order of NAMES. `{name}` is the asset's name.

export const NAMES = [
  "prompt", "loading", "asset", "shown", "unavailable", "failed", "front", "front-right", "right", "back-right", "back", "back-left", "left",
  "front-left", "above", "below", "keys",
];

export const LANGUAGES = {
  en: [
    "Drag to turn", "Loading", "A relightable asset", "{name} is shown", "The interactive view is not available here.", "This could not be loaded.",
    "View from the front", "View from the front right", "View from the right", "View from the back right", "View from the back",
    "View from the back left", "View from the left", "View from the front left", ", from above", ", from below",
    "Arrow keys or one finger orbit. Plus, minus or a pinch go nearer and farther. W, A, S, D or two fingers pan. Square brackets, Shift and arrow " +
      "keys, three fingers or two that twist turn the light. Home resets.",
  ],
  de: [
    "Zum Drehen ziehen", "Wird geladen", "Ein 3D-Objekt", "{name} wird angezeigt", "Die interaktive Ansicht ist hier nicht verfügbar.",
    "Der Inhalt konnte nicht geladen werden.", "Ansicht von vorn", "Ansicht von vorn rechts", "Ansicht von rechts", "Ansicht von hinten rechts",
    "Ansicht von hinten", "Ansicht von hinten links", "Ansicht von links", "Ansicht von vorn links", ", von oben", ", von unten",
    "Pfeiltasten oder ein Finger drehen. Plus, Minus oder zwei Finger, die sich spreizen, zoomen. W, A, S, D oder zwei Finger verschieben. Eckige " +
      "Klammern, Umschalt und Pfeiltasten, drei Finger oder zwei, die sich drehen, drehen das Licht. Pos1 setzt zurück.",
  ],
  es: [
    "Arrastra para girar", "Cargando", "Un objeto 3D", "Se muestra {name}", "La vista interactiva no está disponible aquí.", "No se pudo cargar el contenido.",
    "Vista frontal", "Vista frontal derecha", "Vista desde la derecha", "Vista trasera derecha", "Vista trasera", "Vista trasera izquierda",
    "Vista desde la izquierda", "Vista frontal izquierda", ", desde arriba", ", desde abajo",
    "Las flechas o un dedo giran la vista. Más, menos o pellizcar acercan y alejan. W, A, S, D o dos dedos desplazan. Los corchetes, Mayús y las " +
      "flechas, tres dedos o dos que rotan giran la luz. Inicio restablece la vista.",
  ],
  fr: [
    "Faites glisser pour tourner", "Chargement", "Un objet 3D", "{name} est affiché", "La vue interactive n’est pas disponible ici.",
    "Le contenu n’a pas pu être chargé.", "Vue de face", "Vue de face, à droite", "Vue de droite", "Vue arrière droite", "Vue arrière", "Vue arrière gauche",
    "Vue de gauche", "Vue de face, à gauche", ", d’en haut", ", d’en bas",
    "Les flèches ou un doigt tournent la vue. Plus, moins ou un pincement rapprochent et éloignent. W, A, S, D ou deux doigts déplacent. Les crochets, " +
      "Maj et les flèches, trois doigts ou deux qui pivotent tournent la lumière. Début réinitialise.",
  ],
  it: [
    "Trascina per ruotare", "Caricamento", "Un oggetto 3D", "{name} è visualizzato", "La vista interattiva non è disponibile qui.",
    "Impossibile caricare il contenuto.", "Vista frontale", "Vista frontale destra", "Vista da destra", "Vista posteriore destra", "Vista posteriore",
    "Vista posteriore sinistra", "Vista da sinistra", "Vista frontale sinistra", ", dall’alto", ", dal basso",
    "Le frecce o un dito ruotano la vista. Più, meno o un pizzico avvicinano e allontanano. W, A, S, D o due dita spostano. Le parentesi quadre, Maiusc " +
      "e le frecce, tre dita o due che ruotano girano la luce. Home ripristina.",
  ],
  ja: [
    "ドラッグして回転", "読み込み中", "3D オブジェクト", "{name} が表示されました", "ここではインタラクティブ表示を利用できません。", "読み込めませんでした。",
    "正面からの表示", "右前からの表示", "右からの表示", "右後ろからの表示", "後ろからの表示", "左後ろからの表示", "左からの表示", "左前からの表示", "、上から", "、下から",
    "矢印キーまたは 1 本指で回転します。プラス、マイナスまたはピンチで拡大・縮小します。W、A、S、D または 2 本指で移動します。角括弧、Shift と矢印キー、3 本指、" +
      "または 2 本指の回転で光を回します。Home で元に戻します。",
  ],
  ko: [
    "드래그하여 회전", "불러오는 중", "3D 개체", "{name} 표시됨", "여기에서는 대화형 보기를 사용할 수 없습니다.", "콘텐츠를 불러올 수 없습니다.",
    "앞에서 본 모습", "오른쪽 앞에서 본 모습", "오른쪽에서 본 모습", "오른쪽 뒤에서 본 모습", "뒤에서 본 모습", "왼쪽 뒤에서 본 모습", "왼쪽에서 본 모습",
    "왼쪽 앞에서 본 모습", ", 위에서", ", 아래에서",
    "화살표 키나 한 손가락으로 회전합니다. 더하기, 빼기 또는 핀치로 확대하고 축소합니다. W, A, S, D 또는 두 손가락으로 이동합니다. 대괄호, Shift와 화살표 키, " +
      "세 손가락 또는 두 손가락 회전으로 조명을 돌립니다. Home으로 초기화합니다.",
  ],
  nl: [
    "Sleep om te draaien", "Laden", "Een 3D-object", "{name} wordt getoond", "De interactieve weergave is hier niet beschikbaar.",
    "De inhoud kon niet worden geladen.", "Vooraanzicht", "Aanzicht van rechtsvoor", "Aanzicht van rechts", "Aanzicht van rechtsachter", "Achteraanzicht",
    "Aanzicht van linksachter", "Aanzicht van links", "Aanzicht van linksvoor", ", van boven", ", van onderen",
    "Pijltoetsen of één vinger draaien. Plus, min of knijpen zoomen. W, A, S, D of twee vingers verschuiven. Vierkante haken, Shift en pijltoetsen, " +
      "drie vingers of twee die draaien, draaien het licht. Home herstelt.",
  ],
  pt: [
    "Arraste para girar", "Carregando", "Um objeto 3D", "{name} está visível", "A visualização interativa não está disponível aqui.",
    "Não foi possível carregar o conteúdo.", "Vista frontal", "Vista frontal direita", "Vista da direita", "Vista traseira direita", "Vista traseira",
    "Vista traseira esquerda", "Vista da esquerda", "Vista frontal esquerda", ", de cima", ", de baixo",
    "As setas ou um dedo giram a vista. Mais, menos ou uma pinça aproximam e afastam. W, A, S, D ou dois dedos deslocam. Colchetes, Shift e setas, três " +
      "dedos ou dois que giram movem a luz. Home restaura a vista.",
  ],
  zh: [
    "拖动以旋转", "正在加载", "三维物体", "已显示{name}", "此处无法使用交互式视图。", "无法加载内容。", "正面视图", "右前方视图", "右侧视图", "右后方视图",
    "背面视图", "左后方视图", "左侧视图", "左前方视图", "，俯视", "，仰视",
    "方向键或单指旋转。加号、减号或双指张合缩放。W、A、S、D 或双指平移。方括号、Shift 加方向键、三指或双指扭转可转动光线。Home 键复位。",
  ],
};
