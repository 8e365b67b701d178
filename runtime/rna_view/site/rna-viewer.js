(()=>{var Rc=Object.defineProperty;var rs=(n,e)=>{for(var t in e)Rc(n,t,{get:e[t],enumerable:!0})};var tn=class extends Error{constructor(e,t,r){super(`${t?t+": ":""}${r} [${e}]`),this.code=e,this.where=t}};function y(n,e,t){throw new tn(n,e,t)}var H=class extends Error{};var Pr=65536,Ec=2**30,kt=class{constructor(e,t){this.blob=e,this.name=t,this.size=e.size,this.ranged=!1,this.fetched=e.size}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}},Dn=class n{static async open(e,t=()=>{},r,i=nn(e)){let s=new n;Object.assign(s,{url:e,progress:t,signal:r,fetched:0,name:i});let o=await s._ask({Range:`bytes=0-${Pr-1}`}),c=/\/(\d+)$/.exec(o.headers.get("Content-Range")??"");s.ranged=o.status===206&&c!==null;let l=Number(o.headers.get("Content-Length"))||0;s.expected=s.ranged?Pr:l;let f=s.ranged?Pr:Ec;return l>f&&await s._tooLong(o,f),s.head=await s._collect(o,f),s.size=s.ranged?Number(c[1]):s.head.length,s}async read(e,t){if(t<=this.head.length)return this.head.subarray(e,t);if(!this.ranged)return this.head.subarray(e,Math.min(t,this.size));let r=await this._ask({Range:`bytes=${e}-${t-1}`});if(r.status!==206)throw new H(`${this.name}: the server forgot about ranges`);let i=await this._collect(r,t-e);if(i.length<t-e)throw new H(`${this.name}: the server sent ${i.length} bytes of ${t-e}`);return i}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(r){if(r.name==="AbortError")throw r;let i=new URL(this.url,location.href).protocol==="file:";throw new H(i?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!t.ok&&t.status!==416)throw new H(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _collect(e,t){if(e.status===416||!e.body)return new Uint8Array;let r=[],i=0,s=e.body.getReader();for(;;){let{done:l,value:f}=await s.read();if(l)break;i+=f.length,i>t&&await this._tooLong(s,t),r.push(f),this.fetched+=f.length,this.progress(this.fetched,this.expected)}let o=new Uint8Array(i),c=0;for(let l of r)o.set(l,c),c+=l.length;return o}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new H(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};function nn(n){let e=new URL(n,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||n}catch{return e}}var Hn=class{constructor(e){Object.assign(this,{place:e,lines:new Map})}say(e,t=!1,r="page"){e?this.lines.set(r,{text:e,calm:t}):this.lines.delete(r);let i=[...this.lines.values()],s=new Set(i.map(o=>o.text));this.place.hidden=!i.length,this.place.replaceChildren(...[...s].map(o=>Object.assign(document.createElement("span"),{textContent:o}))),this.place.classList.toggle("calm",i.every(o=>o.calm))}},is=(n,e,t)=>Math.min(Math.max(n,e),t),Bn=n=>((n+180)%360+360)%360-180;function pt(n){return n<1e6?`${Math.round(n/1e3)} kB`:`${(n/1e6).toFixed(n<1e7?2:1)} MB`}var ss={azimuth:.6,elevation:.35,fov:30},os=89*Math.PI/180,kc=.95,De=(n,e,t=1)=>n.map((r,i)=>r+t*e[i]),rn=(n,e)=>n.map(t=>t*e),zr=(n,e)=>n.reduce((t,r,i)=>t+r*e[i],0),Tc=n=>rn(n,1/Math.hypot(...n)),as=([n,e,t],[r,i,s])=>[e*s-t*i,t*r-n*s,n*i-e*r],Cr=n=>Math.min(os,Math.max(-os,n));function cs(n,e,t){let r=De(n,e,-1),i=Math.hypot(...r);return{azimuth:Math.atan2(r[0],r[2]),elevation:Math.asin(r[1]/i),distance:i,target:e,fov:t}}var Gn=class{constructor(){Object.assign(this,{target:[0,0,0],distance:1,size:1,turntable:0,...ss})}place(e,t,r,i){let s=e.map(g=>Object.fromEntries(Object.entries(g).filter(([,_])=>_!=null))),{azimuth:o,elevation:c,fov:l,target:f=[],distance:h,share:m=1}=Object.assign({},ss,...s);Object.assign(this,{azimuth:o,elevation:c,fov:l}),t&&this.frame(t,r,i),this.distance=h??m*this.distance,this.target=this.target.map((g,_)=>f[_]??g)}frame({min:e,max:t},r,i=!1){this.target=rn(De(e,t),.5),this.size=Math.hypot(...De(t,e,-1))/2||1;let s=kc*Math.tan(this.fov*Math.PI/360),o=Array.from({length:8},(f,h)=>De([0,1,2].map(m=>(h>>m&1?t:e)[m]),this.target,-1)),l=(i?Array.from({length:16},(f,h)=>h*Math.PI/8):[this.turntable]).flatMap(f=>{let{forward:h,side:m,above:g}=this._axes(f);return o.map(_=>Math.max(Math.abs(zr(_,g)),Math.abs(zr(_,m))/r)/s-zr(_,h))});this.distance=Math.max(...l)||this.size}get position(){return De(this.target,this._away(this.turntable),this.distance)}turn(e,t){this.azimuth+=e,this.elevation=Cr(this.elevation+t)}zoom(e){this.distance=Math.min(1e4*this.size,Math.max(.001*this.size,this.distance*e))}pan(e,t){let{side:r,above:i}=this._axes(),s=2*this.distance*Math.tan(this.fov*Math.PI/360);this.target=De(De(this.target,r,e*s),i,t*s)}camera(e,t){let{forward:r,side:i,above:s}=this._axes(),o=Math.tan(this.fov*Math.PI/360),c=o*e/t;return{position:this.position,corner:De(De(r,i,-c),s,o),stepX:rn(i,2*c/e),stepY:rn(s,-2*o/t)}}_away(e){let t=Math.cos(this.elevation),r=this.azimuth+e;return[t*Math.sin(r),Math.sin(this.elevation),t*Math.cos(r)]}_axes(e=this.turntable){let t=rn(this._away(e),-1),r=Tc(as(t,[0,1,0]));return{forward:t,side:r,above:as(r,t)}}};var He=Math.PI/180,Sc={deg:He,rad:1},Nc={m:1,cm:.01,mm:.001},Ic={"%":.01};function qn(n,e){throw new Error(`expected ${n}, found ${JSON.stringify(e)}`)}function Ur(n,e){let[,t,r]=/^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)([a-z%]+)$/i.exec(n)??[];return Object.hasOwn(e,r??"")?Number(t)*e[r]:null}function sn(n,e,t){let r=n.trim().split(/\s+/);return r.length!==t.length&&qn(e,n),r.map((i,s)=>i==="auto"?null:t[s](i)??qn(e,n))}var It=n=>Ur(n,Sc),$n=n=>Ur(n,Nc),Tt=(n,e,t=!1)=>r=>{let i=Number(r);return r.trim()!==""&&i>=n&&i<=e&&(!t||Number.isInteger(i))?i:qn(`a ${t?"whole ":""}number from ${n} to ${e}`,r)},St=(...n)=>e=>n.includes(e)?e:qn(n.join(" or "),e),mt=n=>n,Ve=()=>!0;function Oc(n){let e=o=>$n(o)??Ur(o,Ic),[t,r,i]=sn(n,"THETA PHI RADIUS, as 45deg 75deg 2m",[It,It,e]),s=n.trim().endsWith("%");return{azimuth:t,elevation:r===null?null:Cr(Math.PI/2-r),distance:s?null:i,share:s?i:null}}var Mc=n=>sn(n,"X Y Z, as 0m 0.5m 0m",[$n,$n,$n]);function Lc(n){let[e]=sn(n,"an angle, as 30deg",[It]);return e===null?null:Math.min(170,Math.max(1,e/He))}var ls=n=>sn(n,"an angle, as 90deg",[It])[0]/He;function Fc(n){if(n.trim()==="none")return{sun:0};let e=s=>s>=0?Number(s):null,[t,r,i]=sn(n,"none or AZIMUTH HEIGHT BRIGHTNESS, as 40deg 45deg 2",[It,It,e]);return{sunAzimuth:(t??40*He)/He,sunHeight:(r??45*He)/He,sun:i??2}}var on={src:mt,alt:mt,poster:mt,scene:mt,environment:mt,tier:mt,api:mt,loading:St("auto","lazy","eager"),reveal:St("auto","manual"),"camera-orbit":Oc,"camera-target":Mc,"field-of-view":Lc,sun:Fc,"light-rotation":ls,"environment-intensity":Tt(0,1e6),ground:Ve,exposure:Tt(-30,30),"view-transform":St("srgb","filmic"),"camera-controls":Ve,"disable-zoom":Ve,"disable-pan":Ve,"disable-light":Ve,"touch-action":St("pan-y","pan-x","none"),"wheel-zoom":St("focus","always"),"auto-rotate":Ve,"auto-rotate-delay":Tt(0,1e9),"rotation-per-second":ls,samples:Tt(1,1e6,!0),"pixel-ratio":Tt(.1,8),jitter:Tt(0,1),"first-look":St("auto","off")},Wn=n=>n.replace(/-(.)/g,(e,t)=>t.toUpperCase()),jn=n=>String(Number(n.toPrecision(6))),Nt=n=>`${jn(n)}deg`,us=n=>`${jn(n)}m`;function an({azimuth:n,elevation:e,distance:t,target:r,fov:i}){let s=n/He,o=s-360*Math.round(s/360);return{cameraOrbit:`${Nt(o)} ${Nt(90-e/He)} ${us(t)}`,cameraTarget:r.map(us).join(" "),fieldOfView:Nt(i)}}function Zn({rotation:n,strength:e,suns:t,sun:r,sunAzimuth:i,sunHeight:s}){return{sun:t||!(r>0)?"none":`${Nt(i)} ${Nt(s)} ${jn(r)}`,lightRotation:Nt(n),environmentIntensity:jn(e)}}var Pc=`
<div id="view" part="view"></div>
<slot></slot>
<div id="poster"><slot name="poster"><img part="poster" alt="" hidden></slot></div>
<div id="over">
  <div id="loading" hidden>
    <slot name="progress-bar"><progress id="bar" part="progress-bar" aria-label="Loading"></progress><span id="bytes"></span></slot>
  </div>
  <p id="notice" part="notice" role="alert" hidden></p>
</div>
<p id="keys" class="spoken">
  Arrow keys or one finger orbit. Plus, minus or a pinch go nearer and farther. Square brackets, Shift and arrow keys, or
  two fingers turn the light. Home resets.
</p>
<p id="status" class="spoken" role="status"></p>
`,zc=`
:host {
  display: block; position: relative; overflow: hidden; width: 100%; aspect-ratio: 16 / 10;
  background-color: rgb(64, 67, 71); color: #fff; font: 13px/1.45 system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif;
}
:host([hidden]), [hidden] { display: none !important; }
#view, canvas, #poster, #poster img, ::slotted([slot="poster"]) { position: absolute; inset: 0; width: 100%; height: 100%; }
#view { background-color: inherit; }
canvas { display: block; }
canvas:focus-visible { outline: 2px solid #fff; outline-offset: -2px; }
:host([camera-controls]) canvas { cursor: grab; }
:host([camera-controls]) canvas.dragging { cursor: grabbing; }
#poster { pointer-events: none; }
::slotted([slot="poster"]) { pointer-events: auto; }
#poster img { object-fit: contain; }
#over {
  position: absolute; inset: 0; padding: 16px; pointer-events: none; overflow: hidden; box-sizing: border-box;
  display: flex; flex-direction: column; justify-content: flex-end; align-items: center; gap: 10px;
}
#loading { text-align: center; font-variant-numeric: tabular-nums; }
#bar {
  display: block; width: min(60vw, 320px); max-width: 100%; height: 4px; margin-bottom: 6px; border: 0; border-radius: 2px;
  appearance: none; background: #3a3a3a;
}
#bar::-webkit-progress-bar { background: #3a3a3a; border-radius: 2px; }
#bar::-webkit-progress-value { background: #cfcfcf; border-radius: 2px; }
#bar::-moz-progress-bar { background: #cfcfcf; border-radius: 2px; }
#notice {
  max-width: min(100%, 60ch); margin: 0; padding: 10px 16px; border-radius: 6px; pointer-events: auto; text-align: center;
  background: #7a2525; border: 1px solid #a34a4a; overflow-wrap: anywhere;
}
#notice.calm { background: #000c; border-color: #555; }
#notice span { display: block; }
.spoken { position: absolute; width: 1px; height: 1px; margin: 0; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
`,Yn=null;function fs(n){let e=n.attachShadow({mode:"open",delegatesFocus:!0});return Yn??=new CSSStyleSheet,Yn.cssRules.length||Yn.replaceSync(zc),e.adoptedStyleSheets=[Yn],e.innerHTML=Pc,e}var Cc=["front","front right","right","back right","back","back left","left","front left"],hs=20*Math.PI/180;function ps({azimuth:n,elevation:e}){let t=Math.round(4*n/Math.PI),r=Cc[(t%8+8)%8],i=e>hs?", from above":e<-hs?", from below":"";return`View from the ${r}${i}`}var Dr={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,RNA_NOTHING:4294967295,RNA_IS_SEGMENT:1,RNA_SURFACE_SHIFT:1,RNA_HAS_BEFORE:1,RNA_HAS_AFTER:2,NONE:4294967295,SUM_BEAUTY:0,SUM_NORMAL:1,SUM_POSITION:2,SUM_LIGHT_SAMPLES:3,SUM_BEHIND:4,IS_LIGHT:2147483648,MATERIAL_PART:4294967294,CATCHER_PART:4294967293,SUM_GROUPS:5,CAMERA_RAY:1,SHADOW_RAY:4,ALL_DIRECTIONS:4294967295,HEMISPHERE:4294967294,CHOICES:1,DIRECTION:2,ROULETTE:3,LIGHT:4,DIMENSIONS:7,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32,OF_MATERIAL:0,OF_NEURAL:1,OF_FIBERS:2,EMITS:1,LETS_THROUGH:2,IS_GLASS:4,HAS_CUTOFF:8,HAS_SCHLICK:16,BASE:0,METAL:1,COAT:2,GLOW:3,CLEAR:4,CLEAR_ROUGH:5,THROUGH:6,RELIEF:7,LIGHT_SEEN:1,LIGHT_DELTA:2,LIGHT_INFINITE:4,DIRECTIONAL:0,SUN:1,POINT:2,RECTANGLE:3,DISK:4,SPHERE:5,UNIFORM:6,IMAGE:7,TRIANGLES:8},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:484,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12}}},RnaRow:{words:16,members:{position:{at:0,type:"u32",count:3},h:{at:3,type:"u32",count:1},axis:{at:4,type:"u32",count:3},reserved:{at:7,type:"u32",count:1},wo:{at:8,type:"u32",count:3},reserved_2:{at:11,type:"u32",count:1},wi:{at:12,type:"u32",count:3},reserved_3:{at:15,type:"u32",count:1}}},RnaNode:{words:8,members:{low:{at:0,type:"f32",count:3},child:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},count:{at:7,type:"u32",count:1}}},RnaPrimitive:{words:4,members:{a:{at:0,type:"u32",count:1},b:{at:1,type:"u32",count:1},c:{at:2,type:"u32",count:1},tag:{at:3,type:"u32",count:1}}},RnaInstance:{words:32,members:{to_object:{at:0,type:"f32",count:12},rotation:{at:12,type:"f32",count:12},place:{at:24,type:"f32",count:3},scale:{at:27,type:"f32",count:1},root:{at:28,type:"u32",count:1},rays:{at:29,type:"u32",count:1},extent:{at:30,type:"f32",count:1},own:{at:31,type:"u32",count:1}}},Frame:{words:40,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},branch:{at:25,type:"u32",count:1},branches:{at:26,type:"u32",count:1},neural_part:{at:27,type:"u32",count:1},list:{at:28,type:"u32",count:1},next_list:{at:29,type:"u32",count:1},table_size:{at:30,type:"u32",count:1},objects:{at:31,type:"u32",count:1},surfaces:{at:32,type:"u32",count:1},lights:{at:33,type:"u32",count:1},albedo:{at:34,type:"u32",count:1},domains:{at:35,type:"u32",count:1},textures:{at:36,type:"u32",count:1}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},own:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Query:{words:24,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},reserved:{at:23,type:"u32",count:1}}},PathQueries:{words:48,members:{at_point:{at:0,record:"Query",count:1},at_light:{at:24,record:"Query",count:1}}},Object:{words:4,members:{number:{at:0,type:"f32",count:1},catches:{at:1,type:"u32",count:1},step:{at:2,type:"f32",count:1},passes:{at:3,type:"u32",count:1}}},Surface:{words:36,members:{kind:{at:0,type:"u32",count:1},part:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},normal_map:{at:3,type:"u32",count:1},base_color:{at:4,type:"f32",count:3},roughness:{at:7,type:"f32",count:1},metallic:{at:8,type:"f32",count:1},coat_f0:{at:9,type:"f32",count:1},coat_weight:{at:10,type:"f32",count:1},transmission:{at:11,type:"f32",count:1},emission:{at:12,type:"f32",count:3},normal_scale:{at:15,type:"f32",count:1},clear_coat:{at:16,type:"f32",count:1},clear_coat_roughness:{at:17,type:"f32",count:1},second_uvs:{at:18,type:"u32",count:1},tangents:{at:19,type:"u32",count:1},textures:{at:20,type:"u32",count:8},through:{at:28,type:"u32",count:1},cutoff:{at:29,type:"f32",count:1},ior:{at:30,type:"f32",count:2},f0:{at:32,type:"f32",count:1}}},Texture:{words:12,members:{place:{at:0,type:"u32",count:1},size:{at:1,type:"u32",count:1},form:{at:2,type:"u32",count:1},row_u:{at:4,type:"f32",count:3},row_v:{at:8,type:"f32",count:3}}},Light:{words:32,members:{kind:{at:0,type:"u32",count:1},group:{at:1,type:"u32",count:1},flags:{at:2,type:"u32",count:1},instance:{at:3,type:"u32",count:1},numbers:{at:4,type:"f32",count:20},probability:{at:24,type:"f32",count:3},places:{at:28,type:"u32",count:4}}}},lights:{directional:{colour:0,axis:3},sun:{colour:0,axis:3,one_minus_cosine:6},point:{colour:0,place:3,axis:6,cos_inner:9,cos_outer:10},rectangle:{colour:0,frame:3,half:15},disk:{colour:0,frame:3,radius:15},sphere:{colour:0,centre:3,radius:6},uniform:{colour:0},image:{colour:0,turn_cosine:3,turn_sine:4,total:5,mean:6,rows:7,columns:8},triangles:{colour:0,rotation:3,place:12,scale:15}},viewerLights:{sun:0,environment:1,given:2,aroundPoint:3,mirror:4}};var{constants:se,records:ce,viewerLights:cn}=Dr;function ms(n){for(let[,e,t]of n.matchAll(/struct (\w+) \{([^}]*)\}/g)){let r={},i=0;for(let[,s,o]of t.matchAll(/^\s*(\w+): ([\w<>]+)/gm)){let c=Number(/vec(\d)/.exec(o)?.[1]??1),l=c===3?4:c,f=Math.ceil(i/l)*l;r[s]={at:f,type:o.includes("u32")?"u32":"f32",count:c},i=f+c}ce[e]={words:4*Math.ceil(i/4),members:r}}}function le(n,e){let t=new Uint32Array(ce[n].words);return gs(t,new Float32Array(t.buffer),0,n,e),t}var Vn=n=>Object.entries(cn).map(([e,t])=>n(`LIGHT_${e.replace(/[A-Z]/g,"_$&").toUpperCase()}`,t)).join(`
`),Xe=n=>4*ce[n].words;function ds(n,e){let t=[];for(let[r,i]of Object.entries(e))[i].flat().forEach((s,o)=>{t[Dr.lights[n][r]+o]=s});return Float32Array.from(t,r=>r??0)}function gs(n,e,t,r,i){for(let[s,o]of Object.entries(i)){let{at:c,type:l,record:f}=ce[r].members[s],h=t+c,m=typeof o=="number"?[o]:o;f?[m].flat().forEach((g,_)=>gs(n,e,h+_*ce[f].words,f,g)):(l==="f32"?e:n).set(m,h)}}var{words:Hr,members:ln}=ce.RnaNode,Be=16,Dc=4,Hc=24;function _s(n,e=0){let t=n.length/6,r=Uint32Array.from({length:t},(h,m)=>m),i=new Float32Array(3*t);for(let h=0;h<t;h++)for(let m=0;m<3;m++)i[3*h+m]=.5*(n[6*h+m]+n[6*h+3+m]);let s=new Float32Array(2*Hr*t),o=new Uint32Array(s.buffer),c={boxes:n,centres:i,order:r},l=[[0,t,0,-1]],f=0;for(;l.length;){let[h,m,g,_]=l.pop(),x=Hr*f;f+=1,_>=0&&(o[_+ln.child.at]=e+f-1),Bc(c,h,m);for(let F=0;F<3;F++)s[x+ln.low.at+F]=ve[F],s[x+ln.high.at+F]=ve[3+F];if(m-h<=Dc){o[x+ln.child.at]=h,o[x+ln.count.at]=m-h;continue}let R=g<Hc?$c(c,h,m):h;h<R&&R<m||(R=qc(c,h,m)),l.push([R,m,g+1,x],[h,R,g+1,-1])}return{nodes:o.slice(0,Hr*f),order:r}}function jr(n,e,t,r){for(let i=0;i<3;i++)n[e+i]=Math.min(n[e+i],t[r+i]),n[e+3+i]=Math.max(n[e+3+i],t[r+3+i])}function Wr(n){for(let e=0;e<n.length;e+=6)for(let t=0;t<3;t++)n[e+t]=1/0,n[e+3+t]=-1/0;return n}var ve=new Float32Array(6),$r=new Float32Array(6*Be),qr=new Uint32Array(Be),Br=new Float64Array(Be),Gr=new Float64Array(Be);function Bc({boxes:n,order:e},t,r){Wr(ve);for(let i=t;i<r;i++)jr(ve,0,n,6*e[i])}function ws({centres:n,order:e},t,r,i){let s=1/0,o=-1/0;for(let c=t;c<r;c++){let l=n[3*e[c]+i];s=Math.min(s,l),o=Math.max(o,l)}return[s,o]}var ys=(n,e,t)=>Math.min(Math.floor((n-e)/(t-e)*Be),Be-1);function Gc({boxes:n,centres:e,order:t},r,i,s,o,c){Wr($r),qr.fill(0);for(let h=r;h<i;h++){let m=ys(e[3*t[h]+s],o,c);qr[m]+=1,jr($r,6*m,n,6*t[h])}vs(Gr,Be-1,-1),vs(Br,0,1);let l=1/0,f=0;for(let h=1;h<Be;h++)Br[h-1]+Gr[h]<l&&(l=Br[h-1]+Gr[h],f=h);return{cost:l,cut:f,axis:s,low:o,high:c}}function vs(n,e,t){Wr(ve);for(let r=e,i=0;r>=0&&r<Be;r+=t){jr(ve,0,$r,6*r),i+=qr[r];let s=ve[3]-ve[0],o=ve[4]-ve[1],c=ve[5]-ve[2];n[r]=i?(s*o+o*c+c*s)*i:1/0}}function $c(n,e,t){let r={cost:1/0};for(let g=0;g<3;g++){let[_,x]=ws(n,e,t,g),R=x>_?Gc(n,e,t,g,_,x):r;R.cost<r.cost&&(r=R)}if(r.cost===1/0)return e;let{centres:i,order:s}=n,{axis:o,cut:c,low:l,high:f}=r,h=e,m=t-1;for(;h<=m;){let g=s[h];ys(i[3*g+o],l,f)<c?h++:(s[h]=s[m],s[m--]=g)}return h}function qc(n,e,t){let{centres:r,order:i}=n,s=[0,1,2].map(c=>{let[l,f]=ws(n,e,t,c);return f-l}),o=s.indexOf(Math.max(...s));return i.subarray(e,t).sort((c,l)=>r[3*c+o]-r[3*l+o]),Math.floor((e+t)/2)}var{NONE:jc,OF_NEURAL:Wc,OF_FIBERS:Zc,LETS_THROUGH:xs,HAS_CUTOFF:Yc}=se,Xn=class{constructor(){Object.assign(this,{surfaces:[],textures:[],images:[],imagesLength:0})}ofFibers(e){return this._add({kind:Zc,part:e})}ofTriangles({mesh:e,transmittance:t,normalMaps:r},i){let s=e.indices.length/3,o=bs(t,s),c=bs(r,s),l=new Map,f=new Uint32Array(s);for(let h=0;h<s;h++){let m=`${c[h]} ${o[h]}`;l.has(m)||l.set(m,this._ofRecords(i,r[c[h]],t[o[h]])),f[h]=l.get(m)}return f}arrays(){let e=this.surfaces.map(s=>le("Surface",s)),t=Uint32Array.from([...e,...this.textures].flatMap(s=>[...s])),r=new Uint32Array(this.imagesLength),i=0;for(let s of this.images)r.set(s,i),i+=s.length;return{table:t,images:r,texturesAt:e.reduce((s,o)=>s+o.length/4,0),hasTextures:this.textures.length>0,transmits:this.surfaces.some(({flags:s})=>s&xs)}}_add(e){return this.surfaces.push({normal_map:jc,...e})-1}_ofRecords(e,t,r){let i={kind:Wc,part:e};return t&&(i.normal_map=this._texture(t.texture)),r&&(i.flags=xs|(r.cutoff==null?0:Yc),Object.assign(i,{through:this._texture(r.texture),cutoff:r.cutoff??0,ior:r.ior??[0,0]})),this._add(i)}_texture({values:e,width:t,height:r,channels:i}){let s=new Uint32Array(t*r),o=this.imagesLength;for(let c=0;c<s.length;c++){let[l,f=l,h=i===1?l:0]=e.subarray(i*c,i*(c+1));s[c]=l|f<<8|h<<16}return this.images.push(s),this.imagesLength+=s.length,this.textures.push(le("Texture",{place:o,size:r<<16|t,row_u:[1,0,0],row_v:[0,1,0]}))-1}};function bs(n,e){let t=new Int32Array(e).fill(-1);return n.forEach(({triangles:[r,i]},s)=>t.fill(s,r,r+i)),t}var{RNA_HAS_BEFORE:Vc,RNA_HAS_AFTER:Xc,RNA_IS_SEGMENT:Kc,RNA_SURFACE_SHIFT:As}=se,un=ce.RnaPrimitive,Ke=ce.RnaNode;function Kn(n){let e=n.map(Jc),t=h=>e.reduce((m,g)=>m+g[h],0),r={primitives:new Uint32Array(un.words*t("primitives")),points:new Float32Array(4*t("points")),normals:new Float32Array(4*t("normals")),boxes:new Float32Array(6*t("primitives")),surfaces:new Xn,parts:[],extent:0,strands:0};r.harmonics=n.some(({environment:h})=>h?.harmonics)?new Int8Array(16*t("points")):null;let i={primitive:0,point:0},s=[...n.keys()].sort((h,m)=>(n[h].kind==="fiber")-(n[m].kind==="fiber"));for(let h of s){let m=n[h];r.parts[h]={first:i.primitive,fiber:m.kind==="fiber"},m.kind==="fiber"?el(r,m.curves,h,i):Qc(r,m,h,i),m.environment?.harmonics&&r.harmonics.set(m.environment.harmonics,16*i.point),i={primitive:i.primitive+e[h].primitives,point:i.point+e[h].points}}let{nodes:o,order:c}=_s(r.boxes,1),l=new Uint32Array(r.primitives.length),f=new Uint32Array(c.length);return c.forEach((h,m)=>{l.set(r.primitives.subarray(un.words*h,un.words*(h+1)),un.words*m),f[h]=m}),{...r,boxes:null,...r.surfaces.arrays(),primitives:l,nodes:tl(o),where:f,box:nl(o)}}function Jc({kind:n,mesh:e,curves:t}){if(n==="surface"){let i=e.positions.length/3;return{primitives:e.indices.length/3,points:i,normals:i}}let r=t.radii.length;return{primitives:r-(t.offsets.length-1),points:r,normals:0}}function Qc(n,e,t,{primitive:r,point:i}){let{positions:s,normals:o,uvs:c,indices:l}=e.mesh,{points:f,boxes:h,primitives:m}=n;for(let _=0;_<s.length/3;_++){let x=4*(i+_);for(let R=0;R<3;R++)f[x+R]=s[3*_+R],n.normals[x+R]=o[3*_+R],n.extent=Math.max(n.extent,Math.abs(s[3*_+R]));f[x+3]=c?c[2*_]:0,n.normals[x+3]=c?c[2*_+1]:0}let g=n.surfaces.ofTriangles(e,t);for(let _=0;_<l.length/3;_++){let x=[0,1,2].map($=>l[3*_+$]),[R,F,W]=x.map($=>$+i);Rs(m,r+_,R,F,W,g[_]<<As);for(let $=0;$<3;$++){let V=x.map(ne=>s[3*ne+$]);h[6*(r+_)+$]=Math.min(...V),h[6*(r+_)+3+$]=Math.max(...V)}}}function el(n,e,t,{primitive:r,point:i}){let{boxes:s,primitives:o}=n,{radii:c,offsets:l}=e,f=n.surfaces.ofFibers(t);for(let m=0;m<c.length;m++){let[g,_,x]=e.points.subarray(3*m,3*m+3);n.points.set([g,_,x,c[m]],4*(i+m)),n.extent=Math.max(n.extent,Math.max(Math.abs(g),Math.abs(_),Math.abs(x))+c[m])}let h=r;for(let m=0;m+1<l.length;m++,n.strands++)for(let g=l[m];g+1<l[m+1];g++,h++){let _=(g>l[m]&&Vc)|(g+2<l[m+1]&&Xc);Rs(o,h,i+g,_,n.strands,f<<As|Kc);for(let x=0;x<3;x++){let R=e.points[3*g+x],F=e.points[3*g+3+x],W=c[g]*1.0005,$=c[g+1]*1.0005;s[6*h+x]=Math.min(R-W,F-$),s[6*h+3+x]=Math.max(R+W,F+$)}}}function Rs(n,e,t,r,i,s){let{members:o,words:c}=un,l=c*e;n[l+o.a.at]=t,n[l+o.b.at]=r,n[l+o.c.at]=i,n[l+o.tag.at]=s}function tl(n){let e=new Uint32Array(n.length+Ke.words);return e.set(n.subarray(0,Ke.words)),e[Ke.members.child.at]=0,e[Ke.members.count.at]=1,e.set(n,Ke.words),e}function nl(n){let e=new Float32Array(n.buffer,0,Ke.words),t=({at:r,count:i})=>[...e.subarray(r,r+i)];return{min:t(Ke.members.low),max:t(Ke.members.high)}}var Es=[1024,512];function ks(n){let{rgb:e,width:t,height:r}=sl(n),i=[0,e.length,e.length+r+1,e.length+2*r+3],s=new Float32Array(i[3]+(r+1)*(t+1));s.set(e);let o=l=>Math.cos(Math.PI*Math.min(1,Math.max(0,(l-.5)/r))),c=0;for(let l=0;l<=r;l++){let f=o(l)-o(l+1),h=t*Math.max(l-1,0),m=t*Math.min(l,r-1);s[i[1]+l]=f;let g=0;for(let _=0;_<t;_++){let x=(_+1)%t,R=[h+_,h+x,m+_,m+x].reduce((F,W)=>F+rl(e,W),0);g+=R/4*f,s[i[3]+l*(t+1)+_+1]=g}c+=g,s[i[2]+l+1]=c}return{floats:s,places:i,total:c,width:t,height:r,up:il(e,t,r)}}var rl=(n,e)=>.2126*n[3*e]+.7152*n[3*e+1]+.0722*n[3*e+2];function il(n,e,t){let r=[0,0,0];for(let i=0;i<t;i++){let s=Math.PI*(i+.5)/t,o=2*Math.PI**2*Math.sin(s)/(e*t)*Math.max(0,Math.cos(s));for(let c=0;c<3*e;c++)r[c%3]+=n[3*e*i+c]*o}return r}function sl({rgb:n,width:e,height:t}){let r=Math.max(1,Math.ceil(e/Es[0]),Math.ceil(t/Es[1]));if(r===1)return{rgb:n,width:e,height:t};let i=Math.ceil(e/r),s=Math.ceil(t/r),o=new Float32Array(3*i*s);for(let c=0;c<s;c++)for(let l=0;l<i;l++){let f=0;for(let h=c*r;h<Math.min(t,(c+1)*r);h++)for(let m=l*r;m<Math.min(e,(l+1)*r);m++,f++)for(let g=0;g<3;g++)o[3*(c*i+l)+g]+=n[3*(h*e+m)+g];for(let h=0;h<3;h++)o[3*(c*i+l)+h]/=f}return{rgb:o,width:i,height:s}}function Jn(n){return{rgb:Float32Array.from({length:96},(r,i)=>n[i%3]),width:8,height:4}}function Ts(){let t=new Float32Array(24576),r=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let i=0;i<64;i++){let s=Math.PI*(i+.5)/64;for(let o=0;o<128;o++){let c=2*Math.PI*((o+.5)/128-.5),l=[Math.sin(s)*Math.sin(c),Math.cos(s),-Math.sin(s)*Math.cos(c)],f=.16+.14*Math.max(0,l[1]);for(let h=0;h<3;h++){let m=f*[.95,1,1.08][h];for(let[g,_,x]of r){let R=(l[0]*g[0]+l[1]*g[1]+l[2]*g[2])/Math.hypot(...g);m+=x[h]*Math.min(1,Math.max(0,(R-_)/.03))}t[3*(i*128+o)+h]=m}}}return{rgb:t,width:128,height:64}}var Zr=0,Yr=1,Vr=2,Xr=3,Kr=4,Jr=5,Qr=6,ei=7;var ti=1006;var Ot=1015,Mt=1016;var Je=1023;var fn=1028;var Lt=1030;var Qe="srgb-linear";var Ss=null;function ol(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ns(...n){n=ol(n);let e="THREE."+n.shift();if(Ss)Ss("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}var fp={[Zr]:Zr,[Vr]:Qr,[Kr]:Kr,[Xr]:Jr,[Yr]:Yr,[Qr]:Vr,[ei]:ei,[Jr]:Xr};var pp=Math.PI/180,mp=180/Math.PI;function Is(n,e,t){return Math.max(e,Math.min(t,n))}var Ge=al();function al(){let n=new ArrayBuffer(4),e=new Float32Array(n),t=new Uint32Array(n),r=new Uint32Array(512),i=new Uint32Array(512);for(let l=0;l<256;++l){let f=l-127;f<-27?(r[l]=0,r[l|256]=32768,i[l]=24,i[l|256]=24):f<-14?(r[l]=1024>>-f-14,r[l|256]=1024>>-f-14|32768,i[l]=-f-1,i[l|256]=-f-1):f<=15?(r[l]=f+15<<10,r[l|256]=f+15<<10|32768,i[l]=13,i[l|256]=13):f<128?(r[l]=31744,r[l|256]=64512,i[l]=24,i[l|256]=24):(r[l]=31744,r[l|256]=64512,i[l]=13,i[l|256]=13)}let s=new Uint32Array(2048),o=new Uint32Array(64),c=new Uint32Array(64);for(let l=1;l<1024;++l){let f=l<<13,h=0;for(;(f&8388608)===0;)f<<=1,h-=8388608;f&=-8388609,h+=947912704,s[l]=f|h}for(let l=1024;l<2048;++l)s[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(c[l]=1024);return{floatView:e,uint32View:t,baseTable:r,shiftTable:i,mantissaTable:s,exponentTable:o,offsetTable:c}}function cl(n){Math.abs(n)>65504&&Ns("DataUtils.toHalfFloat(): Value out of range."),n=Is(n,-65504,65504),Ge.floatView[0]=n;let e=Ge.uint32View[0],t=e>>23&511;return Ge.baseTable[t]+((e&8388607)>>Ge.shiftTable[t])}function ll(n){let e=n>>10;return Ge.uint32View[0]=Ge.mantissaTable[Ge.offsetTable[e]+(n&1023)]+Ge.exponentTable[e],Ge.floatView[0]}var O=class{static toHalfFloat(e){return cl(e)}static fromHalfFloat(e){return ll(e)}};var Qn=class{};var _e=Uint8Array,Ft=Uint16Array,ul=Int32Array,Os=new _e([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Ms=new _e([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),fl=new _e([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Ls=function(n,e){for(var t=new Ft(31),r=0;r<31;++r)t[r]=e+=1<<n[r-1];for(var i=new ul(t[30]),r=1;r<30;++r)for(var s=t[r];s<t[r+1];++s)i[s]=s-t[r]<<5|r;return{b:t,r:i}},Fs=Ls(Os,2),Ps=Fs.b,hl=Fs.r;Ps[28]=258,hl[258]=28;var zs=Ls(Ms,0),pl=zs.b,bp=zs.r,ii=new Ft(32768);for(X=0;X<32768;++X)$e=(X&43690)>>1|(X&21845)<<1,$e=($e&52428)>>2|($e&13107)<<2,$e=($e&61680)>>4|($e&3855)<<4,ii[X]=(($e&65280)>>8|($e&255)<<8)>>1;var $e,X,hn=(function(n,e,t){for(var r=n.length,i=0,s=new Ft(e);i<r;++i)n[i]&&++s[n[i]-1];var o=new Ft(e);for(i=1;i<e;++i)o[i]=o[i-1]+s[i-1]<<1;var c;if(t){c=new Ft(1<<e);var l=15-e;for(i=0;i<r;++i)if(n[i])for(var f=i<<4|n[i],h=e-n[i],m=o[n[i]-1]++<<h,g=m|(1<<h)-1;m<=g;++m)c[ii[m]>>l]=f}else for(c=new Ft(r),i=0;i<r;++i)n[i]&&(c[i]=ii[o[n[i]-1]++]>>15-n[i]);return c}),pn=new _e(288);for(X=0;X<144;++X)pn[X]=8;var X;for(X=144;X<256;++X)pn[X]=9;var X;for(X=256;X<280;++X)pn[X]=7;var X;for(X=280;X<288;++X)pn[X]=8;var X,Cs=new _e(32);for(X=0;X<32;++X)Cs[X]=5;var X;var ml=hn(pn,9,1);var dl=hn(Cs,5,1),ni=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},Ae=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},ri=function(n,e){var t=e/8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},gl=function(n){return(n+7)/8|0},vl=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.length),new _e(n.subarray(e,t))};var _l=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Re=function(n,e,t){var r=new Error(e||_l[n]);if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,Re),!t)throw r;return r},wl=function(n,e,t,r){var i=n.length,s=r?r.length:0;if(!i||e.f&&!e.l)return t||new _e(0);var o=!t,c=o||e.i!=2,l=e.i;o&&(t=new _e(i*3));var f=function(Tn){var Sn=t.length;if(Tn>Sn){var Kt=new _e(Math.max(Sn*2,Tn));Kt.set(t),t=Kt}},h=e.f||0,m=e.p||0,g=e.b||0,_=e.l,x=e.d,R=e.m,F=e.n,W=i*8;do{if(!_){h=Ae(n,m,1);var $=Ae(n,m+1,3);if(m+=3,$)if($==1)_=ml,x=dl,R=9,F=5;else if($==2){var je=Ae(n,m,31)+257,We=Ae(n,m+10,15)+4,Nr=je+Ae(n,m+5,31)+1;m+=14;for(var ut=new _e(Nr),ze=new _e(19),ie=0;ie<We;++ie)ze[fl[ie]]=Ae(n,m+ie*3,7);m+=We*3;for(var Rn=ni(ze),Ir=(1<<Rn)-1,ye=hn(ze,Rn,1),ie=0;ie<Nr;){var Xt=ye[Ae(n,m,Ir)];m+=Xt&15;var V=Xt>>4;if(V<16)ut[ie++]=V;else{var me=0,bt=0;for(V==16?(bt=3+Ae(n,m,3),m+=2,me=ut[ie-1]):V==17?(bt=3+Ae(n,m,7),m+=3):V==18&&(bt=11+Ae(n,m,127),m+=7);bt--;)ut[ie++]=me}}var En=ut.subarray(0,je),xe=ut.subarray(je);R=ni(En),F=ni(xe),_=hn(En,R,1),x=hn(xe,F,1)}else Re(1);else{var V=gl(m)+4,ne=n[V-4]|n[V-3]<<8,qe=V+ne;if(qe>i){l&&Re(0);break}c&&f(g+ne),t.set(n.subarray(V,qe),g),e.b=g+=ne,e.p=m=qe*8,e.f=h;continue}if(m>W){l&&Re(0);break}}c&&f(g+131072);for(var kn=(1<<R)-1,Or=(1<<F)-1,de=m;;de=m){var me=_[ri(n,m)&kn],Te=me>>4;if(m+=me&15,m>W){l&&Re(0);break}if(me||Re(2),Te<256)t[g++]=Te;else if(Te==256){de=m,_=null;break}else{var be=Te-254;if(Te>264){var ie=Te-257,Ce=Os[ie];be=Ae(n,m,(1<<Ce)-1)+Ps[ie],m+=Ce}var ft=x[ri(n,m)&Or],At=ft>>4;ft||Re(3),m+=ft&15;var xe=pl[At];if(At>3){var Ce=Ms[At];xe+=ri(n,m)&(1<<Ce)-1,m+=Ce}if(m>W){l&&Re(0);break}c&&f(g+131072);var J=g+be;if(g<xe){var Ue=s-xe,Ze=Math.min(xe,J);for(Ue+g<0&&Re(3);g<Ze;++g)t[g]=r[Ue+g]}for(;g<J;++g)t[g]=t[g-xe]}}e.l=_,e.p=de,e.b=g,e.f=h,_&&(h=1,e.m=R,e.d=x,e.n=F)}while(!h);return g!=t.length&&o?vl(t,0,g):t.subarray(0,g)};var yl=new _e(0);var xl=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&Re(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&Re(6,"invalid zlib data: "+(n[1]&32?"need":"unexpected")+" dictionary"),(n[1]>>3&4)+2};function Pt(n,e){return wl(n.subarray(xl(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var bl=typeof TextDecoder<"u"&&new TextDecoder,Al=0;try{bl.decode(yl,{stream:!0}),Al=1}catch{}var er=class extends Qn{constructor(e){super(e),this.type=Mt,this.outputFormat=Je,this.part=0}parse(e){let ut=Math.pow(2.7182818,2.2),ze=null,ie=null;function Rn(a,u){let p=0;for(let w=0;w<65536;++w)(w==0||a[w>>3]&1<<(w&7))&&(u[p++]=w);let v=p-1;for(;p<65536;)u[p++]=0;return v}function Ir(a){for(let u=0;u<16384;u++)a[u]={},a[u].len=0,a[u].lit=0,a[u].p=null}let ye={l:0,c:0,lc:0};function Xt(a,u,p,v,w){for(;p<a;)u=u<<8|Ji(v,w),p+=8;p-=a,ye.l=u>>p&(1<<a)-1,ye.c=u,ye.lc=p}let me=new Array(59);function bt(a){for(let p=0;p<=58;++p)me[p]=0;for(let p=0;p<65537;++p)me[a[p]]+=1;let u=0;for(let p=58;p>0;--p){let v=u+me[p]>>1;me[p]=u,u=v}for(let p=0;p<65537;++p){let v=a[p];v>0&&(a[p]=v|me[v]++<<6)}}function En(a,u,p,v,w,A){let d=u,k=0,b=0;for(;v<=w;v++){if(d.value-u.value>p)return!1;Xt(6,k,b,a,d);let E=ye.l;if(k=ye.c,b=ye.lc,A[v]=E,E==63){if(d.value-u.value>p)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");Xt(8,k,b,a,d);let T=ye.l+6;if(k=ye.c,b=ye.lc,v+T>w+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;T--;)A[v++]=0;v--}else if(E>=59){let T=E-59+2;if(v+T>w+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;T--;)A[v++]=0;v--}}bt(A)}function xe(a){return a&63}function kn(a){return a>>6}function Or(a,u,p,v){for(;u<=p;u++){let w=kn(a[u]),A=xe(a[u]);if(w>>A)throw new Error("THREE.EXRLoader: Invalid table entry");if(A>14){let d=v[w>>A-14];if(d.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(d.lit++,d.p){let k=d.p;d.p=new Array(d.lit);for(let b=0;b<d.lit-1;++b)d.p[b]=k[b]}else d.p=new Array(1);d.p[d.lit-1]=u}else if(A){let d=0;for(let k=1<<14-A;k>0;k--){let b=v[(w<<14-A)+d];if(b.len||b.p)throw new Error("THREE.EXRLoader: Invalid table entry");b.len=A,b.lit=u,d++}}}return!0}let de={c:0,lc:0};function Te(a,u,p,v){a=a<<8|Ji(p,v),u+=8,de.c=a,de.lc=u}let be={c:0,lc:0};function Ce(a,u,p,v,w,A,d,k,b){if(a==u){v<8&&(Te(p,v,w,A),p=de.c,v=de.lc),v-=8;let E=p>>v;if(E=new Uint8Array([E])[0],k.value+E>b)return!1;let T=d[k.value-1];for(;E-- >0;)d[k.value++]=T}else if(k.value<b)d[k.value++]=a;else return!1;be.c=p,be.lc=v}function ft(a){return a&65535}function At(a){let u=ft(a);return u>32767?u-65536:u}let J={a:0,b:0};function Ue(a,u){let p=At(a),w=At(u),A=p+(w&1)+(w>>1),d=A,k=A-w;J.a=d,J.b=k}function Ze(a,u){let p=ft(a),v=ft(u),w=p-(v>>1)&65535,A=v+w-32768&65535;J.a=A,J.b=w}function Tn(a,u,p,v,w,A,d){let k=d<16384,b=p>w?w:p,E=1,T,N;for(;E<=b;)E<<=1;for(E>>=1,T=E,E>>=1;E>=1;){N=0;let S=N+A*(w-T),M=A*E,P=A*T,I=v*E,L=v*T,D,q,B,Z;for(;N<=S;N+=P){let C=N,z=N+v*(p-T);for(;C<=z;C+=L){let U=C+I,K=C+M,Y=K+I;k?(Ue(a[C+u],a[K+u]),D=J.a,B=J.b,Ue(a[U+u],a[Y+u]),q=J.a,Z=J.b,Ue(D,q),a[C+u]=J.a,a[U+u]=J.b,Ue(B,Z),a[K+u]=J.a,a[Y+u]=J.b):(Ze(a[C+u],a[K+u]),D=J.a,B=J.b,Ze(a[U+u],a[Y+u]),q=J.a,Z=J.b,Ze(D,q),a[C+u]=J.a,a[U+u]=J.b,Ze(B,Z),a[K+u]=J.a,a[Y+u]=J.b)}if(p&E){let U=C+M;k?Ue(a[C+u],a[U+u]):Ze(a[C+u],a[U+u]),D=J.a,a[U+u]=J.b,a[C+u]=D}}if(w&E){let C=N,z=N+v*(p-T);for(;C<=z;C+=L){let U=C+I;k?Ue(a[C+u],a[U+u]):Ze(a[C+u],a[U+u]),D=J.a,a[U+u]=J.b,a[C+u]=D}}T=E,E>>=1}return N}function Sn(a,u,p,v,w,A,d,k,b){let E=0,T=0,N=d,S=Math.trunc(v.value+(w+7)/8);for(;v.value<S;)for(Te(E,T,p,v),E=de.c,T=de.lc;T>=14;){let P=E>>T-14&16383,I=u[P];if(I.len)T-=I.len,Ce(I.lit,A,E,T,p,v,k,b,N),E=be.c,T=be.lc;else{if(!I.p)throw new Error("THREE.EXRLoader: hufDecode issues");let L;for(L=0;L<I.lit;L++){let D=xe(a[I.p[L]]);for(;T<D&&v.value<S;)Te(E,T,p,v),E=de.c,T=de.lc;if(T>=D&&kn(a[I.p[L]])==(E>>T-D&(1<<D)-1)){T-=D,Ce(I.p[L],A,E,T,p,v,k,b,N),E=be.c,T=be.lc;break}}if(L==I.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let M=8-w&7;for(E>>=M,T-=M;T>0;){let P=u[E<<14-T&16383];if(P.len)T-=P.len,Ce(P.lit,A,E,T,p,v,k,b,N),E=be.c,T=be.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function Kt(a,u,p,v,w,A){let d={value:0},k=p.value,b=he(u,p),E=he(u,p);p.value+=4;let T=he(u,p);if(p.value+=4,b<0||b>=65537||E<0||E>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let N=new Array(65537),S=new Array(16384);Ir(S);let M=v-(p.value-k);if(En(a,p,M,b,E,N),T>8*(v-(p.value-k)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");Or(N,b,E,S),Sn(N,S,a,p,T,E,A,w,d)}function Wa(a,u,p){for(let v=0;v<p;++v)u[v]=a[u[v]]}function Nn(a){for(let u=1;u<a.length;u++){let p=a[u-1]+a[u]-128;a[u]=p}}function In(a,u){let p=0,v=Math.floor((a.length+1)/2),w=0,A=a.length-1;for(;!(w>A||(u[w++]=a[p++],w>A));)u[w++]=a[v++]}function Mr(a){let u=a.byteLength,p=new Array,v=0,w=new DataView(a);for(;u>0;){let A=w.getInt8(v++);if(A<0){let d=-A;u-=d+1;for(let k=0;k<d;k++)p.push(w.getUint8(v++))}else{let d=A;u-=2;let k=w.getUint8(v++);for(let b=0;b<d+1;b++)p.push(k)}}return p}function Za(a,u,p,v,w,A){let d=new DataView(A.buffer),k=p[a.idx[0]].width,b=p[a.idx[0]].height,E=3,T=Math.floor(k/8),N=Math.ceil(k/8),S=Math.ceil(b/8),M=k-(N-1)*8,P=b-(S-1)*8,I={value:0},L=new Array(E),D=new Array(E),q=new Array(E),B=new Array(E),Z=new Array(E);for(let z=0;z<E;++z)Z[z]=u[a.idx[z]],L[z]=z<1?0:L[z-1]+N*S,D[z]=new Float32Array(64),q[z]=new Uint16Array(64),B[z]=new Uint16Array(N*64);for(let z=0;z<S;++z){let U=8;z==S-1&&(U=P);let K=8;for(let G=0;G<N;++G){G==N-1&&(K=M);for(let j=0;j<E;++j)q[j].fill(0),q[j][0]=w[L[j]++],ji(I,v,q[j]),Wi(q[j],D[j]),Zi(D[j]);E==3&&Va(D);for(let j=0;j<E;++j)Xi(D[j],B[j],G*64)}let Y=0;for(let G=0;G<E;++G){let j=p[a.idx[G]].type;for(let ee=8*z;ee<8*z+U;++ee){Y=Z[G][ee];for(let pe=0;pe<T;++pe){let Q=pe*64+(ee&7)*8;d.setUint16(Y+0*j,B[G][Q+0],!0),d.setUint16(Y+2*j,B[G][Q+1],!0),d.setUint16(Y+4*j,B[G][Q+2],!0),d.setUint16(Y+6*j,B[G][Q+3],!0),d.setUint16(Y+8*j,B[G][Q+4],!0),d.setUint16(Y+10*j,B[G][Q+5],!0),d.setUint16(Y+12*j,B[G][Q+6],!0),d.setUint16(Y+14*j,B[G][Q+7],!0),Y+=16*j}}if(T!=N)for(let ee=8*z;ee<8*z+U;++ee){let pe=Z[G][ee]+8*T*2*j,Q=T*64+(ee&7)*8;for(let Se=0;Se<K;++Se)d.setUint16(pe+Se*2*j,B[G][Q+Se],!0)}}}let C=new Uint16Array(k);d=new DataView(A.buffer);for(let z=0;z<E;++z){p[a.idx[z]].decoded=!0;let U=p[a.idx[z]].type;if(p[z].type==2)for(let K=0;K<b;++K){let Y=Z[z][K];for(let G=0;G<k;++G)C[G]=d.getUint16(Y+G*2*U,!0);for(let G=0;G<k;++G)d.setFloat32(Y+G*2*U,O.fromHalfFloat(C[G]),!0)}}}function Ya(a,u,p,v,w,A){let d=new DataView(A.buffer),k=p[a],b=k.width,E=k.height,T=Math.ceil(b/8),N=Math.ceil(E/8),S=Math.floor(b/8),M=b-(T-1)*8,P=E-(N-1)*8,I={value:0},L=0,D=new Float32Array(64),q=new Uint16Array(64),B=new Uint16Array(T*64);for(let Z=0;Z<N;++Z){let C=8;Z==N-1&&(C=P);for(let z=0;z<T;++z)q.fill(0),q[0]=w[L++],ji(I,v,q),Wi(q,D),Zi(D),Xi(D,B,z*64);for(let z=8*Z;z<8*Z+C;++z){let U=u[a][z];for(let K=0;K<S;++K){let Y=K*64+(z&7)*8;for(let G=0;G<8;++G)d.setUint16(U+G*2*k.type,B[Y+G],!0);U+=16*k.type}if(T!=S){let K=S*64+(z&7)*8;for(let Y=0;Y<M;++Y)d.setUint16(U+Y*2*k.type,B[K+Y],!0)}}}k.decoded=!0}function ji(a,u,p){let v,w=1;for(;w<64;)v=u[a.value],v==65280?w=64:v>>8==255?w+=v&255:(p[w]=v,w++),a.value++}function Wi(a,u){u[0]=O.fromHalfFloat(a[0]),u[1]=O.fromHalfFloat(a[1]),u[2]=O.fromHalfFloat(a[5]),u[3]=O.fromHalfFloat(a[6]),u[4]=O.fromHalfFloat(a[14]),u[5]=O.fromHalfFloat(a[15]),u[6]=O.fromHalfFloat(a[27]),u[7]=O.fromHalfFloat(a[28]),u[8]=O.fromHalfFloat(a[2]),u[9]=O.fromHalfFloat(a[4]),u[10]=O.fromHalfFloat(a[7]),u[11]=O.fromHalfFloat(a[13]),u[12]=O.fromHalfFloat(a[16]),u[13]=O.fromHalfFloat(a[26]),u[14]=O.fromHalfFloat(a[29]),u[15]=O.fromHalfFloat(a[42]),u[16]=O.fromHalfFloat(a[3]),u[17]=O.fromHalfFloat(a[8]),u[18]=O.fromHalfFloat(a[12]),u[19]=O.fromHalfFloat(a[17]),u[20]=O.fromHalfFloat(a[25]),u[21]=O.fromHalfFloat(a[30]),u[22]=O.fromHalfFloat(a[41]),u[23]=O.fromHalfFloat(a[43]),u[24]=O.fromHalfFloat(a[9]),u[25]=O.fromHalfFloat(a[11]),u[26]=O.fromHalfFloat(a[18]),u[27]=O.fromHalfFloat(a[24]),u[28]=O.fromHalfFloat(a[31]),u[29]=O.fromHalfFloat(a[40]),u[30]=O.fromHalfFloat(a[44]),u[31]=O.fromHalfFloat(a[53]),u[32]=O.fromHalfFloat(a[10]),u[33]=O.fromHalfFloat(a[19]),u[34]=O.fromHalfFloat(a[23]),u[35]=O.fromHalfFloat(a[32]),u[36]=O.fromHalfFloat(a[39]),u[37]=O.fromHalfFloat(a[45]),u[38]=O.fromHalfFloat(a[52]),u[39]=O.fromHalfFloat(a[54]),u[40]=O.fromHalfFloat(a[20]),u[41]=O.fromHalfFloat(a[22]),u[42]=O.fromHalfFloat(a[33]),u[43]=O.fromHalfFloat(a[38]),u[44]=O.fromHalfFloat(a[46]),u[45]=O.fromHalfFloat(a[51]),u[46]=O.fromHalfFloat(a[55]),u[47]=O.fromHalfFloat(a[60]),u[48]=O.fromHalfFloat(a[21]),u[49]=O.fromHalfFloat(a[34]),u[50]=O.fromHalfFloat(a[37]),u[51]=O.fromHalfFloat(a[47]),u[52]=O.fromHalfFloat(a[50]),u[53]=O.fromHalfFloat(a[56]),u[54]=O.fromHalfFloat(a[59]),u[55]=O.fromHalfFloat(a[61]),u[56]=O.fromHalfFloat(a[35]),u[57]=O.fromHalfFloat(a[36]),u[58]=O.fromHalfFloat(a[48]),u[59]=O.fromHalfFloat(a[49]),u[60]=O.fromHalfFloat(a[57]),u[61]=O.fromHalfFloat(a[58]),u[62]=O.fromHalfFloat(a[62]),u[63]=O.fromHalfFloat(a[63])}function Zi(a){let u=.5*Math.cos(.7853975),p=.5*Math.cos(3.14159/16),v=.5*Math.cos(3.14159/8),w=.5*Math.cos(3*3.14159/16),A=.5*Math.cos(5*3.14159/16),d=.5*Math.cos(3*3.14159/8),k=.5*Math.cos(7*3.14159/16),b=new Array(4),E=new Array(4),T=new Array(4),N=new Array(4);for(let S=0;S<8;++S){let M=S*8;b[0]=v*a[M+2],b[1]=d*a[M+2],b[2]=v*a[M+6],b[3]=d*a[M+6],E[0]=p*a[M+1]+w*a[M+3]+A*a[M+5]+k*a[M+7],E[1]=w*a[M+1]-k*a[M+3]-p*a[M+5]-A*a[M+7],E[2]=A*a[M+1]-p*a[M+3]+k*a[M+5]+w*a[M+7],E[3]=k*a[M+1]-A*a[M+3]+w*a[M+5]-p*a[M+7],T[0]=u*(a[M+0]+a[M+4]),T[3]=u*(a[M+0]-a[M+4]),T[1]=b[0]+b[3],T[2]=b[1]-b[2],N[0]=T[0]+T[1],N[1]=T[3]+T[2],N[2]=T[3]-T[2],N[3]=T[0]-T[1],a[M+0]=N[0]+E[0],a[M+1]=N[1]+E[1],a[M+2]=N[2]+E[2],a[M+3]=N[3]+E[3],a[M+4]=N[3]-E[3],a[M+5]=N[2]-E[2],a[M+6]=N[1]-E[1],a[M+7]=N[0]-E[0]}for(let S=0;S<8;++S)b[0]=v*a[16+S],b[1]=d*a[16+S],b[2]=v*a[48+S],b[3]=d*a[48+S],E[0]=p*a[8+S]+w*a[24+S]+A*a[40+S]+k*a[56+S],E[1]=w*a[8+S]-k*a[24+S]-p*a[40+S]-A*a[56+S],E[2]=A*a[8+S]-p*a[24+S]+k*a[40+S]+w*a[56+S],E[3]=k*a[8+S]-A*a[24+S]+w*a[40+S]-p*a[56+S],T[0]=u*(a[S]+a[32+S]),T[3]=u*(a[S]-a[32+S]),T[1]=b[0]+b[3],T[2]=b[1]-b[2],N[0]=T[0]+T[1],N[1]=T[3]+T[2],N[2]=T[3]-T[2],N[3]=T[0]-T[1],a[0+S]=N[0]+E[0],a[8+S]=N[1]+E[1],a[16+S]=N[2]+E[2],a[24+S]=N[3]+E[3],a[32+S]=N[3]-E[3],a[40+S]=N[2]-E[2],a[48+S]=N[1]-E[1],a[56+S]=N[0]-E[0]}function Va(a){for(let u=0;u<64;++u){let p=a[0][u],v=a[1][u],w=a[2][u];a[0][u]=p+1.5747*w,a[1][u]=p-.1873*v-.4682*w,a[2][u]=p+1.8556*v}}let Lr=new Float32Array(1),Yi=new Uint32Array(Lr.buffer);function Vi(a){Lr[0]=a;let u=Yi[0],p=u>>>16&32768,v=u&2147483647;if(v>=1199570944)return p|(v>2139095040?32256:31744);if(v<947912704)return Lr[0]=Math.abs(a)+.5,p|Yi[0]-1056964608;let w=v+4095+(v>>>13&1);return p|w-939524096>>>13}function Xi(a,u,p){if(ie===null){ie=new Uint16Array(65536);for(let v=1;v<65536;++v){if((v&31744)===31744)continue;let w=O.fromHalfFloat(v),A=Math.abs(w),d=A<=1?Math.pow(A,2.2):Math.pow(ut,A-1);ie[v]=Vi(w<0?-d:d)}}for(let v=0;v<64;++v)u[p+v]=ie[Vi(a[v])]}function On(a){return new DataView(a.array.buffer,a.offset.value,a.size)}function Xa(a){let u=a.viewer.buffer.slice(a.offset.value,a.offset.value+a.size),p=new Uint8Array(Mr(u)),v=new Uint8Array(p.length);return Nn(p),In(p,v),new DataView(v.buffer)}function Fr(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),p=Pt(u),v=new Uint8Array(p.length);return Nn(p),In(p,v),new DataView(v.buffer)}function Ka(a){let u=a.viewer,p={value:a.offset.value},v=new Uint16Array(a.columns*a.lines*(a.inputChannels.length*a.type)),w=new Uint8Array(8192),A=0,d=new Array(a.inputChannels.length);for(let P=0,I=a.inputChannels.length;P<I;P++)d[P]={},d[P].start=A,d[P].end=d[P].start,d[P].nx=a.columns,d[P].ny=a.lines,d[P].size=a.type,A+=d[P].nx*d[P].ny*d[P].size;let k=Jt(u,p),b=Jt(u,p);if(b>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(k<=b)for(let P=0;P<b-k+1;P++)w[P+k]=Ye(u,p);let E=new Uint16Array(65536),T=Rn(w,E),N=he(u,p);Kt(a.array,u,p,N,v,A);for(let P=0;P<a.inputChannels.length;++P){let I=d[P];for(let L=0;L<d[P].size;++L)Tn(v,I.start+L,I.nx,I.size,I.ny,I.nx*I.size,T)}Wa(E,v,A);let S=0,M=new Uint8Array(v.buffer.byteLength);for(let P=0;P<a.lines;P++)for(let I=0;I<a.inputChannels.length;I++){let L=d[I],D=L.nx*L.size,q=new Uint8Array(v.buffer,L.end*2,D*2);M.set(q,S),S+=D*2,L.end+=D}return new DataView(M.buffer)}function Ja(a){let u=a.array.slice(a.offset.value,a.offset.value+a.size),p=Pt(u),v=a.inputChannels.length*a.lines*a.columns*a.totalBytes,w=new ArrayBuffer(v),A=new DataView(w),d=0,k=0,b=new Array(4);for(let E=0;E<a.lines;E++)for(let T=0;T<a.inputChannels.length;T++){let N=0;switch(a.inputChannels[T].pixelType){case 1:b[0]=d,b[1]=b[0]+a.columns,d=b[1]+a.columns;for(let M=0;M<a.columns;++M){let P=p[b[0]++]<<8|p[b[1]++];N+=P,A.setUint16(k,N,!0),k+=2}break;case 2:b[0]=d,b[1]=b[0]+a.columns,b[2]=b[1]+a.columns,d=b[2]+a.columns;for(let M=0;M<a.columns;++M){let P=p[b[0]++]<<24|p[b[1]++]<<16|p[b[2]++]<<8;N+=P,A.setUint32(k,N,!0),k+=4}break}}return A}function Qa(a){let u=a.array,p=a.offset.value,v=a.columns,w=a.lines,A=a.inputChannels,d=a.totalBytes,k=ae.compression==="B44A_COMPRESSION",b=new Uint8Array(w*v*d),E=new Uint16Array(16),T=0;for(let N=0;N<A.length;N++){let S=A[N],M=S.pixelType*2,P=Math.ceil(v/S.xSampling),I=Math.ceil(w/S.ySampling),L=S.xSampling===1&&S.ySampling===1;if(S.pixelType!==1){for(let B=0;B<I;B++)if(L){let Z=B*v*d+T*v;for(let C=0;C<P*M;C++)b[Z+C]=u[p++]}else p+=P*M;T+=M;continue}let D=Math.ceil(P/4),q=Math.ceil(I/4);for(let B=0;B<q;B++)for(let Z=0;Z<D;Z++){if(k&&u[p+2]>=52){let C=u[p]<<8|u[p+1],z=C&32768?C&32767:~C&65535;E.fill(z),p+=3}else{let C=u[p]<<8|u[p+1],z=u[p+2]>>2,U=32<<z,K=C+((u[p+2]<<4|u[p+3]>>4)&63)*(1<<z)-U&65535,Y=K+((u[p+3]<<2|u[p+4]>>6)&63)*(1<<z)-U&65535,G=Y+(u[p+4]&63)*(1<<z)-U&65535,j=C+(u[p+5]>>2&63)*(1<<z)-U&65535,ee=K+((u[p+5]<<4|u[p+6]>>4)&63)*(1<<z)-U&65535,pe=Y+((u[p+6]<<2|u[p+7]>>6)&63)*(1<<z)-U&65535,Q=G+(u[p+7]&63)*(1<<z)-U&65535,Se=j+(u[p+8]>>2&63)*(1<<z)-U&65535,Rt=ee+((u[p+8]<<4|u[p+9]>>4)&63)*(1<<z)-U&65535,Qt=pe+((u[p+9]<<2|u[p+10]>>6)&63)*(1<<z)-U&65535,Ne=Q+(u[p+10]&63)*(1<<z)-U&65535,ht=Se+(u[p+11]>>2&63)*(1<<z)-U&65535,zn=Rt+((u[p+11]<<4|u[p+12]>>4)&63)*(1<<z)-U&65535,Cn=Qt+((u[p+12]<<2|u[p+13]>>6)&63)*(1<<z)-U&65535,Un=Ne+(u[p+13]&63)*(1<<z)-U&65535,en=[C,j,Se,ht,K,ee,Rt,zn,Y,pe,Qt,Cn,G,Q,Ne,Un];for(let Et=0;Et<16;Et++)E[Et]=en[Et]&32768?en[Et]&32767:~en[Et]&65535;p+=14}if(S.pLinear){if(ze===null){ze=new Uint16Array(65536);for(let C=0;C<65536;C++)if((C&31744)===31744||C>32768)ze[C]=0;else{let z=O.fromHalfFloat(C);ze[C]=z<=0?0:O.toHalfFloat(8*Math.log(z))}}for(let C=0;C<16;C++)E[C]=ze[E[C]]}for(let C=0;C<4;C++){let z=B*4+C;if(!(z>=I))for(let U=0;U<4;U++){let K=Z*4+U;if(K>=P)continue;let Y=E[C*4+U];for(let G=0;G<S.ySampling;G++){let j=z*S.ySampling+G;if(!(j>=w))for(let ee=0;ee<S.xSampling;ee++){let pe=K*S.xSampling+ee;if(pe>=v)continue;let Q=j*v*d+T*v+pe*2;b[Q]=Y&255,b[Q+1]=Y>>8&255}}}}}T+=2}return new DataView(b.buffer)}function Ki(a){let u=a.viewer,p={value:a.offset.value},v=new Uint8Array(a.columns*a.lines*(a.inputChannels.length*a.type*2)),w={version:re(u,p),unknownUncompressedSize:re(u,p),unknownCompressedSize:re(u,p),acCompressedSize:re(u,p),dcCompressedSize:re(u,p),rleCompressedSize:re(u,p),rleUncompressedSize:re(u,p),rleRawSize:re(u,p),totalAcUncompressedCount:re(u,p),totalDcUncompressedCount:re(u,p),acCompression:re(u,p)};if(w.version<2)throw new Error("THREE.EXRLoader: "+ae.compression+" version "+w.version+" is unsupported");let A=new Array,d=Jt(u,p)-2;for(;d>0;){let I=Mn(u.buffer,p),L=Ye(u,p),D=L>>2&3,q=(L>>4)-1,B=new Int8Array([q])[0],Z=Ye(u,p);A.push({name:I,index:B,type:Z,compression:D}),d-=I.length+3}let k=ae.channels,b=new Array(a.inputChannels.length);for(let I=0;I<a.inputChannels.length;++I){let L=b[I]={},D=k[I];L.name=D.name,L.compression=0,L.decoded=!1,L.type=D.pixelType,L.pLinear=D.pLinear,L.width=a.columns,L.height=a.lines}let E={idx:new Array(3)};for(let I=0;I<a.inputChannels.length;++I){let L=b[I],D=L.name.lastIndexOf("."),q=D>=0?L.name.substring(D+1):L.name;for(let B=0;B<A.length;++B){let Z=A[B];q===Z.name&&L.type===Z.type&&(L.compression=Z.compression,Z.index>=0&&(E.idx[Z.index]=I),L.offset=I)}}let T,N,S;if(w.acCompressedSize>0)switch(w.acCompression){case 0:T=new Uint16Array(w.totalAcUncompressedCount),Kt(a.array,u,p,w.acCompressedSize,T,w.totalAcUncompressedCount);break;case 1:let I=a.array.slice(p.value,p.value+w.totalAcUncompressedCount),L=Pt(I);T=new Uint16Array(L.buffer),p.value+=w.totalAcUncompressedCount;break}if(w.dcCompressedSize>0){let I={array:a.array,offset:p,size:w.dcCompressedSize};N=new Uint16Array(Fr(I).buffer),p.value+=w.dcCompressedSize}if(w.rleRawSize>0){let I=a.array.slice(p.value,p.value+w.rleCompressedSize),L=Pt(I);S=Mr(L.buffer),p.value+=w.rleCompressedSize}let M=0,P=new Array(b.length);for(let I=0;I<P.length;++I)P[I]=new Array;for(let I=0;I<a.lines;++I)for(let L=0;L<b.length;++L)P[L].push(M),M+=b[L].width*a.type*2;E.idx[0]!==void 0&&b[E.idx[0]]&&Za(E,P,b,T,N,v);for(let I=0;I<b.length;++I){let L=b[I];if(!L.decoded)switch(L.compression){case 2:let D=0,q=0;for(let B=0;B<a.lines;++B){let Z=P[I][D];for(let C=0;C<L.width;++C){for(let z=0;z<2*L.type;++z)v[Z++]=S[q+z*L.width*L.height];q++}D++}break;case 1:Ya(I,P,b,T,N,v);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(v.buffer)}function Mn(a,u){let p=new Uint8Array(a),v=0;for(;p[u.value+v]!=0;)v+=1;let w=new TextDecoder().decode(p.slice(u.value,u.value+v));return u.value=u.value+v+1,w}function ec(a,u,p){let v=new TextDecoder().decode(new Uint8Array(a).slice(u.value,u.value+p));return u.value=u.value+p,v}function tc(a,u){let p=ue(a,u),v=he(a,u);return[p,v]}function nc(a,u){let p=he(a,u),v=he(a,u);return[p,v]}function ue(a,u){let p=a.getInt32(u.value,!0);return u.value=u.value+4,p}function he(a,u){let p=a.getUint32(u.value,!0);return u.value=u.value+4,p}function Ji(a,u){let p=a[u.value];return u.value=u.value+1,p}function Ye(a,u){let p=a.getUint8(u.value);return u.value=u.value+1,p}let re=function(a,u){let p=Number(a.getBigInt64(u.value,!0));return u.value+=8,p};function oe(a,u){let p=a.getFloat32(u.value,!0);return u.value+=4,p}function rc(a,u){return O.toHalfFloat(oe(a,u))}function Jt(a,u){let p=a.getUint16(u.value,!0);return u.value+=2,p}function ic(a,u){return O.fromHalfFloat(Jt(a,u))}function sc(a,u,p,v){let w=p.value,A=[];for(;p.value<w+v-1;){let d=Mn(u,p),k=ue(a,p),b=Ye(a,p);p.value+=3;let E=ue(a,p),T=ue(a,p);A.push({name:d,pixelType:k,pLinear:b,xSampling:E,ySampling:T})}return p.value+=1,A}function oc(a,u){let p=oe(a,u),v=oe(a,u),w=oe(a,u),A=oe(a,u),d=oe(a,u),k=oe(a,u),b=oe(a,u),E=oe(a,u);return{redX:p,redY:v,greenX:w,greenY:A,blueX:d,blueY:k,whiteX:b,whiteY:E}}function ac(a,u){let p=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],v=Ye(a,u);return p[v]}function cc(a,u){let p=ue(a,u),v=ue(a,u),w=ue(a,u),A=ue(a,u);return{xMin:p,yMin:v,xMax:w,yMax:A}}function lc(a,u){let p=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],v=Ye(a,u);return p[v]}function uc(a,u){let p=["ENVMAP_LATLONG","ENVMAP_CUBE"],v=Ye(a,u);return p[v]}function fc(a,u){let p=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],v=["ROUND_DOWN","ROUND_UP"],w=he(a,u),A=he(a,u),d=Ye(a,u);return{xSize:w,ySize:A,levelMode:p[d&15],roundingMode:v[d>>4]}}function hc(a,u){let p=oe(a,u),v=oe(a,u);return[p,v]}function pc(a,u){let p=oe(a,u),v=oe(a,u),w=oe(a,u);return[p,v,w]}function mc(a,u,p,v,w){if(v==="string"||v==="stringvector"||v==="iccProfile")return ec(u,p,w);if(v==="chlist")return sc(a,u,p,w);if(v==="chromaticities")return oc(a,p);if(v==="compression")return ac(a,p);if(v==="box2i")return cc(a,p);if(v==="envmap")return uc(a,p);if(v==="tiledesc")return fc(a,p);if(v==="lineOrder")return lc(a,p);if(v==="float")return oe(a,p);if(v==="v2f")return hc(a,p);if(v==="v3f")return pc(a,p);if(v==="int")return ue(a,p);if(v==="rational")return tc(a,p);if(v==="timecode")return nc(a,p);if(v==="preview"||v==="deepImageState"||v==="idmanifest")return p.value+=w,"skipped";p.value+=w}function dc(a,u){let p=Math.log2(a);return u=="ROUND_DOWN"?Math.floor(p):Math.ceil(p)}function gc(a,u,p){let v=0;switch(a.levelMode){case"ONE_LEVEL":v=1;break;case"MIPMAP_LEVELS":v=dc(Math.max(u,p),a.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return v}function Qi(a,u,p,v){let w=new Array(a);for(let A=0;A<a;A++){let d=1<<A,k=u/d|0;v=="ROUND_UP"&&k*d<u&&(k+=1);let b=Math.max(k,1);w[A]=(b+p-1)/p|0}return w}function vc(){let a=this,u=a.offset,p={value:0};for(let v=0;v<a.tileCount;v++){let w=ue(a.viewer,u),A=ue(a.viewer,u);u.value+=8,a.size=he(a.viewer,u);let d=w*a.blockWidth,k=A*a.blockHeight;a.columns=d+a.blockWidth>a.width?a.width-d:a.blockWidth,a.lines=k+a.blockHeight>a.height?a.height-k:a.blockHeight;let b=a.columns*a.totalBytes,T=a.size<a.lines*b?a.uncompress(a):On(a);u.value+=a.size;for(let N=0;N<a.lines;N++){let S=N*a.columns*a.totalBytes;for(let M=0;M<a.inputChannels.length;M++){let P=ae.channels[M].name,I=a.channelByteOffsets[P]*a.columns,L=a.decodeChannels[P];if(L===void 0)continue;p.value=S+I;let D=(a.height-(1+k+N))*a.outLineWidth;for(let q=0;q<a.columns;q++){let B=D+(q+d)*a.outputChannels+L;a.byteArray[B]=a.getter(T,p)}}}}}function _c(){let a=this,u=a.offset,p={value:0};for(let v=0;v<a.height/a.blockHeight;v++){let w=ue(a.viewer,u)-ae.dataWindow.yMin;a.size=he(a.viewer,u),a.lines=w+a.blockHeight>a.height?a.height-w:a.blockHeight;let A=a.columns*a.totalBytes,k=a.size<a.lines*A?a.uncompress(a):On(a);u.value+=a.size;for(let b=0;b<a.lines;b++){let E=w+b,T=b*A,N=(a.height-1-E)*a.outLineWidth;for(let S=0;S<a.inputChannels.length;S++){let M=ae.channels[S].name,P=a.channelByteOffsets[M]*a.columns,I=a.decodeChannels[M];if(I!==void 0){p.value=T+P;for(let L=0;L<a.columns;L++){let D=N+L*a.outputChannels+I;a.byteArray[D]=a.getter(k,p)}}}}}}function wc(){let a=this,u=a.chunkOffsets,p={value:0};for(let v=0;v<u.length;v++){let w={value:u[v]};w.value+=4;let A=ue(a.viewer,w)-ae.dataWindow.yMin;a.size=he(a.viewer,w),a.lines=A+a.blockHeight>a.height?a.height-A:a.blockHeight;let d=a.columns*a.totalBytes,k=a.size<a.lines*d,b=a.offset;a.offset=w;let E=k?a.uncompress(a):On(a);a.offset=b;for(let T=0;T<a.lines;T++){let N=A+T,S=T*d,M=(a.height-1-N)*a.outLineWidth;for(let P=0;P<a.inputChannels.length;P++){let I=ae.channels[P].name,L=a.channelByteOffsets[I]*a.columns,D=a.decodeChannels[I];if(D!==void 0){p.value=S+L;for(let q=0;q<a.columns;q++){let B=M+q*a.outputChannels+D;a.byteArray[B]=a.getter(E,p)}}}}}}function es(a,u,p,v){if(p===0)return null;let w=a.slice(u,u+p);switch(v){case"NO_COMPRESSION":return new DataView(w.buffer,w.byteOffset,w.byteLength);case"RLE_COMPRESSION":{let A=new Uint8Array(Mr(w.buffer.slice(w.byteOffset,w.byteOffset+w.byteLength))),d=new Uint8Array(A.length);return Nn(A),In(A,d),new DataView(d.buffer)}case"ZIPS_COMPRESSION":{let A=Pt(w),d=new Uint8Array(A.length);return Nn(A),In(A,d),new DataView(d.buffer)}default:throw new Error("THREE.EXRLoader: "+v+" is unsupported for deep data")}}function yc(){let a=this,u=a.chunkOffsets,p=a.width,v=a.height,w=a.deepChannels,A=ae.compression,d=a.multiPart,k=a.decodeChannels,b=a.outputChannels,E=a.byteArray instanceof Uint16Array,T=-1;for(let N=0;N<w.length;N++)if(w[N].name==="A"){T=N;break}for(let N=0;N<u.length;N++){let S={value:u[N]};d&&(S.value+=4);let M=ue(a.viewer,S)-ae.dataWindow.yMin,P=re(a.viewer,S),I=re(a.viewer,S);re(a.viewer,S);let L=es(a.array,S.value,P,A);if(S.value+=P,L===null)continue;let D=new Uint32Array(p);for(let U=0;U<p;U++)D[U]=L.getUint32(U*4,!0);let q=D[p-1];if(q===0){S.value+=I;continue}let B=es(a.array,S.value,I,A),Z=[],C=0;for(let U=0;U<w.length;U++)Z.push(C),C+=q*w[U].bytesPerSample;let z=(v-1-M)*a.outLineWidth;for(let U=0;U<p;U++){let K=U===0?0:D[U-1],G=D[U]-K;if(G===0)continue;let j=new Float32Array(b),ee=0;for(let Q=0;Q<G;Q++){let Se=K+Q,Rt=1-ee;if(Rt<=0)break;let Qt=1;if(T>=0){let Ne=w[T].bytesPerSample,ht=Z[T]+Se*Ne;Qt=Ne===2?O.fromHalfFloat(B.getUint16(ht,!0)):B.getFloat32(ht,!0)}for(let Ne=0;Ne<w.length;Ne++){let ht=w[Ne],zn=k[ht.name];if(zn===void 0)continue;let Cn=ht.bytesPerSample,Un=Z[Ne]+Se*Cn,en=Cn===2?O.fromHalfFloat(B.getUint16(Un,!0)):B.getFloat32(Un,!0);j[zn]+=en*Rt}ee+=Qt*Rt}k.A!==void 0&&(j[k.A]=ee);let pe=z+U*b;for(let Q=0;Q<b;Q++)a.byteArray[pe+Q]=E?O.toHalfFloat(j[Q]):j[Q]}}}function ts(a,u,p){let v={},w=!1;for(;;){let A=Mn(u,p);if(A==="")break;w=!0;let d=Mn(u,p),k=he(a,p),b=mc(a,u,p,d,k);b===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${d}'.`):v[A]=b}return w?v:null}function xc(a,u,p){if(a.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let v=a.getUint8(4),w=a.getUint8(5),A={singleTile:!!(w&2),longName:!!(w&4),deepFormat:!!(w&8),multiPart:!!(w&16)};p.value=8;let d=[];if(A.multiPart){for(;;){let k=ts(a,u,p);if(k===null)break;k.version=v,k.spec=A,d.push(k)}if(d.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let k=ts(a,u,p);k.version=v,k.spec=A,d.push(k)}return d}function bc(a,u,p,v,w,A){let d={size:0,viewer:u,array:p,offset:v,width:a.dataWindow.xMax-a.dataWindow.xMin+1,height:a.dataWindow.yMax-a.dataWindow.yMin+1,inputChannels:a.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:Qe};switch(a.compression){case"NO_COMPRESSION":d.blockHeight=1,d.uncompress=On;break;case"RLE_COMPRESSION":d.blockHeight=1,d.uncompress=Xa;break;case"ZIPS_COMPRESSION":d.blockHeight=1,d.uncompress=Fr;break;case"ZIP_COMPRESSION":d.blockHeight=16,d.uncompress=Fr;break;case"PIZ_COMPRESSION":d.blockHeight=32,d.uncompress=Ka;break;case"PXR24_COMPRESSION":d.blockHeight=16,d.uncompress=Ja;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":d.blockHeight=32,d.uncompress=Qa;break;case"DWAA_COMPRESSION":d.blockHeight=32,d.uncompress=Ki;break;case"DWAB_COMPRESSION":d.blockHeight=256,d.uncompress=Ki;break;default:throw new Error("THREE.EXRLoader: "+a.compression+" is unsupported")}let k={};for(let S of a.channels)switch(S.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":k[S.name]=!0,d.type=S.pixelType}let b=!1,E=!1;if(k.Y&&k.RY&&k.BY)d.outputChannels=4,d.yCbCr=!0;else if(k.R&&k.G&&k.B)d.outputChannels=4;else if(k.Y)d.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(d.outputChannels){case 4:A==Je?(b=!k.A,d.format=Je,d.colorSpace=Qe,d.outputChannels=4,d.decodeChannels={R:0,G:1,B:2,A:3}):A==Lt?(d.format=Lt,d.colorSpace=Qe,d.outputChannels=2,d.decodeChannels={R:0,G:1}):A==fn?(d.format=fn,d.colorSpace=Qe,d.outputChannels=1,d.decodeChannels={R:0}):E=!0;break;case 1:A==Je?(b=!0,d.format=Je,d.colorSpace=Qe,d.outputChannels=4,d.shouldExpand=!0,d.decodeChannels={Y:0}):A==Lt?(d.format=Lt,d.colorSpace=Qe,d.outputChannels=2,d.shouldExpand=!0,d.decodeChannels={Y:0}):A==fn?(d.format=fn,d.colorSpace=Qe,d.outputChannels=1,d.decodeChannels={Y:0}):E=!0;break;default:E=!0}if(E)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(d.yCbCr&&(d.format=Je,d.outputChannels=4,d.decodeChannels={Y:0,RY:1,BY:2},b=!0),d.type==1)switch(w){case Ot:d.getter=ic;break;case Mt:d.getter=Jt;break}else if(d.type==2)switch(w){case Ot:d.getter=oe;break;case Mt:d.getter=rc}else throw new Error("THREE.EXRLoader: unsupported pixelType "+d.type+" for "+a.compression+".");d.columns=d.width;let T=d.width*d.height*d.outputChannels;switch(w){case Ot:d.byteArray=new Float32Array(T),b&&d.byteArray.fill(1,0,T);break;case Mt:d.byteArray=new Uint16Array(T),b&&d.byteArray.fill(15360,0,T);break;default:console.error("THREE.EXRLoader: unsupported type: ",w);break}let N=0;for(let S of a.channels)d.decodeChannels[S.name]!==void 0&&(d.channelByteOffsets[S.name]=N),N+=S.pixelType*2;if(d.totalBytes=N,d.outLineWidth=d.width*d.outputChannels,a.spec.deepFormat){d.deepChannels=[];let S=0;for(let M of a.channels){let P=M.pixelType===0?4:M.pixelType*2;d.deepChannels.push({name:M.name,pixelType:M.pixelType,bytesPerSample:P}),S+=P}d.deepBytesPerSample=S,d.chunkOffsets=a._chunkOffsets,d.multiPart=a.spec.multiPart,d.decode=yc.bind(d)}else if(a.spec.singleTile){d.blockHeight=a.tiles.ySize,d.blockWidth=a.tiles.xSize;let S=gc(a.tiles,d.width,d.height),M=Qi(S,d.width,a.tiles.xSize,a.tiles.roundingMode),P=Qi(S,d.height,a.tiles.ySize,a.tiles.roundingMode);d.tileCount=M[0]*P[0];for(let I=0;I<S;I++)for(let L=0;L<P[I];L++)for(let D=0;D<M[I];D++)re(u,v);d.decode=vc.bind(d)}else if(a.spec.multiPart)d.blockWidth=d.width,d.chunkOffsets=a._chunkOffsets,d.decode=wc.bind(d);else{d.blockWidth=d.width;let S=Math.ceil(d.height/d.blockHeight);for(let M=0;M<S;M++)re(u,v);d.decode=_c.bind(d)}return d}let Ln={value:0},Fn=new DataView(e),Ac=new Uint8Array(e),Pn=xc(Fn,e,Ln),ns=Math.max(0,Math.min(this.part,Pn.length-1)),ae=Pn[ns];if(ae.spec.multiPart||ae.spec.deepFormat)for(let a=0;a<Pn.length;a++){let u=Pn[a].chunkCount;if(a===ns){ae._chunkOffsets=[];for(let p=0;p<u;p++)ae._chunkOffsets.push(re(Fn,Ln))}else for(let p=0;p<u;p++)re(Fn,Ln)}let ge=bc(ae,Fn,Ac,Ln,this.type,this.outputFormat);if(ge.decode(),ge.shouldExpand){let a=ge.byteArray;if(this.outputFormat==Je)for(let u=0;u<a.length;u+=4)a[u+2]=a[u+1]=a[u];else if(this.outputFormat==Lt)for(let u=0;u<a.length;u+=2)a[u+1]=a[u]}if(ge.yCbCr){let a=ge.byteArray,u=ge.width*ge.height;if(this.type===Mt)for(let p=0;p<u;p++){let v=p*4,w=O.fromHalfFloat(a[v]),A=O.fromHalfFloat(a[v+1]),d=O.fromHalfFloat(a[v+2]),k=(1+A)*w,b=(1+d)*w,E=(w-k*.2126-b*.0722)/.7152;a[v]=O.toHalfFloat(Math.max(0,k)),a[v+1]=O.toHalfFloat(Math.max(0,E)),a[v+2]=O.toHalfFloat(Math.max(0,b))}else for(let p=0;p<u;p++){let v=p*4,w=a[v],A=a[v+1],d=a[v+2],k=(1+A)*w,b=(1+d)*w;a[v]=Math.max(0,k),a[v+1]=Math.max(0,(w-k*.2126-b*.0722)/.7152),a[v+2]=Math.max(0,b)}}return{header:ae,width:ge.width,height:ge.height,data:ge.byteArray,format:ge.format,colorSpace:ge.colorSpace,type:this.type,minFilter:ti,magFilter:ti,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var Us=32768,Rl=2**27,Ds=2**28,Hs=1024,El=12,si=2**29,Bs=1e18;function tr(n,e,t){let r=Math.max(n,e)>Us||n*e>Rl;if(Math.min(n,e)<1||r)throw new H(`has ${n} x ${e} pixels; from 1 to ${Us} a side, 2^27 in all`);let i=n*e*El;if(i>Ds&&i>Hs*t)throw new H(`has ${n} x ${e} pixels in ${t} bytes; an image above ${Ds} bytes of radiance is at most ${Hs} times its file`)}var kl=512,Tl=2048,Sl=4096,rr=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],Nl=0,Il=2,Ol=2,Ml=4096,Gs=["RY","BY"];function $s(n){let{parts:e,flags:t}=Ul(n),r=Fl(e),i=e[r];Pl(i,e.length,t);for(let $ of[i.dataWindow,i.displayWindow])tr(...nr($),n.length);let s=e.reduce(($,V)=>$+Math.max(0,Ll(V)),0);if(s>si)throw new H(`has ${s} values in all its channels; at most ${si}`);let o=i.dataWindow,c=i.displayWindow,l=Math.max(o[0],c[0]),f=Math.min(o[2],c[2]),h=Math.max(o[1],c[1]),m=Math.min(o[3],c[3]);if(l>f||h>m)throw new H("its data window lies outside its display window");zl(i);let _=new er().setDataType(Ot).setPart(r).parse(Cl(n,i).buffer),[x,R]=nr(c),[F]=nr(o),W=new Float32Array(3*x*R);for(let $=h;$<=m;$++){let V=o[3]-$;for(let ne=l;ne<=f;ne++){let qe=4*(V*F+ne-o[0]),je=3*(($-c[1])*x+ne-c[0]);for(let We=0;We<3;We++)W[je+We]=_.data[qe+We]}}return{rgb:W,width:x,height:R}}function nr([n,e,t,r]){return[t-n+1,r-e+1]}function Ll({dataWindow:n,channels:e}){let[t,r]=nr(n);return Math.max(0,t)*Math.max(0,r)*e.length}function ai({channels:n}){let e=new Set(n.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!Gs.some(t=>e.has(t))?["Y"]:[]}function Fl(n){let e=n.findIndex(i=>ai(i).length>0);if(e>=0)return e;let t=[...new Set(n.flatMap(({channels:i})=>i.map(({name:s})=>s)))].sort();if(["Y",...Gs].every(i=>t.includes(i)))throw new H("has luminance and chroma (Y, RY, BY): save it with R, G and B");let r=t.length>12?` and ${t.length-12} more`:"";throw new H(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${r}`)}function Pl(n,e,t){let r=n.type?n.type.startsWith("deep"):(t&Tl)!==0,i=n.type?n.type==="tiledimage":(t&kl)!==0,s=o=>{throw new H(o)};r&&s("is a deep image, with any number of samples a pixel: flatten it"),n.envmap&&s("is a cube map: convert it to latitude and longitude"),n.channels.some(({x:o,y:c})=>o!==1||c!==1)&&s("has channels of fewer texels than others: save them all at full size"),rr[n.compression]===void 0&&s(`has compression ${n.compression}, expected one of ${rr.join(", ")}`),i&&e>1&&s("has tiles in one of several parts: save it with scan lines"),i&&n.levels===Ol&&s("has tiles of several sizes by row and column: save it with one size")}function zl(n){let e=ai(n),t=new Set;for(let{name:r,type:i}of n.channels)e.includes(r)&&t.add(["uint32","float16","float32"][i]);if(t.size>1||t.has("uint32"))throw new H(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function Cl(n,e){let t=n.slice(),r=ai(e),i=e.channels.find(({name:o})=>o===r[0]).type,s=["DWAA","DWAB"].includes(rr[e.compression]);for(let o of e.channels)if(o.type===Nl&&rr[e.compression]!=="PXR24"&&(t[o.typeAt]=Il),["A","Y","RY","BY"].includes(o.name)&&!r.includes(o.name)&&!(s&&o.type===i))for(let l=0;l<o.name.length;l++)t[o.at+l]|=32;return t}function Ul(n){let e=new DataView(n.buffer,n.byteOffset,n.length),t=e.getUint32(4,!0),r={bytes:n,view:e,at:8},i=[];do{let s=Dl(r);if(s===null)break;i.push(s)}while(t&Sl);if(!i.length)throw new H("broken EXR image: it has no header");return{parts:i,flags:t}}function Dl(n){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=n;for(let i=0;;i++){let s=oi(n);if(s===""){if(i===0)return null;break}let o=oi(n),c=t.getInt32(n.at,!0),l=n.at+4;if(c<0||l+c>n.bytes.length||i>Ml)throw new H("broken EXR image: an attribute goes past the file's end");s==="channels"&&(e.channels=Hl({...n,at:l})),s==="compression"&&(e.compression=t.getUint8(l)),(s==="dataWindow"||s==="displayWindow")&&(e[s]=[0,4,8,12].map(f=>t.getInt32(l+f,!0))),s==="type"&&(e.type=String.fromCharCode(...n.bytes.subarray(l,l+Math.min(c,64)))),s==="envmap"&&o==="envmap"&&(e.envmap=t.getUint8(l)),s==="tiles"&&(e.levels=t.getUint8(l+8)&15),n.at=l+c}let r=["channels","compression","dataWindow","displayWindow"].find(i=>e[i]===null);if(r!==void 0)throw new H(`broken EXR image: it has no ${r}`);return e}function Hl(n){let e=[];for(;;){let t=n.at,r=oi(n);if(r==="")return e;let i=n.at,{view:s}=n;e.push({name:r,at:t,typeAt:i,type:s.getInt32(i,!0),x:s.getInt32(i+8,!0),y:s.getInt32(i+12,!0)}),n.at+=16}}function oi(n){let e=n.bytes.indexOf(0,n.at);if(e<0||e-n.at>255)throw new H("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(n.bytes.subarray(n.at,e));return n.at=e+1,t}var Bl=65536,qs=[8,32767],Gl=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,$l=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,ci=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,we=n=>new H(`broken HDR image${n}`);function js(n){let e=ql(n),{count:t,length:r,columns:i,back:s,exposure:o}=e,c=jl(n,e),l=1/o,[f,h]=i?[t,r]:[r,t],m=new Float32Array(3*f*h);for(let g=0;g<t;g++){let _=s[0]?t-1-g:g;for(let x=0;x<r;x++){let R=s[1]?r-1-x:x,F=4*(g*r+x),W=3*(i?R*f+_:_*f+R),$=c[F+3],V=$>0?l*2**($-136):0;for(let ne=0;ne<3;ne++)m[W+ne]=c[F+ne]*V}}return{rgb:m,width:f,height:h}}function ql(n){let e=[],t=0,r=-1;for(;r<0||e.length<r+2;){let m=n.subarray(0,Bl).indexOf(10,t);if(m<0)throw we(": it has no header");e.push(Array.from(n.subarray(t,m),g=>String.fromCharCode(g)).join("")),t=m+1,r<0&&e.at(-1).replace(/\r+$/,"")===""&&(r=e.length-1)}let i=1;for(let m of e.slice(1,r)){let g=m.indexOf("="),[_,x]=g<0?[m,""]:[m.slice(0,g),m.slice(g+1)],R=_.replace(ci,""),F=x.replace(ci,"");if(R==="FORMAT"&&F!=="32-bit_rle_rgbe")throw we(`: format '${F}', expected 32-bit_rle_rgbe`);R==="EXPOSURE"&&(i*=$l.test(F)?Number(F)||1:0)}if(!(i>0&&i<1/0))throw we(": EXPOSURE is not a positive number");let s=e[r+1].replace(ci,""),o=Gl.exec(s);if(o===null||o[2]===o[5])throw we(`: size '${s.slice(0,40)}', expected such as '-Y height +X width'`);let c=Number(o[3]),l=Number(o[6]),f=o[2]==="X",h=[o[1]+o[2],o[4]+o[5]].map(m=>m==="+Y"||m==="-X");return tr(...f?[c,l]:[l,c],n.length),{offset:t,count:c,length:l,columns:f,back:h,exposure:i}}function jl(n,{offset:e,count:t,length:r}){let i=new Uint8Array(4*t*r),s=e;try{for(let o=0;o<t;o++)s=Wl(n,s,i.subarray(4*o*r),r,o)}catch(o){if(n.length-e===i.length)return n.subarray(e);throw o}return i}function Wl(n,e,t,r,i){if(r>=qs[0]&&r<=qs[1]&&e+4<=n.length&&n[e]===2&&n[e+1]===2&&n[e+2]<128){if(n[e+2]*256+n[e+3]!==r)throw we(`, line ${i}: a run goes past the line's end`);return Zl(n,e+4,t,r,i)}return Yl(n,e,t,r,i)}function Zl(n,e,t,r,i){for(let s=0;s<4;s++)for(let o=0;o<r;){if(e+2>n.length)throw we(`, line ${i}: the file ends there`);let c=n[e]>128,l=c?n[e]-128:n[e];if(l===0)throw we(`, line ${i}: a run of no pixels`);if(o+l>r)throw we(`, line ${i}: a run goes past the line's end`);if(e+1+(c?1:l)>n.length)throw we(`, line ${i}: the file ends there`);for(let f=0;f<l;f++)t[4*(o+f)+s]=n[e+1+(c?0:f)];o+=l,e+=c?2:1+l}return e}function Yl(n,e,t,r,i){let s=0,o=0;for(;s<r;){if(e+4>n.length)throw we(`, line ${i}: the file ends there`);if(n[e]===1&&n[e+1]===1&&n[e+2]===1){if(s===0)throw we(`, line ${i}: a run repeats a pixel, but there is none before it`);let c=o>16?1/0:n[e+3]*2**o;if(s+c>r)throw we(`, line ${i}: a run goes past the line's end`);for(let l=0;l<c;l++)t.copyWithin(4*(s+l),4*(s-1),4*s);s+=c,o+=8}else t.set(n.subarray(e,e+4),4*s),s+=1,o=0;e+=4}return e}var Vl=[118,47,49,1],Xl=[35,63];function li(n,e){let t=new Uint8Array(n),r=s=>s.every((o,c)=>t[c]===o),i=r(Vl)?$s:r(Xl)?js:null;if(i===null)throw new H(`${e}: is neither an EXR nor a Radiance HDR image`);try{return Kl(i(t))}catch(s){let o=s instanceof H?s.message:`cannot read the image: ${s.message??s}`;throw new H(`${e}: ${o}`)}}function Kl(n){let{rgb:e}=n,t=0;for(let r=0;r<e.length;r+=3){let i=!0;for(let s=r;s<r+3;s++)i&&=Number.isFinite(e[s])&&e[s]<=Bs,e[s]>0||(e[s]=0);i||t++}if(t)throw new H(`has ${t} texels that are not finite numbers of at most 1e+18`);return n}function Ws(n){return n.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var Zs={blocks:[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}]};var ir=Zs.blocks,dt=n=>ir.find(e=>e.name===n),sr=(n,e)=>dt(n).width??e;var et=22,gt=46,mn=30,Ys=64,Vs=256,Ql=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,zt="manifest.json",Xs=2**20,gn=n=>new DataView(n.buffer,n.byteOffset,n.byteLength);async function Js(n){let{size:e}=n;e===0&&y("FILE_EMPTY",n.name,"the file has no bytes"),e>2**32-2&&y("FILE_TOO_LARGE",n.name,`${e} bytes`);let{count:t,start:r}=await eu(n),i=await n.read(r,e-et),s=nu(i,t,r,n.name);return iu(s,r,n.name),new Map(s.map(o=>[o.name,o]))}async function eu(n){let{size:e,name:t}=n,r=gn(await n.read(0,Math.min(4,e))),s=e>=4&&r.getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<et&&y(s,t,"shorter than the end record of a ZIP archive");let o=gn(await n.read(e-et,e)),c=e===et&&o.getUint32(0,!0)===101010256;o.getUint32(0,!0)!==101010256&&await tu(n,s);let l=g=>o.getUint16(g,!0);[4,6,8,10].some(g=>l(g)===65535)&&y("ZIP_ZIP64",t,"a ZIP64 archive"),(l(4)||l(6))&&y("ZIP_ZIP64",t,"an archive of several disks");let f=l(10),h=o.getUint32(12,!0),m=o.getUint32(16,!0);return f>Vs&&y("ZIP_TOO_MANY",t,`${f} entries; at most ${Vs}`),(l(8)!==f||l(20)!==0||m+h!==e-et)&&y("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(c||f===0)&&y("ZIP_ORDER",t,`${zt} is not the first entry`),{count:f,start:m}}async function tu(n,e){let t=await n.read(Math.max(0,n.size-et-65535),n.size),r=gn(t);for(let i=t.length-et;i>=0;i--)r.getUint32(i,!0)===101010256&&i+et+r.getUint16(i+20,!0)===t.length&&y("ZIP_DIRECTORY",n.name,"the archive has a comment");y(e,n.name,"the file does not end with the end record of a ZIP archive")}function nu(n,e,t,r){let i=gn(n),s=[],o=new Set,c=0;for(let l=0;l<e;l++){(c+gt>n.length||i.getUint32(c,!0)!==33639248)&&y("ZIP_DIRECTORY",r,`the central directory has no header ${l}`);let f=i.getUint16(c+28,!0);(c+gt+f>n.length||i.getUint32(c+30,!0))&&y("ZIP_DIRECTORY",r,`header ${l} of the central directory is malformed`);let h=n.subarray(c+gt,c+gt+f),m=String.fromCharCode(...h);ru(i,c,m,r),(!Ql.test(m)||m.includes(`
`)||f>200)&&y("ZIP_NAME",r,`an entry is called ${JSON.stringify(m.slice(0,80))}`);let g=m.toLowerCase();o.has(g)&&y("ZIP_DUPLICATE",m,"the name is there twice"),o.add(g),s.push({name:m,size:i.getUint32(c+24,!0),crc:i.getUint32(c+16,!0),header:i.getUint32(c+42,!0),central:n.subarray(c,c+gt+f)}),c+=gt+f}c!==n.length&&y("ZIP_DIRECTORY",r,"bytes behind the last central header");for(let{name:l,header:f,size:h}of s)f+mn+l.length+h>t&&y("ZIP_TRUNCATED",l,`${h} bytes reach past the entries`);return s}function ru(n,e,t,r){let i=l=>n.getUint16(e+l,!0),s=l=>n.getUint32(e+l,!0),o=JSON.stringify(t.slice(0,80));(s(42)===4294967295||s(20)===4294967295||s(24)===4294967295)&&y("ZIP_ZIP64",r,`${o} needs ZIP64`),i(34)&&y("ZIP_ZIP64",r,`${o} is on another disk`),i(8)&1&&y("ZIP_ENCRYPTED",r,`${o} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,f])=>i(l)!==f)||s(38))&&y("ZIP_HEADER",r,`${o}: a version, flag, time or attribute is not the fixed one`),i(10)&&y("ZIP_COMPRESSED",r,`${o} is compressed`),s(20)!==s(24)&&y("ZIP_SIZE",r,`${o} has two sizes`)}function iu(n,e,t){let r=[...n].sort((o,c)=>o.header-c.header),i=0;r.forEach((o,c)=>{o.end=c+1<r.length?r[c+1].header:e,o.extra=o.end-o.header-mn-o.name.length-o.size,o.extra<0&&y("ZIP_OVERLAP",o.name,"shares bytes with the next entry"),o.header!==i&&y("ZIP_GAP",t,`bytes ${i} to ${o.header} are no entry's`),i=o.end});let s=r[0];s.name!==zt&&y("ZIP_ORDER",t,`${zt} is not the first entry`),s.size>Xs&&y("MANIFEST_TOO_LARGE",zt,`${s.size} bytes; at most ${Xs}`)}function Qs(n,e){let t=gn(e),{name:r}=n,i=n.name.length;e.length<n.end-n.header&&y("ZIP_TRUNCATED",r,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===i&&Ks(e.subarray(4,26),n.central.subarray(6,28))&&Ks(e.subarray(mn,mn+i),n.central.subarray(gt))||y("ZIP_LOCAL_HEADER",r,"local and central header differ");let o=t.getUint16(28,!0),c=mn+i;su(e.subarray(c,c+o),o,r),(n.header+c+o)%Ys&&y("ZIP_ALIGNMENT",r,`data at byte ${n.header+c+o}, no multiple of ${Ys}`),o!==n.extra&&y(o>n.extra?"ZIP_OVERLAP":"ZIP_GAP",r,"its data does not end where the next entry starts");let l=e.subarray(c+o,c+o+n.size);return ou(l)!==n.crc&&y("ZIP_CRC",r,"the bytes do not have the CRC-32 of the header"),l}function su(n,e,t){if(e===0)return;e>=4&&n.length===e&&n[0]===82&&n[1]===78&&n[2]+256*n[3]===e-4&&n.subarray(4).every(i=>i===0)||y("ZIP_EXTRA",t,"the extra field is not zero padding")}var Ks=(n,e)=>n.length===e.length&&n.every((t,r)=>t===e[r]),dn=Array.from({length:4},()=>new Uint32Array(256));for(let n=0;n<256;n++){let e=n;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;dn[0][n]=e>>>0}for(let n=1;n<4;n++)for(let e=0;e<256;e++){let t=dn[n-1][e];dn[n][e]=t>>>8^dn[0][t&255]}function ou(n){let[e,t,r,i]=dn,s=4294967295,o=0;for(;o+4<=n.length;o+=4)s^=n[o]|n[o+1]<<8|n[o+2]<<16|n[o+3]<<24,s=i[s&255]^r[s>>>8&255]^t[s>>>16&255]^e[s>>>24];for(;o<n.length;o++)s=e[(s^n[o])&255]^s>>>8;return(s^4294967295)>>>0}var au=64,cu=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,lu=/[ \t\n\r]*/y,uu=/[^"\\\u0000-\u001f]*/y,eo={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function Ct(n,e,t){let r;try{r=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(n)}catch{y(t,e,"no UTF-8")}let i=new ui(r,e,t);i.space(),r[i.at]!=="{"&&y(t,e,"not a JSON object");let s=i.value(1);return i.space(),i.at!==r.length&&i.bad(),s}var ui=class{constructor(e,t,r){Object.assign(this,{text:e,where:t,code:r,at:0})}bad(e="malformed JSON"){y(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(lu)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>au&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[s,o]of[["true",!0],["false",!1],["null",null]])if(this.take(s))return o;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let r=this.match(cu);r||this.bad();let i=Number(r[0]);return Number.isFinite(i)||this.notFinite(),i===0?0:i}notFinite(){y("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let i=this.string();t.has(i)&&y("JSON_DUPLICATE_KEY",this.where,`the key "${i}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t.set(i,this.value(e+1))});let r=Object.create(null);for(let[i,s]of t)r[i]=s;return r}string(){let e="";for(this.at+=1;e+=this.match(uu)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let r=this.match(/[0-9a-fA-F]{4}/y);r||this.bad(),e+=String.fromCharCode(parseInt(r[0],16))}else t in eo?e+=eo[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var to={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},fu=65536;function Ut(n,e,t,r){let i=e.byteOffset+t;return i%n.BYTES_PER_ELEMENT===0?new n(e.buffer,i,r):new n(e.slice(t,t+r*n.BYTES_PER_ELEMENT).buffer)}function tt(n,e,t){n.length<8&&y(t,e,"shorter than a header");let r=new DataView(n.buffer,n.byteOffset).getBigUint64(0,!0);(r>fu||Number(r)>n.length-8)&&y(t,e,`a header of ${r} bytes`);let i=8+Number(r);n[8]!==123&&y(t,e,"the header does not start with {");let{__metadata__:s,...o}=Ct(n.subarray(8,i),e,t);return{tensors:o,metadata:s,data:i}}var ro=n=>n!==null&&typeof n=="object"&&!Array.isArray(n),no=n=>Number.isSafeInteger(n)&&n>=0;function nt(n){return ro(n)&&typeof n.dtype=="string"&&Array.isArray(n.shape)&&n.shape.every(no)&&Array.isArray(n.data_offsets)&&n.data_offsets.length===2&&n.data_offsets.every(no)}var rt=n=>n===void 0||ro(n);function it(n,{tensors:e,data:t},r,i,s){let o=0,c=r.map(l=>{let{dtype:f,shape:h,data_offsets:[m,g]}=e[l],_=h.reduce((x,R)=>x*R,1);return(m!==o||g-m!==_*to[f].BYTES_PER_ELEMENT||t+g>n.length)&&y(s,i,`the bytes of ${l} are not where they must be`),o=g,Ut(to[f],n,t+m,_)});return t+o!==n.length&&y(s,i,"bytes behind the last tensor"),c}var io=2**26,hu=2**25,pu=2**31,mu={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},du={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function so(n,e){let t=tt(n,e,"GEOMETRY_CONTAINER"),{tensors:r}=t,i="steps"in r||"scales"in r,s=i?du:mu,o=Object.keys(s);gu(t,s,o,e);let c=Object.fromEntries(o.map(x=>[x,r[x].shape])),l=it(n,t,o,e,"GEOMETRY_RANGE"),f=Object.fromEntries(o.map((x,R)=>[x,l[R]])),h=c.offsets[0]-1,m=c.radii[0];(!(i?c.origins[0]===h&&c.steps[0]===m-h&&c.scales[0]===2:c.points[0]===m)||h<1)&&y("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),vu(f.offsets,m,e);let _=i?_u(f,e):f;return wu(_,e),_}function gu(n,e,t,r){let{tensors:i}=n,s="GEOMETRY_PROFILE",o=Object.keys(i);(o.length!==t.length||t.some(l=>!o.includes(l)))&&y(s,r,`found ${o.join(", ")||"no tensors"}, expected ${t.join(", ")}`),rt(n.metadata)||y(s,r,"__metadata__ is no object");for(let[l,[f,h]]of Object.entries(e)){let m=i[l];nt(m)&&f.includes(m.dtype)&&m.shape.length===h&&(h===1||m.shape[1]===3)||y(s,r,`${l} is not ${f.join(" or ")} of ${h} dimensions`)}((i.points??i.radii).shape[0]>io||i.radii.shape[0]>io||i.offsets.shape[0]-1>hu)&&y(s,r,"more points or strands than allowed"),n.data%64&&y(s,r,"data does not start at a multiple of 64")}function vu(n,e,t){let r=n[0]===0&&n.at(-1)===e;for(let i=1;i<n.length&&r;i++)r=n[i]>=n[i-1]+2;r||y("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function _u({scales:n,origins:e,offsets:t,steps:r,radii:i},s){let[o,c]=n;o>0&&Number.isFinite(o)||y("GEOMETRY_STEPS",s,"steps without length"),e.some(h=>!Number.isFinite(h))&&y("GEOMETRY_NOT_FINITE",s,"an origin is not finite"),(!(c>0&&Number.isFinite(c))||i.some(h=>h===0))&&y("GEOMETRY_RADIUS",s,"a radius that is not above 0");let l=new Float32Array(3*i.length),f=0;for(let h=0;h+1<t.length;h++){for(let m=0;m<3;m++){let g=e[3*h+m],_=0;l[3*t[h]+m]=g;for(let x=t[h]+1,R=f;x<t[h+1];x++,R++)_+=r[3*R+m],Math.abs(_)>pu&&y("GEOMETRY_STEPS",s,`strand ${h} goes too far`),l[3*x+m]=g+o*_}f+=t[h+1]-t[h]-1}return{points:l,radii:Float32Array.from(i,h=>h*c),offsets:t}}function wu({points:n,radii:e,offsets:t},r){(n.some(i=>!Number.isFinite(i))||e.some(i=>!Number.isFinite(i)))&&y("GEOMETRY_NOT_FINITE",r,"a point or a radius is not finite");for(let i=0;i+1<t.length;i++)for(let s=t[i]+1;s<t[i+1];s++)n[3*s]===n[3*s-3]&&n[3*s+1]===n[3*s-2]&&n[3*s+2]===n[3*s-1]&&y("GEOMETRY_SEGMENT",r,`two equal points in strand ${i}`);e.some(i=>!(i>0))&&y("GEOMETRY_RADIUS",r,"a radius that is not above 0")}var fi=[0,1,-1,1e4,-1e4,34028234663852886e22,-34e37],yu=5,xu=34028234663852886e22;function oo(n,e){let t=1,r=()=>(t=Math.imul(t,1664525)+1013904223|0)/2**31;for(let i=0;i<fi.length+yu;i++){let s=Float32Array.from({length:n.columns},()=>fi[i]??r()),o=bu(n,s).find(c=>!(c>=0&&c<=xu));o!==void 0&&y("DECODER_RESULT",e,`a query of ${fi[i]??"random"} numbers gives ${o}, expected finite results, not negative`)}}function bu({low:n,high:e,gain:t,offset:r,layers:i,top:s,unit:o,matrix:c,outputs:l},f){let h=f.map(_=>Math.min(Math.max(_,n),e)),m=t?h.map((_,x)=>_*t[x]+r[x]):h;for(let _ of i)m=Au(_,m);let g=m.map(_=>(Math.exp(Math.min(Math.max(_,0),s))-1)*o);return c?ao(g,c,l):g}function Au({weight:n,bias:e,columns:t,step:r,scales:i,relu:s},o){let c=i?o.map(l=>l/r>0?Ru(Math.min(l/r,255)):0):o;return ao(c,n,t).map((l,f)=>{let h=i?(l+e[f])*r*i[f]:l+e[f];return s?Math.max(h,0):h})}var Ru=n=>n+1.5*2**52-1.5*2**52;function ao(n,e,t){let r=new Float64Array(t);return n.forEach((i,s)=>{if(i!==0)for(let o=0,c=s*t;o<t;o++,c++)r[o]+=i*e[c]}),Float32Array.from(r)}var Ee=1,pi=2,mi=3,di=6,Eu={[Ee]:Float32Array,[pi]:Uint8Array,[mi]:Int8Array,[di]:Int32Array},co=[3,4,5,6,7,10,11,13],lo=2**18;function fo(n,{columns:e,outputs:t,output:r},i){let s=new hi(i),o=s.message(n,{1:"number",7:"bytes",8:"many",20:"many",25:"many"}),c=o[8].map(f=>s.message(f,{1:"text",2:"number"})),l=s.message(o[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});return o[1]>=7&&o[1]<=10||i(`IR version ${o[1]}, expected 7 to 10`),(c.length!==1||!ho(c[0][1])||!(c[0][2]>=13&&c[0][2]<=21))&&i("operators that are not those of ONNX, version 13 to 21"),(o[20].length||o[25].length||l[15].length)&&i("functions, training or sparse tensors"),uo(s,l[11],"queries",e),uo(s,l[12],r,t),{nodes:l[1].map(f=>ku(s,f)),constants:l[5].map(f=>Tu(s,f))}}var ho=n=>n===""||n==="ai.onnx";function uo(n,e,t,r){let[i]=e.map(l=>n.message(l,{1:"text",2:"bytes"})),s=i&&n.message(n.message(i[2],{1:"bytes"})[1],{1:"number",2:"bytes"}),o=s&&n.message(s[2],{1:"many"})[1].map(l=>n.message(l,{1:"number?",2:"text"})[1]);e.length===1&&i[1]===t&&s[1]===Ee&&o.length===2&&o[0]===void 0&&o[1]===r||n.outside(`not one ${t}, float32 [N, ${r}]`)}function ku(n,e){let t=n.message(e,{1:"many",2:"many",4:"text",5:"many",7:"text"});(!ho(t[7])||t[2].length!==1)&&n.outside(`${t[4]} of another domain, or of several results`);let r=t[5].map(i=>n.message(i,{1:"text",3:"number?"}));return(r.some(({1:i,3:s})=>i!=="axis"||s===void 0)||r.length>1)&&n.outside(`${t[4]} with another attribute than axis`),{operator:t[4],inputs:t[1].map(n.text),output:n.text(t[2][0]),axis:r[0]?.[3]??null}}function Tu(n,e){let t=Object.fromEntries(co.map(h=>[h,"many"])),r=n.message(e,{1:"numbers",2:"number",8:"text",9:"bytes",14:"number",...t});(r[14]||co.some(h=>r[h].length))&&n.outside("a constant not in raw_data");let{1:i,2:s,9:o}=r,c=Eu[s],l=i.reduce((h,m)=>h*m,1),f=c&&i.length<=2&&o.length===l*c.BYTES_PER_ELEMENT;return{name:r[8],type:s,dims:i,values:f?Ut(c,o,0,l):null}}var hi=class{constructor(e){this.outside=e,this.fields=0,this.text=t=>{try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){let r=Object.fromEntries(Object.keys(t).map(i=>[i,[]]));for(let i=0;i<e.length;){++this.fields>lo&&this.outside("too many fields");let s,o;[s,i]=this.varint(e,i),[o,i]=this.value(e,i,s%8),r[Math.floor(s/8)]?.push(o)}return Object.fromEntries(Object.entries(t).map(([i,s])=>[i,this.taken(r[i],s)]))}taken(e,t){if(t==="numbers")return e.flatMap(i=>typeof i=="number"?i:this.packed(i));let r=t.startsWith("number");return e.some(i=>typeof i=="number"!==r)&&this.outside("a field of another type"),t==="many"?e:(e.length>1&&this.outside("a field twice"),r?e[0]??(t==="number"?0:void 0):t==="text"?this.text(e[0]??new Uint8Array):e[0]??new Uint8Array)}packed(e){let t=[];for(let r=0,i;r<e.length;)++this.fields>lo&&this.outside("too many numbers"),[i,r]=this.varint(e,r),t.push(i);return t}value(e,t,r){if(r===0)return this.varint(e,t);let i={1:8,5:4}[r];return r===2&&([i,t]=this.varint(e,t)),(i===void 0||t+i>e.length)&&this.outside("a field that is cut short"),[e.subarray(t,t+i),t+i]}varint(e,t){for(let r=0,i=1,s=0;s<10&&t<e.length;s++,i*=128){let o=e[t++];if(r+=(o&127)*i,o<128)return[r,t]}return this.outside("a number that is cut short")}};var po=64*2**20,mo=4096,go=8192,vo=2**16,_o=2**24,st=[Ee,[]],wo=[pi,[]];function yo(n,{columns:e,outputs:t,output:r,precision:i},s){n.length>po&&y("DECODER_TOO_LARGE",s,`${n.length} bytes; at most ${po}`);let o=f=>y("DECODER_PROFILE",s,`not a decoder as the format has it: ${f}`),c=fo(n,{columns:e,outputs:t,output:r},o),l=new gi(c,{columns:e,outputs:t,output:r,int8:i==="int8"},s,o).decoder();return oo(l,s),l}var gi=class{constructor({nodes:e,constants:t},r,i,s){Object.assign(this,r,{where:i,outside:s,width:r.columns,value:"queries",values:r.outputs,work:0}),e.length>mo&&s(`${e.length} nodes; at most ${mo}`);let o=["queries",...t.map(({name:c})=>c),...e.map(({output:c})=>c)];(new Set(o).size!==o.length||o.includes(""))&&s("a value made twice, or without a name"),this.constants=new Map(t.map(c=>[c.name,c])),this.unread=new Set(this.constants.keys()),this.dequantizers=new Map,this.nodes=e.values(),this.advance()}advance(){for(;;){if(this.node=this.nodes.next().value,this.node?.operator!=="DequantizeLinear"||!this.constants.has(this.node.inputs[0]))return;this.dequantizers.set(this.node.output,this.node)}}get operator(){return this.node?.operator??"nothing"}next(e,t){let{node:r}=this;return this.operator!==e&&this.outside(`${this.operator} where ${e} must be`),(r.inputs[0]!==this.value||r.inputs.length!==t+1||r.axis!==null)&&this.outside(`${e} of ${r.inputs.join(", ")}, not of ${this.value} and ${t} constants`),this.value=r.output,this.advance(),r.inputs.slice(1)}read(e,t){return e.length!==t.length&&this.outside(`${e.length} constants where ${t.length} must be`),t.map(([r,i],s)=>{let{values:o,...c}=this.constants.get(e[s])??{};return(!o||c.type!==r||c.dims.join()!==i.join())&&this.outside(`${e[s]} is no constant of type ${r} and shape [${i}]`),r===Ee&&!o.every(Number.isFinite)&&y("DECODER_RESULT",this.where,`${e[s]} has values that are NaN or infinite`),this.unread.delete(e[s]),o})}take(e,...t){return this.read(this.next(e,t.length),t)}multiply(e,{isLayer:t}){let r=this.constants.get(e)?.dims[1]??0,i=this.width;return r>=1&&r<=go||this.outside(`${e} has ${r} columns; from 1 to ${go}`),t&&(this.values+=r),this.work+=i*r,(this.values>vo||this.work>_o)&&y("DECODER_COST",this.where,`${this.values} values and ${this.work} multiply-adds of a query, or more; at most ${vo} and ${_o}`),this.width=r,{rows:i,columns:r}}decoder(){let e=[Ee,[this.columns]],{int8:t,columns:r,outputs:i}=this,[[s],[o]]=this.take("Clip",st,st),[c]=t?this.take("Mul",e):[null],[l]=t?this.take("Add",e):[null],f=[];do f.push(t?this.int8Layer():this.layer());while(t?this.operator!=="Clip":f.at(-1).relu);let[[h],[m]]=this.take("Clip",st,st);this.take("Exp");let[[g]]=this.take("Sub",st);(h!==0||g!==1)&&this.outside(`Clip from ${h}, Sub of ${g}`);let _=this.operator==="MatMul"?this.mixing():{unit:this.take("Mul",st)[0][0],matrix:null};return(this.node||this.dequantizers.size||this.unread.size)&&this.outside("a node or a constant that the chain does not have"),(this.value!==this.output||this.width!==i)&&this.outside(`${this.width} columns of ${this.value} in the end`),{low:s,high:o,gain:c,offset:l,layers:f,top:m,..._,int8:t,columns:r,outputs:i}}mixing(){let e=this.next("MatMul",1),{rows:t,columns:r}=this.multiply(e[0],{isLayer:!1});return{unit:1,matrix:this.read(e,[[Ee,[t,r]]])[0]}}layer(){let e=this.next("Gemm",2),{rows:t,columns:r}=this.multiply(e[0],{isLayer:!0}),[i,s]=this.read(e,[[Ee,[t,r]],[Ee,[r]]]),o=this.operator==="Relu";return o&&this.take("Relu"),{weight:i,bias:s,rows:t,columns:r,relu:o}}int8Layer(){let[[e],[t]]=this.take("QuantizeLinear",st,wo),[[r],[i]]=this.take("DequantizeLinear",st,wo);(t||i||e!==r)&&this.outside("two scales, or a zero point");let s=new Map(this.dequantizers),[o,c]=this.next("Gemm",2).map((x,R)=>this.dequantized(s,x,1-R)),{rows:l,columns:f}=this.multiply(o[0],{isLayer:!0}),[h,m]=this.read(o,[[mi,[l,f]],[Ee,[f]]]),[g,_]=this.read(c,[[di,[f]],[Ee,[f]]]);return _.some((x,R)=>x!==Math.fround(e*m[R]))&&this.outside("a bias with a scale of its own"),{weight:h,bias:g,rows:l,columns:f,step:e,scales:m,relu:!1}}dequantized(e,t,r){let i=e.get(t);return(i?.axis!==r||!this.dequantizers.delete(t))&&this.outside(`${t} is no DequantizeLinear of constants along axis ${r}`),i.inputs}};async function xo(n,{elementSize:e,distance:t,size:r},i){let s=await Su(n,r,i),o=Math.floor(r/e),c=new Uint8Array(r);for(let l=0;l<e;l++){let f=l*o;for(let h=0;h<o;h++)c[h*e+l]=s[f+h]}if(c.set(s.subarray(o*e),o*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],f=new l(c.buffer,0,o);for(let h=t;h<o;h++)f[h]+=f[h-t]}return c}async function Su(n,e,t){let r=new Uint8Array(e),i=0;try{let s=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:o,value:c}=await s.read();if(o)break;if(i+c.length>e)throw s.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);r.set(c,i),i+=c.length}}catch(s){y("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${s.message})`)}return i!==e&&y("DEFLATE_STREAM",t,`inflates to ${i} bytes, expected ${e}`),r}var Dt={$schema:"https://json-schema.org/draft/2020-12/schema",title:"Manifest",$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}},additionalProperties:!1,description:"manifest.json. `write_package` computes `entries`; leave them out.",properties:{format:{const:"rna",type:"string"},version:{const:"2.0",description:"Version of the format.",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"}},required:["format","version","units","entries","generator","name","parts","domain","tiers","provenance","license"],type:"object"};var Ht=16,Iu=32,{emission:vm,...bo}=Dt.$defs.TierPart.properties,Ao={$defs:Dt.$defs,type:"object",required:["parts"],additionalProperties:!1,properties:{parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"object",additionalProperties:!1,required:[...Dt.$defs.TierPart.required,"lobes"],properties:{...bo,lobes:{type:"integer",minimum:2,maximum:Iu},visibility:bo.planes}}]}},validation:{type:"array",maxItems:64}}};function Ro(n){let e=n.extensions?.RNA_environment?.parts;return e?.every(t=>t)?e:null}function Eo({parts:n},e,t){n.some(r=>r)||y("FIELD_VALUE",t,"lobes of no part"),n.forEach((r,i)=>{if(!r)return;let s=`${t}/parts/${i}`;r.lobes%2&&y("FIELD_VALUE",`${s}/lobes`,`found ${r.lobes}, expected an even number`);for(let o of r.inputs)dt(o).kinds.includes(e.parts[i].kind)||y("INPUT_KIND",`${s}/inputs`,`${o} is not for this part`);for(let o of or([r]))Object.hasOwn(e.entries,o)||y("REFERENCE_MISSING",s,`no entry ${o}`)})}var or=n=>n.flatMap(({planes:e,decoder:t,visibility:r})=>[e,t,...r?[r]:[]]);function ko(n,e,t){let r="ENVIRONMENT_VISIBILITY",i=tt(n,t,r),s=i.tensors.harmonics;rt(i.metadata)||y(r,t,"__metadata__ is no object"),(Object.keys(i.tensors).join()!=="harmonics"||!nt(s))&&y(r,t,"not one tensor harmonics");let o=[e,Ht];return(s.dtype!=="I8"||s.shape.join()!==o.join())&&y(r,t,`found ${s.dtype} [${s.shape}], expected I8 [${o}]`),i.data%64&&y(r,t,"data does not start at a multiple of 64"),it(n,i,["harmonics"],t,r)[0]}var vi={object:n=>n!==null&&typeof n=="object"&&!Array.isArray(n),array:Array.isArray,string:n=>typeof n=="string",number:n=>typeof n=="number",integer:n=>Number.isSafeInteger(n),boolean:n=>typeof n=="boolean",null:n=>n===null};function Bt(n,e,t=""){new wi(n).check(n,e,t)}var wi=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,r){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,r);let i=s=>y("FIELD_VALUE",r,`found ${_i(t)}, expected ${s}`);e.type&&!vi[e.type](t)&&i(e.type),"const"in e&&t!==e.const&&i(_i(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&y("INPUT_UNKNOWN",r,`no block ${_i(t)}`),i(e.enum.join(", ")));for(let s of[e.anyOf,e.oneOf])s&&!s.some(o=>this.fits(o,t))&&this.check(s.find(o=>vi[o.type]?.(t))??s[0],t,r);e.not&&this.fits(e.not,t)&&i("another value"),typeof t=="number"&&this.checkNumber(e,t,i),typeof t=="string"&&this.checkString(e,t,i),Array.isArray(t)?this.checkArray(e,t,r,i):vi.object(t)&&this.checkObject(e,t,r)}checkNumber(e,t,r){t<e.minimum&&r(`at least ${e.minimum}`),t>e.maximum&&r(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&r(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&r(`less than ${e.exclusiveMaximum}`)}checkString(e,t,r){t.length<e.minLength&&r(`${e.minLength} characters or more`),t.length>e.maxLength&&r(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&r(e.pattern)}checkArray(e,t,r,i){t.length<e.minItems&&i(`${e.minItems} items or more`),t.length>e.maxItems&&i(`at most ${e.maxItems} items`),t.forEach((s,o)=>{let c=e.prefixItems?.[o]??e.items;c&&this.check(c,s,`${r}/${o}`)}),e.uniqueItems&&new Set(t).size!==t.length&&y("INPUT_UNKNOWN",r,"a name twice")}checkObject(e,t,r){let i=Object.keys(t),s=e.properties??{};for(let o of i)e.additionalProperties===!1&&!Object.hasOwn(s,o)&&y("FIELD_UNKNOWN",`${r}/${o}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},o,`${r}/${o}`);for(let o of e.required??[])Object.hasOwn(t,o)||y("FIELD_MISSING",`${r}/${o}`,"missing");for(let o of i){let c=Object.hasOwn(s,o)?s[o]:e.additionalProperties;c&&this.check(c,t[o],`${r}/${o}`)}}};function _i(n){let e=JSON.stringify(n);return e.length>60?`${e.slice(0,57)}...`:e}var yi={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},vn=(n,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:n,maximum:e}),xi={type:"number",minimum:0,maximum:1},vt=n=>({type:"object",properties:n,required:Object.keys(n),additionalProperties:!1}),To=2**32-2,Ou=2**20,Mu=64,So={RNA_deflate:vt({entries:{type:"object",propertyNames:yi,additionalProperties:vt({elementSize:{enum:[1,2,4]},distance:vn(0),size:vn(0,To),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:vt({image:yi,width:vn(1),height:vn(1)}),RNA_standin:vt({parts:{type:"array",minItems:1,maxItems:16,items:vt({baseColor:{type:"array",items:xi,minItems:3,maxItems:3},roughness:xi,metallic:xi})}}),RNA_proxy:vt({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:vt({geometry:yi,height:vn(1)})}]}}}),RNA_environment:Ao},ar=Object.keys(So);function No(n){let e=n.extensions??{};for(let t of ar){let r=`/extensions/${t}`;if(!Object.hasOwn(e,t)){n.extensionsUsed?.includes(t)&&y("FIELD_MISSING",r,"its data is missing");continue}Bt(So[t],e[t],r),Lu[t](e[t],n,r)}}function bi(n,e,t){Object.hasOwn(n.entries,e)||y("REFERENCE_MISSING",t,`no entry ${e}`)}function Ai(n,e,t){n.length!==e.parts.length&&y("PARTS_DIFFER",t,`found ${n.length} parts, expected ${e.parts.length}`)}var Lu={RNA_deflate({entries:n},e,t){e.extensionsRequired?.includes("RNA_deflate")||y("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let r=Object.values(n).reduce((i,{size:s})=>i+s,0);r>To&&y("FIELD_VALUE",t,`${r} decoded bytes`);for(let[i,{size:s}]of Object.entries(n)){bi(e,i,t);let o=Ou+Mu*e.entries[i].size;s>o&&y("DEFLATE_SIZE",`${t}/entries/${i}/size`,`${s} decoded bytes; at most ${o}`)}},RNA_poster({image:n},e,t){bi(e,n,t)},RNA_standin({parts:n},e,t){Ai(n,e,t)},RNA_proxy({parts:n},e,t){Ai(n,e,t),n.some(r=>r)||y("FIELD_VALUE",t,"a proxy of no part"),n.forEach((r,i)=>{let{transmittance:s,normalMaps:o}=e.parts[i];r&&(s||o)&&y("FIELD_VALUE",t,"a proxy of a part with textures"),(r??[]).forEach(({geometry:c,height:l},f)=>{bi(e,c,t),f&&l>=r[f-1].height&&y("FIELD_VALUE",t,"heights must descend")})})},RNA_environment(n,e,t){Ai(n.parts,e,t),Eo(n,e,t)}};var Ri="2.0",Fu=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function Io(n){let e=Ct(n,"manifest.json","MANIFEST_NOT_JSON");Pu(e),Bt(Dt,e),zu(e),Cu(e),Uu(e),Du(e),No(e),Hu(e),Bu(e),$u(e);let t=(e.extensionsUsed??[]).filter(r=>!ar.includes(r));return{...e,warnings:t.map(r=>`unknown extension ${r}`)}}function Pu(n){"format"in n||y("FIELD_MISSING","/format","missing"),n.format!=="rna"&&y("FORMAT_UNKNOWN","/format","this is no RNA package");let{version:e}=n;if(typeof e=="string"&&Fu.test(e)&&e!==Ri){let t=parseInt(e,10)<parseInt(Ri,10)?"VERSION_TOO_OLD":"VERSION_TOO_NEW";y(t,"/version",`the package is of version ${e}; this viewer reads ${Ri}`)}for(let t of Array.isArray(n.parts)?n.parts:[])t?.kind!==void 0&&!["surface","fiber"].includes(t.kind)&&y("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(t.kind)}, expected surface or fiber`);for(let t of Array.isArray(n.extensionsRequired)?n.extensionsRequired:[])typeof t=="string"&&!ar.includes(t)&&y("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${t}`)}function zu(n){n.parts.forEach(({bounds:{min:e,max:t}},r)=>{e.forEach((i,s)=>{Math.fround(t[s])-Math.fround(i)>=1e-18||y("BOUNDS_EMPTY",`/parts/${r}/bounds`,`no extent along axis ${s}`)})});for(let e of["wo","wi"]){let t=n.domain[e];for(let{axis:r}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...r)-1)>.001&&y("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function Cu(n){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let r=n[e].map(({name:i})=>i);new Set(r).size!==r.length&&y(t,`/${e}`,"a name is there twice")}n.tiers.forEach(({validation:e},t)=>{(e?.flipAtHeight??[]).forEach(({height:r},i,s)=>{i&&r>=s[i-1].height&&y("FIELD_VALUE",`/tiers/${t}/validation/flipAtHeight/${i}`,"heights must descend")})})}function Uu(n){n.tiers.forEach((e,t)=>{e.parts.length!==n.parts.length&&y("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${n.parts.length}`),e.parts.forEach((r,i)=>{!r.emission!=!n.tiers[0].parts[i].emission&&y("PARTS_DIFFER",`/tiers/${t}/parts/${i}`,"emission in some tiers alone")})})}function Du(n){let e=n.extensionsUsed??[];for(let t of[...Object.keys(n.extensions??{}),...n.extensionsRequired??[]])e.includes(t)||y("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function Hu(n){n.tiers.forEach((e,t)=>e.parts.forEach((r,i)=>{let{kind:s}=n.parts[i],o=(c,l)=>{for(let f of c)l(dt(f))||y("INPUT_KIND",`/tiers/${t}/parts/${i}/inputs`,`${f} is not for this part`)};o(r.inputs,({kinds:c})=>c.includes(s)),o(r.emission?.inputs??[],({kinds:c,light:l})=>c.includes(s)&&!l)}))}function Bu(n){n.parts.forEach((e,t)=>{for(let[r,i]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let s=`/parts/${t}/${r}`;e[r]&&e.kind!=="surface"&&y("FIELD_VALUE",s,`of a ${e.kind}`);let o=0;(e[r]??[]).forEach(({triangles:[c,l]},f)=>{c<o&&y(i,`${s}/${f}`,"ranges must ascend and not overlap"),o=c+l})}})}function*Gu(n){for(let[e,t]of n.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let r of["transmittance","normalMaps"])for(let[i,s]of(t[r]??[]).entries())yield[`/parts/${e}/${r}/${i}`,s.texture]}for(let[e,t]of n.tiers.entries())for(let[r,i]of t.parts.entries()){let s=`/tiers/${e}/parts/${r}`;yield[`${s}/planes`,i.planes],yield[`${s}/decoder`,i.decoder],i.emission&&(yield[`${s}/emission/decoder`,i.emission.decoder])}}function $u(n){let e=new Set;for(let[r,i]of Gu(n))Object.hasOwn(n.entries,i)||y("REFERENCE_MISSING",r,`no entry ${i}`),e.add(i);let t=(n.extensionsUsed??[]).map(r=>`extensions/${r}/`);for(let r of Object.keys(n.entries))!e.has(r)&&!t.some(i=>r.startsWith(i))&&y("ENTRY_UNREFERENCED","/entries",`nothing refers to ${r}`)}function Oo(n,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(n.entries,t)&&y("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:r}]of Object.entries(n.entries)){let i=e.get(t);(!i||t==="manifest.json")&&y("ENTRY_MISSING","/entries",`the archive lacks ${t}`),i.size!==r&&y("ENTRY_SIZE",`/entries/${t}`,`found ${i.size}, expected ${r}`)}}var ot={type:"string"},Mo={type:"array",items:{type:"number"}},Ie=n=>({type:"integer",minimum:n,maximum:2**32-1}),at=n=>({type:"array",minItems:1,maxItems:1,items:n}),Oe=(n,e={})=>({type:"object",properties:{...n,...e},required:Object.keys(n),additionalProperties:!1}),Lo={type:"array",minItems:3,maxItems:3,items:{type:"number"}},Fo={const:"KHR_mesh_quantization"};function Po(n){let e=n?[5122,5123,5125,5126]:[5125,5126],t=Oe({bufferView:Ie(0),componentType:{enum:e},count:Ie(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:Ie(0),normalized:n?{type:"boolean"}:{const:!1},min:Mo,max:Mo,name:ot}),r=Oe({buffer:{const:0},byteLength:Ie(1)},{byteOffset:Ie(0),target:{enum:[34962,34963]},name:ot,...n&&{byteStride:{enum:[4,8]}}}),i=Oe({POSITION:Ie(0),NORMAL:Ie(0)},{TEXCOORD_0:Ie(0)}),s=Oe({attributes:i,indices:Ie(0)},{mode:{const:4}});return Oe({asset:Oe({version:{const:"2.0"}},{generator:ot,copyright:ot}),scenes:at(Oe({nodes:at({const:0})},{name:ot})),nodes:at(Oe({mesh:{const:0},...n&&{translation:Lo,scale:Lo}},{name:ot})),meshes:at(Oe({primitives:at(s)},{name:ot})),buffers:at(Oe({byteLength:Ie(1)},{name:ot})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:r},...n&&{extensionsUsed:at(Fo),extensionsRequired:at(Fo)}},{scene:{const:0},extras:{}})}var qu=Po(!1),ju=Po(!0);function zo(n,e){let t="extensionsUsed"in n||"extensionsRequired"in n;try{Bt(t?ju:qu,n)}catch(r){y("GEOMETRY_PROFILE",e,`${r.where}: not as meshes of packages are`)}return t&&Wu(n.nodes[0],e),Zu(n,t,e),t}function Wu({scale:[n,e,t]},r){n>0&&n===e&&n===t||y("GEOMETRY_PROFILE",r,`the scale ${[n,e,t]}`)}function Zu(n,e,t){let{attributes:r,indices:i}=n.meshes[0].primitives[0],s=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[c,l]of[...Object.entries(r),["indices",i]]){let f=n.accessors[l],h=f&&n.bufferViews[f.bufferView];if(!h)continue;let[m,g]=s[c];m.includes(f.type)&&g.some(([x,R,F])=>f.componentType===x&&(f.normalized??!1)===R&&h.byteStride===F)||y("GEOMETRY_PROFILE",t,`the accessor of ${c}`)}n.accessors[i]?.componentType===5123&&n.accessors[r.POSITION]?.count>=65535&&y("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var Yu={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},Vu={SCALAR:1,VEC2:2,VEC3:3};function Co(n,e){let{json:t,bin:r}=Xu(n,e),i=zo(t,e),s=t.buffers[0].byteLength;(s>r.length||r.length-s>3)&&y("GEOMETRY_RANGE",e,`a buffer of ${s} bytes in a chunk of ${r.length}`);let o=t.meshes[0].primitives[0],c=h=>Ku(t,r.subarray(0,s),h,e),l={positions:c(o.attributes.POSITION),normals:c(o.attributes.NORMAL),uvs:"TEXCOORD_0"in o.attributes?c(o.attributes.TEXCOORD_0):null,indices:c(o.indices)};Ju(l,e),Qu(t.accessors[o.attributes.POSITION],l.positions,i,e);let f=i?ef(l,t.nodes[0]):l;return f.indices=Uint32Array.from(l.indices),tf(f,e),f}function Xu(n,e){let t="GEOMETRY_CONTAINER",r=new DataView(n.buffer,n.byteOffset,n.length);(n.length<20||r.getUint32(0,!0)!==1179937895||r.getUint32(4,!0)!==2)&&y(t,e,"no binary glTF 2.0"),r.getUint32(8,!0)!==n.length&&y(t,e,"the length in the header is not that of the entry");let i=[];for(let s=12;s<n.length;){s+8>n.length&&y(t,e,"a chunk is cut short");let o=r.getUint32(s,!0),c=r.getUint32(s+4,!0);(o%4||s+8+o>n.length)&&y(t,e,`a chunk of ${o} bytes`),i.push([c,n.subarray(s+8,s+8+o)]),s+=8+o}return i.map(([s])=>s).join()!==[1313821514,5130562].join()&&y(t,e,"not the chunks JSON and BIN"),i[0][1].length>65536&&y(t,e,"JSON of more than 64 KiB"),{json:Ct(i[0][1],e,t),bin:i[1][1]}}function Ku(n,e,t,r){let i=n.accessors[t];i||y("GEOMETRY_RANGE",r,`no accessor ${t}`);let s=n.bufferViews[i.bufferView];s||y("GEOMETRY_RANGE",r,`no buffer view ${i.bufferView}`);let o=Yu[i.componentType],c=Vu[i.type],l=o.BYTES_PER_ELEMENT*c,f=s.byteStride??l,h=(s.byteOffset??0)+(i.byteOffset??0),m=(i.byteOffset??0)+f*(i.count-1)+l;(m>s.byteLength||(s.byteOffset??0)+s.byteLength>e.length)&&y("GEOMETRY_RANGE",r,`accessor ${t} reaches past its bytes`),h%4&&y("GEOMETRY_PROFILE",r,`accessor ${t} is not aligned`);let g=f===l?Ut(o,e,h,c*i.count):new o(c*i.count);if(f!==l){let _=Ut(o,e,h,Math.floor(m-(i.byteOffset??0))/o.BYTES_PER_ELEMENT),x=f/o.BYTES_PER_ELEMENT;for(let R=0;R<i.count;R++)for(let F=0;F<c;F++)g[c*R+F]=_[x*R+F]}return Object.assign(g,{items:c})}function Ju({positions:n,normals:e,uvs:t,indices:r},i){let s=n.length/3;(e.length!==n.length||t&&t.length!==2*s||!s)&&y("GEOMETRY_ARRAY",i,"attributes of different counts"),(r.length%3||!r.length)&&y("GEOMETRY_ARRAY",i,"part of a triangle")}function Qu(n,e,t,r){["min","max"].every(s=>{if(n[s]?.length!==3)return!1;for(let o=0;o<3;o++){let c=e[o];for(let f=o;f<e.length;f+=3)(s==="min"?e[f]<c:e[f]>c)&&(c=e[f]);if((t?n[s][o]:Math.fround(n[s][o]))!==c&&Number.isFinite(c))return!1}return!0})||y("GEOMETRY_BOUNDS",r,"min and max of POSITION are not those of its values")}function ef({positions:n,normals:e,uvs:t},{translation:r,scale:i}){return{positions:Float32Array.from(n,(s,o)=>r[o%3]+i[0]*s),normals:Float32Array.from(e,s=>Math.max(s/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,s=>s/65535):t)}}function tf({positions:n,normals:e,uvs:t,indices:r},i){for(let o of[n,e,t??[]])for(let c=0;c<o.length;c++)Number.isFinite(o[c])||y("GEOMETRY_NOT_FINITE",i,"an attribute is not finite");let s=n.length/3;for(let o=0;o<r.length;o++)r[o]>=s&&y("GEOMETRY_INDEX",i,`vertex ${r[o]} of ${s}`);for(let o=0;o<e.length;o+=3){let c=Math.hypot(e[o],e[o+1],e[o+2]);Math.abs(c-1)>.001&&y("GEOMETRY_NORMAL",i,`a normal of length ${c}`)}}var nf={float16:"F16",float32:"F32",int8:"I8"},Ei=1e18;function ki(n,{planePrecision:e,resolution:t,channels:r},i){let s=tt(n,i,"PLANES_HEADER"),{tensors:o}=s,c=e==="int8",l=c?{scales:["F32",[3,r]],planes:["I8",[3,t,t,r]]}:{planes:[nf[e],[3,t,t,r]]},f=Object.keys(l),h=Object.keys(o);rt(s.metadata)||y("PLANES_TENSOR",i,"__metadata__ is no object"),(h.length!==f.length||f.some(x=>!h.includes(x)))&&y("PLANES_TENSOR",i,`found ${h.join(", ")||"no tensors"}, expected ${f.join(", ")}`);for(let x of f)nt(o[x])||y("PLANES_HEADER",i,`${x} is no tensor`);for(let x of f){let[R,F]=l[x],W=o[x];W.dtype!==R&&y("PLANES_DTYPE",i,`${x}: found ${W.dtype}, expected ${R}`),W.shape.join()!==F.join()&&y("PLANES_SHAPE",i,`${x}: found [${W.shape}], expected [${F}]`)}let m=it(n,s,f,i,"PLANES_HEADER");s.data%64&&y("PLANES_ALIGNMENT",i,"data does not start at a multiple of 64");let g=m.at(-1),_=c?m[0]:null;return rf(e,g,_,i),{values:g,scales:_,resolution:t,channels:r,precision:e}}function rf(n,e,t,r){let i=()=>y("PLANES_NOT_FINITE",r,`NaN, or a value beyond ${Ei}`);if(n==="int8")t.some(s=>!(Math.abs(s)*128<=Ei))&&i();else if(n==="float16")for(let s=0;s<e.length;s++)(e[s]&31744)===31744&&i();else for(let s=0;s<e.length;s++)Math.abs(e[s])<=Ei||i()}var sf=8192;function Uo(n,e,t,r,i){let s=tt(n,r,i),o=s.tensors[e];rt(s.metadata)||y(i,r,"__metadata__ is no object"),(Object.keys(s.tensors).join()!==e||!nt(o))&&y(i,r,`not one tensor ${e}`);let[c,l,f]=o.shape,h=o.shape.length===3&&[c,l].every(g=>g>=1&&g<=sf);(o.dtype!=="U8"||!h||!t.includes(f))&&y(i,r,`found ${o.dtype} [${o.shape}], expected U8 [H, W, ${t.join(" or ")}]`),s.data%64&&y(i,r,"data does not start at a multiple of 64");let[m]=it(n,s,[e],r,i);return{values:m,height:c,width:l,channels:f}}function Do(n,e,t){let r="TRANSMITTANCE_TEXTURE",i=Uo(n,"transmittance",[1,3],t,r);return e.cutoff!==void 0&&i.channels!==1&&y(r,t,"a cutoff of a coloured texture"),i}function Ho(n,e){return Uo(n,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function Ti({triangles:[n,e]},t,r,i,s){n+e>r.indices.length/3&&y(`${s}_RANGE`,i,`triangles ${n} to ${n+e} of ${r.indices.length/3}`),(s==="NORMAL_MAP"||t.width*t.height>1)&&!r.uvs&&y(`${s}_UV`,i,"the mesh has no texture coordinates")}var of=65536,Gt=class n{static async open(e){let t=new n;return t.source=e,t.directory=await Js(e),t.cache=new Map,t.manifest=Io(await t._stored(zt)),Oo(t.manifest,t.directory),t.environment=Ro(t.manifest),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(r=>r.name===e):this.manifest.tiers[0];if(!t){let r=this.manifest.tiers.map(i=>i.name).join(", ");y("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${r}`)}return t}bytesOf(e){return this._ranges([...new Set([...this._entriesOf(this.tier(e)),...or(this.environment??[])])]).reduce((t,[r,i])=>t+i-r,0)}async load(e,{wantsLobes:t=!1}={}){let r=this.tier(e),i=this._entriesOf(r);await this._fetch(i);let s=new Map;for(let c of i)s.set(c,await this._data(c));let o=this.manifest.parts.map((c,l)=>this._part(c,r.parts[l],l,s));return t&&this.environment&&await this._addEnvironment(o,r,s),{name:r.name,tier:r,parts:o}}async _addEnvironment(e,t,r){let i=or(this.environment).filter(s=>!r.has(s));await this._fetch(i);for(let s of i)r.set(s,await this._data(s));this.environment.forEach((s,o)=>{e[o].environment=this._environment(e[o],s,t.parts[o],r)})}_environment(e,t,r,i){let{inputs:s,lobes:o,visibility:c}=t,l=(e.mesh?.positions??e.curves.points).length/3,h=["planes","resolution","channels","planePrecision"].every(_=>t[_]===r[_])?e.planes:ki(i.get(t.planes),t,t.planes),m=c?ko(i.get(c),l,c):null,g=c?Ht:0;return{inputs:s,lobes:o,harmonics:m,planes:h,...Si(i,t,t,"environment",9*o,g)}}async posterImage(){return this.poster?(await this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(e,t,r,i){let{kind:s,bounds:o,geometry:c}=e,l=`/parts/${r}`,f=i.get(c),h={name:e.name,kind:s,bounds:af(o),inputs:t.inputs};return s==="surface"?h.mesh=Co(f,c):h.curves=so(f,c),h.transmittance=(e.transmittance??[]).map(m=>{let g=Do(i.get(m.texture),m,m.texture);return Ti(m,g,h.mesh,l,"TRANSMITTANCE"),{...m,texture:g}}),h.normalMaps=(e.normalMaps??[]).map(m=>{let g=Ho(i.get(m.texture),m.texture);return Ti(m,g,h.mesh,l,"NORMAL_MAP"),{...m,texture:g}}),h.planes=ki(i.get(t.planes),t,t.planes),h.transport=Si(i,t,t,"transport",6),h.emission=t.emission?{inputs:t.emission.inputs,...Si(i,t,t.emission,"emission",3)}:null,h}_entriesOf(e){let t=[];for(let r of this.manifest.parts){t.push(r.geometry);for(let i of[...r.transmittance??[],...r.normalMaps??[]])t.push(i.texture)}for(let r of e.parts)t.push(r.planes,r.decoder),r.emission&&t.push(r.emission.decoder);return[...new Set(t)]}_ranges(e){let t=e.map(i=>this.directory.get(i)).sort((i,s)=>i.header-s.header),r=[];for(let{header:i,end:s}of t){let o=r.at(-1);o&&i-o[1]<=of?o[1]=s:r.push([i,s])}return r}async _fetch(e){let t=e.filter(r=>!this.cache.has(r));this.source.expected=this.source.ranged?this.source.fetched+this._ranges(t).reduce((r,[i,s])=>r+s-i,0):this.source.size;for(let[r,i]of this._ranges(t)){let s=await this.source.read(r,i);for(let o of t){let c=this.directory.get(o);c.header>=r&&c.end<=i&&this.cache.set(o,s.subarray(c.header-r,c.end-r))}}}async _stored(e){let t=this.directory.get(e),r=this.cache.get(e)??await this.source.read(t.header,t.end);return Qs(t,r)}async _data(e){let t=await this._stored(e);await Bo(t,this.manifest.entries[e].sha256,e);let r=this.manifest.extensions?.RNA_deflate?.entries[e];if(!r)return t;let i=await xo(t,r,e);return await Bo(i,r.sha256,e),i}};function Si(n,e,t,r,i,s=0){let c={columns:t.inputs.reduce((l,f)=>l+sr(f,e.channels),s),outputs:i,output:r,precision:t.decoderPrecision};return yo(n.get(t.decoder),c,t.decoder)}function af({min:n,max:e}){return{min:n.map(Math.fround),max:e.map(Math.fround)}}async function Bo(n,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",n))].map(s=>s.toString(16).padStart(2,"0")).join("")!==e&&y("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var cf=[64,67,71];function Go(n){let{backgroundColor:e}=getComputedStyle(n);return(/^rgb\((\d+), (\d+), (\d+)\)$/.exec(e)?.slice(1).map(Number)??cf).map(r=>r/255).map(r=>r<=.04045?r/12.92:((r+.055)/1.055)**2.4)}var Ni={};rs(Ni,{evaluate:()=>ff,mappedNormals:()=>pf,visibility:()=>hf});function cr(n,e,t,r,i,s){let o=Math.ceil(i/256),c=new Float32Array(4*256*o);for(let l=0;l<i;l++)c.set(t.subarray(s*l+r,s*l+r+4),4*l);n.bindTexture(n.TEXTURE_2D,e.texture),n.texSubImage2D(n.TEXTURE_2D,0,0,0,256,o,n.RGBA,n.FLOAT,c)}function lf(n){let e=[4,8,12].map(r=>uf(n.subarray(r,r+3))),t=n.every(Number.isFinite)&&e.every(Boolean);e.forEach((r,i)=>n.set(t?r:[0,0,0],4+4*i)),t||n.set([0,0,0,0],0)}function uf(n){let e=Math.hypot(...n);return e>0&&Number.isFinite(e)?Array.from(n,t=>t/e):null}function $o(n,e){let t=Math.ceil(e/256);n.resize(256,t),n.span={rows:t,firstRow:0},n.frame={cameraAt:["3fv",[0,0,0]],height:["1i",t],firstRow:["1i",0],sampleNumber:["1ui",0]}}async function ff(n,e,t,r,i=!0){let s=t==="transport"?2:1,o=r.length/16,c=new Float32Array(3*s*o),l=n.bandPixels;for(let f=0;f<o;f+=l){let h=Math.min(l,o-f),{gl:m}=n;$o(n,h);let g=r.slice(16*f,16*(f+h));for(let _=0;_<h;_++)lf(g.subarray(16*_,16*_+16)),g[16*_+7]=g[16*_+3],g[16*_+3]=e+1,g[16*_+15]=1;if([0,4,8].forEach((_,x)=>cr(m,n.rows.images[x],g,_,h,16)),cr(m,n.lit.images[0],g,12,h,16),n._decode(t),await n.done(),!!i)for(let _=0;_<s;_++){let x=n.answers.read(_);for(let R=0;R<h;R++)c.set(x.subarray(4*R,4*R+3),3*(s*(f+R)+_))}}return c}function qo(n,e){let t=new Float32Array(16*e.length);e.forEach(({place:r,b1:i,b2:s,x:o,wi:c,part:l},f)=>{t.set([...o,l+1,0,0,0,i,0,0,0,r,1,1,1,s],16*f),e[f].own=c}),$o(n,e.length),[0,4,8,12].forEach((r,i)=>cr(n.gl,n.rows.images[i],t,r,e.length,16))}async function hf(n,e){qo(n,e);let{gl:t}=n,r=n.answers.images[0],i=new Float32Array(4*e.length);return e.forEach((s,o)=>i.set(s.wi,4*o)),cr(t,r,i,0,e.length,4),n._light({kind:"given",colour:[1,1,1]},r),jo(n.lit.read(1),e.length)}async function pf(n,e){qo(n,e);let[,t,r,i]=n.rows.images;return n._pass("normals",n.answers,{...n.asset,rows1:t,rows2:r,rows3:i},n.geometry),jo(n.answers.read(0),e.length)}function jo(n,e){return Float32Array.from({length:3*e},(t,r)=>n[4*Math.floor(r/3)+r%3])}var Ii={};rs(Ii,{evaluate:()=>gf,mappedNormals:()=>_f,visibility:()=>vf});var mf=["maxStorageBufferBindingSize","maxBufferSize"];async function Wo(){if(!navigator.gpu)throw new H(isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine");let n=await navigator.gpu.requestAdapter({powerPreference:"high-performance"});if(!n)throw new H("WebGPU has no adapter here");let e=Object.fromEntries(mf.map(t=>[t,n.limits[t]]));return n.requestDevice({requiredLimits:e})}function te(n,e,t=GPUBufferUsage.STORAGE,r="a buffer"){let i=typeof e=="number"?e:e.byteLength,s=Math.max(16,Math.ceil(i/16)*16),o=n.limits.maxStorageBufferBindingSize;if(s>o)throw new H(`${r} takes ${pt(s)}; this GPU allows ${pt(o)}`);let c=n.createBuffer({size:s,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(c.getMappedRange()).set(l),c.unmap()}return c}async function lr(n,e){let t=n.createShaderModule({code:e}),{messages:r}=await t.getCompilationInfo(),i=r.find(({type:s})=>s==="error");if(i)throw new Error(`a shader does not compile, line ${i.lineNum}: ${i.message}`);return t}var _n=(n,e,t,r)=>Me(n,e.getBindGroupLayout(t),r);function ke(n,e){let t=Object.entries(e).map(([r,i])=>({binding:Number(r),visibility:GPUShaderStage.COMPUTE,buffer:{type:i}}));return n.createBindGroupLayout({entries:t})}function Me(n,e,t){let r=Object.entries(t).map(([i,s])=>({binding:Number(i),resource:{buffer:s}}));return n.createBindGroup({layout:e,entries:r})}function fe(n,e,t,r){let i=Math.max(1,Math.ceil(r/64)),s=Math.min(i,32768);n.setPipeline(e),t.forEach((o,c)=>n.setBindGroup(c,o)),n.dispatchWorkgroups(s,Math.ceil(i/s))}async function wn(n,e,t){let r=n.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),i=n.createCommandEncoder();i.copyBufferToBuffer(e,0,r,0,r.size),n.queue.submit([i.finish()]),await r.mapAsync(GPUMapMode.READ);let s=r.getMappedRange().slice(0);return r.destroy(),s}var df={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]};async function gf(n,e,t,r,i=!0){let s=n.parts[e][t],{device:o,queue:c,bandPixels:l}=n,f=t==="transport"?2:1,h=r.length/16,m=new Float32Array(3*f*h);for(let g=0;g<h;g+=l){let _=Math.min(l,h-g);if(o.queue.writeBuffer(c.rows,0,r,16*g,16*_),o.queue.writeBuffer(c.count,0,Uint32Array.of(_)),n._run(R=>s.run(R,c,_)),await n.done(),!i)continue;let x=new Float32Array(await wn(o,c.answers,16*f*_));for(let R=0;R<f*_;R++)m.set(x.subarray(4*R,4*R+3),3*(f*g+R))}return m}async function Zo(n,e,t,r){let{device:i,band:s}=n,{words:o,members:c}=ce.Pixel,l=new Uint32Array(o*e.length);e.forEach(({place:h,b1:m,b2:g,x:_,wi:x,part:R},F)=>{let W=($,V)=>[...new Uint32Array(Float32Array.from($).buffer),V];l.set(le("Pixel",{position:W(_,0),axis:[0,0,0,R+1],wo:[0,0,0,h],wi:W(x,0),b1:m,b2:g}),o*F)}),n.resize(e.length,1),n.span={first:0,pixels:e.length,jitter:0},i.queue.writeBuffer(s,0,l),n._writeFrame(df,0),n._writeView({kind:"given",colour:[1,1,1]}),n._run(h=>fe(h,t,n.groups.rays,e.length));let f=new Float32Array(await wn(i,s,l.byteLength));return Float32Array.from({length:3*e.length},(h,m)=>f[o*Math.floor(m/3)+c[r].at+m%3])}var vf=(n,e)=>Zo(n,e,n.kernels.light,"visibility");async function _f(n,e){let t=await n.pipelines.get(n.raySources.hit,"find_normals",n.rayLayout);return Zo(n,e,t,"axis")}var Oi=n=>Uint8Array.from(atob(n),e=>e.charCodeAt(0));function Mi(n){let e=new Uint8Array(n.buffer,n.byteOffset,n.byteLength),t="";for(let r=0;r<e.length;r+=8192)t+=String.fromCharCode(...e.subarray(r,r+8192));return btoa(t)}var ur=class{constructor(e){this.engine=e,this.answers=e.constructor.label==="WebGPU"?Ii:Ni}async load(e,t){let r=await Gt.open(new kt(new Blob([Oi(e)]),"package"));this.shown=await r.load(t),this.arrays=Kn(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown.parts),this.engine.resize(1,1)}async evaluate(e,t,r){let i=t==="transport"?13:10,s=new Float32Array(Oi(r).buffer),o=new Float32Array(16*s.length/i);for(let c=0;16*c<o.length;c++){let l=s.subarray(i*c,i*(c+1)),f=l.subarray(7,10);o.set([...l.subarray(0,3),l[6],...l.subarray(3,6),0,...f,0,...i===13?l.subarray(10):f],16*c)}return Mi(await this.answers.evaluate(this.engine,e,t,o))}async visibility(e){return Mi(await this.answers.visibility(this.engine,this._hits(e)))}async normals(e){return Mi(await this.answers.mappedNormals(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=Oi(e),r=new Uint32Array(t),i=new Float32Array(t),s=[];for(let o=0;o<r.length;o+=8){let c=r[o+7],{first:l,fiber:f}=this.arrays.parts[c],h=i.subarray(o,o+7),m=this.arrays.where[l+r[o]];s.push(f?{place:m,part:c,b1:0,b2:0,x:h.slice(1,4),wi:h.slice(4,7)}:{place:m,part:c,b1:h[1],b2:h[2],x:[0,0,0],wi:h.slice(3,6)})}return s}};var wf=`#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;function Yo(n){let e=n.getContext("webgl2",{alpha:!1,antialias:!1,preserveDrawingBuffer:!0});if(!e)throw new H("this browser has no WebGL2");if(!e.getExtension("EXT_color_buffer_float"))throw new H("this device's WebGL2 cannot draw into float textures");return e}var $t=class{constructor(e,t){this.gl=e,this.program=e.createProgram();for(let[r,i]of[[e.VERTEX_SHADER,wf],[e.FRAGMENT_SHADER,`#version 300 es
${t}`]]){let s=e.createShader(r);e.shaderSource(s,i),e.compileShader(s),e.attachShader(this.program,s),e.deleteShader(s)}e.linkProgram(this.program),this.places=new Map}check(){let{gl:e,program:t}=this;if(e.getProgramParameter(t,e.LINK_STATUS)||e.isContextLost())return;let r=e.getAttachedShaders(t).map(i=>e.getShaderInfoLog(i));throw new Error(`a shader does not compile: ${[e.getProgramInfoLog(t),...r].join(" ")}`)}_place(e){return this.places.has(e)||this.places.set(e,this.gl.getUniformLocation(this.program,e)),this.places.get(e)}set(e){for(let[t,[r,...i]]of Object.entries(e))this.gl[`uniform${r}`](this._place(t),...i)}textures(e){Object.entries(e).forEach(([t,r],i)=>{this.gl.activeTexture(this.gl.TEXTURE0+i),this.gl.bindTexture(r.target,r.texture),this.gl.uniform1i(this._place(t),i)})}delete(){this.gl.deleteProgram(this.program)}},yf=2048;function Le(n,e,t=yf){let r=new Map([[Float32Array,[n.RGBA32F,n.RGBA,n.FLOAT]],[Uint32Array,[n.RGBA32UI,n.RGBA_INTEGER,n.UNSIGNED_INT]],[Uint8Array,[n.RGBA8UI,n.RGBA_INTEGER,n.UNSIGNED_BYTE]]]),i=Math.ceil(Math.max(1,e.length/4)/t);xf(n,i);let s=new e.constructor(4*t*i);return s.set(e),Vo(n,t,i,...r.get(e.constructor),s)}function xf(n,e){let t=n.getParameter(n.MAX_TEXTURE_SIZE);if(e>t)throw new H(`the asset needs textures of side ${e}; this device has ${t}`)}function Vo(n,e,t,r,i,s,o=null){let c=n.createTexture();return n.bindTexture(n.TEXTURE_2D,c),n.pixelStorei(n.UNPACK_ALIGNMENT,1),n.texImage2D(n.TEXTURE_2D,0,r,e,t,0,i,s,o),Li(n,n.TEXTURE_2D),{target:n.TEXTURE_2D,texture:c,width:e,height:t}}function Li(n,e){n.texParameteri(e,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(e,n.TEXTURE_MAG_FILTER,n.NEAREST),n.texParameteri(e,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(e,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}var ct=class{constructor(e,t,r,i){if(Object.assign(this,{gl:e,width:t,height:r}),this.images=Array.from({length:i},()=>Vo(e,t,r,e.RGBA32F,e.RGBA,e.FLOAT)),this.frame=e.createFramebuffer(),e.bindFramebuffer(e.FRAMEBUFFER,this.frame),this.images.forEach(({texture:s},o)=>e.framebufferTexture2D(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+o,e.TEXTURE_2D,s,0)),e.drawBuffers(this.images.map((s,o)=>e.COLOR_ATTACHMENT0+o)),e.checkFramebufferStatus(e.FRAMEBUFFER)!==e.FRAMEBUFFER_COMPLETE&&!e.isContextLost())throw new H("this device cannot draw into float textures")}read(e){let{gl:t,width:r,height:i}=this,s=new Float32Array(4*r*i);return t.bindFramebuffer(t.FRAMEBUFFER,this.frame),t.readBuffer(t.COLOR_ATTACHMENT0+e),t.readPixels(0,0,r,i,t.RGBA,t.FLOAT,s),s}delete(){this.gl.deleteFramebuffer(this.frame);for(let{texture:e}of this.images)this.gl.deleteTexture(e)}};function fr(n,e,t,{textures:r={},uniforms:i={},to:s}={}){let{width:o,height:c}=t??n.canvas;n.bindFramebuffer(n.FRAMEBUFFER,t?.frame??null),n.viewport(0,0,o,c),n.enable(n.SCISSOR_TEST),n.scissor(0,0,o,s??c),n.useProgram(e.program),e.set(i),e.textures(r),n.drawArrays(n.TRIANGLES,0,3)}async function Xo(n){let e=n.fenceSync(n.SYNC_GPU_COMMANDS_COMPLETE,0);for(n.flush();;){if(n.isContextLost())return;let t=n.clientWaitSync(e,0,0);if(t===n.ALREADY_SIGNALED||t===n.CONDITION_SATISFIED)break;await new Promise(r=>setTimeout(r,1))}n.deleteSync(e)}var{RNA_NONE:ta,MAX_LAYERS:Ko,MAX_EXACT_INPUTS:Jo,RNA_CHANNEL_GROUPS:Qo}=se,qt=n=>Math.ceil(n/4);function jt(n,e,t,r=0){bf(e);let{places:i,slots:s,queryGroups:o}=Af(t,n.planes.channels,r),c=new Fi,l=ta;e.int8&&(l=c.add(hr(e.gain,i,o)),c.add(hr(e.offset,i,o)));let f=e.layers.map((x,R)=>ea(c,x,R?null:i,R?0:o)),h=null;if(e.matrix){let x=e.matrix.length/e.outputs,R=new Float32Array(e.outputs);h=ea(c,{weight:e.matrix,bias:R,rows:x,columns:e.outputs,relu:!1},null,0)}let m=[...f,...h?[h]:[]],g=Math.max(...m.flatMap(({inputs:x,outputs:R})=>[x,R])),_=Rf(n,e,{queryGroups:o,gain:l,slots:s,layers:f,matrix:h});return{weights:c.all(),record:_,groups:Math.max(4,2**Math.ceil(Math.log2(g)))}}function bf({layers:n,int8:e}){if(n.length>Ko)throw new H(`a decoder of ${n.length} layers; at most ${Ko}`);let t=e?Math.max(...n.map(({rows:r})=>r)):0;if(t>Jo)throw new H(`an int8 layer of ${t} inputs; at most ${Jo}`)}function Af(n,e,t){let r=[],i=ir.map(()=>ta),s=0;for(let o of n){let c=sr(o,e);i[ir.indexOf(dt(o))]=s;for(let l=0;l<c;l++)r.push(4*s+l);s+=qt(c)}for(let o=0;o<t;o++)r.push(4*s+o);return s+=qt(t),{places:r,slots:i,queryGroups:s}}var Fi=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let r of this.list)e.set(r,t),t+=r.length;return e}};function hr(n,e,t){let r=new Float32Array(4*t);return n.forEach((i,s)=>{r[e?e[s]:s]=i}),r}function ea(n,{weight:e,bias:t,rows:r,columns:i,step:s=0,scales:o,relu:c},l,f){let h=f||qt(r),m=qt(i),g=new Float32Array(16*h*m);for(let F=0;F<r;F++){let W=l?l[F]:F,$=W>>2;for(let V=0;V<i;V++)g[16*((V>>2)*h+$)+4*(W&3)+(V&3)]=e[F*i+V]}let _=n.add(g),x=n.add(hr(t,null,m)),R=o?n.add(hr(Float32Array.from(o,F=>F*s),null,m)):0;return{inputs:h,outputs:m,weights:_,bias:x,units:R,relu:Number(c),int8_step:s}}function Rf(n,e,{queryGroups:t,gain:r,slots:i,layers:s,matrix:o}){let{resolution:c,channels:l,precision:f,scales:h}=n.planes,{low:m,high:g,top:_,unit:x}=e,R=new Float32Array(12*Qo);for(let F=0;h&&F<3;F++)R.set(h.subarray(F*l,(F+1)*l),4*Qo*F);return le("RnaPart",{low:n.bounds.min,high:n.bounds.max,resolution:c,channel_groups:qt(l),query_groups:t,layer_count:s.length,plane_precision:se[`RNA_${f.toUpperCase()}`],gain:r,query_low:m,query_high:g,top:_,unit:x,matrix:o??{},scales:R,layers:s,slots:i})}function pr({values:n,resolution:e,channels:t},r){let i=e*e,s=n.subarray(r*i*t,(r+1)*i*t),o=4*qt(t);if(o===t)return s;let c=new n.constructor(i*o);for(let l=0;l<i;l++)c.set(s.subarray(l*t,(l+1)*t),l*o);return c}var na=`// Input blocks of a decoder (spec, 6.3), in the forms for float32. Each starts at a group of four columns.

uniform bool isFiber;
uniform sampler2DArray planes;  // three planes of \`channel_groups\` layers of four channels

// Features are summed over the planes (spec, 5).
vec4 featuresOf(uint group, vec3 p) {
  float size = float(part.resolution);
  vec4 sum = vec4(0.0);
  for (uint k = 0u; k < 3u; k++) {
    vec2 at = clamp(vec2(p[k], p[(k + 1u) % 3u]) * size - 0.5, 0.0, size - 1.0);
    ivec2 low = ivec2(floor(at)), high = min(low + 1, int(size) - 1);
    vec2 f = at - floor(at);
    int layer = int(k * part.channel_groups + group);
    vec4 lower = mix(texelFetch(planes, ivec3(low, layer), 0), texelFetch(planes, ivec3(high.x, low.y, layer), 0), f.x);
    vec4 upper = mix(texelFetch(planes, ivec3(low.x, high.y, layer), 0), texelFetch(planes, ivec3(high, layer), 0), f.x);
    vec4 scale = part.plane_precision == RNA_INT8 ? part.scales[k * RNA_CHANNEL_GROUPS + group] : vec4(1.0);
    sum += mix(lower, upper, f.y) * scale;
  }
  return sum;
}

vec3 halfway(vec3 wo, vec3 wi, vec3 instead) {
  vec3 s = wi + wo, e = wi - wo;
  float apart = dot(e, e), together = dot(s, s);
  if (together < 1e-12) return instead;
  if (together < apart) s -= e * (dot(s, e) / apart);
  return unit(s);
}

float gap(vec3 n, vec3 m) {
  vec3 d = n - m;
  return log2(0.5 * dot(d, d) + 1e-4) / 6.0;
}

uint slotOf(uint block) {
  return part.slots[block >> 2][block & 3u];
}

bool has(uint block) {
  return slotOf(block) != RNA_NONE;
}

void put(uint block, vec4 value) {
  if (has(block)) values[slotOf(block)] = value;
}

// With the second group of blocks of more than four columns.
void put(uint block, vec4 value, vec4 more) {
  put(block, value);
  if (has(block)) values[slotOf(block) + 1u] = more;
}

void putSurface(vec3 n, vec3 wo, vec3 wi, vec3 features) {
  vec3 m = halfway(wo, wi, n), aside = cross(n, m);
  put(RNA_BLOCK_NORMAL, vec4(n, 0.0));
  put(RNA_BLOCK_HALF_VECTOR, vec4(dot(n, m), gap(n, m), dot(n, wi), dot(n, wo)), vec4(dot(wi, m), 0.0, 0.0, 0.0));
  put(RNA_BLOCK_HIGHLIGHT, vec4(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
  vec3 bent = n + 0.1 * features, q = length(bent) < 1e-6 ? n : unit(bent), learned = halfway(wo, wi, q);
  put(RNA_BLOCK_LEARNED_NORMAL, vec4(dot(q, learned), gap(q, learned), 0.0, 0.0));
}

void putFiber(vec3 t, float h, vec3 wo, vec3 wi) {
  put(RNA_BLOCK_TANGENT, vec4(t, 0.0));
  put(RNA_BLOCK_H, vec4(h, 0.0, 0.0, 0.0));
  vec3 o = cross(t, wo), i = cross(t, wi);
  float so = dot(t, wo), si = dot(t, wi), co = length(o), d = co * length(i), sum = so + si;
  float cosPhi = 1.0, sinPhi = 0.0;
  if (d >= 1e-6) {
    cosPhi = clamp(dot(o, i) / d, -1.0, 1.0);
    sinPhi = clamp(dot(t, cross(o, i)) / d, -1.0, 1.0);
  }
  put(RNA_BLOCK_FIBER_ANGLES, vec4(si, so, sum, log2(sum * sum + 1e-3) / 6.0), vec4(cosPhi, sinPhi, 0.0, 0.0));
  // Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi. As cosine and sine.
  float sinT = h * co / sqrt(1.55 * 1.55 - so * so);
  vec2 lobe = vec2(1.0 - 2.0 * h * h, 2.0 * h * sqrt(max(0.0, 1.0 - h * h)));
  vec2 turn = vec2(2.0 * sinT * sinT - 1.0, 2.0 * sinT * sqrt(max(0.0, 1.0 - sinT * sinT)));
  vec4 lobes = vec4(0.0);
  for (int p = 0; p < 3; p++) {
    lobes[p] = cosPhi * lobe.x + sinPhi * lobe.y;
    lobe = vec2(lobe.x * turn.x - lobe.y * turn.y, lobe.x * turn.y + lobe.y * turn.x);
  }
  put(RNA_BLOCK_FIBER_LOBES, lobes);
}

// Fills \`values\`. x: a position, axis: n or t; all directions unit.
void fillValues(vec3 x, vec3 axis, float h, vec3 wo, vec3 wi) {
  vec3 p = clamp((x - part.low) / (part.high - part.low), 0.0, 1.0);
  vec4 features = featuresOf(0u, p);
  put(RNA_BLOCK_FEATURES, features);
  for (uint group = 1u; has(RNA_BLOCK_FEATURES) && group < part.channel_groups; group++) {
    values[slotOf(RNA_BLOCK_FEATURES) + group] = featuresOf(group, p);
  }
  put(RNA_BLOCK_POSITION, vec4(2.0 * p - 1.0, 0.0));
  put(RNA_BLOCK_WO, vec4(wo, 0.0));
  put(RNA_BLOCK_WI, vec4(wi, 0.0));
  if (isFiber) putFiber(axis, h, wo, wi);
  else putSurface(axis, wo, wi, features.xyz);
}
`;var ra=`// Adds what one light brings, or what the asset emits, to the picture.
precision highp float;
precision highp sampler2D;
uniform sampler2D before;
uniform sampler2D rows0;
uniform sampler2D rows3;
uniform sampler2D lit0;
uniform sampler2D lit1;
uniform sampler2D lit2;
uniform sampler2D first;
uniform sampler2D second;
uniform bool isEmission;
uniform bool countsCoverage;  // once a round
uniform bool isFirst;
uniform int firstRow;
out vec4 sum;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  sum = isFirst ? vec4(0.0) : texelFetch(before, pixel + ivec2(0, firstRow), 0);
  float part = texelFetch(rows0, pixel, 0).w;
  vec3 a = texelFetch(first, pixel, 0).xyz;
  if (isEmission) {
    if (part > 0.0) sum.xyz += texelFetch(rows3, pixel, 0).xyz * a;
    return;
  }
  vec4 light = texelFetch(lit0, pixel, 0), v = texelFetch(lit1, pixel, 0);
  vec3 radiance = texelFetch(lit2, pixel, 0).xyz;
  if (light.w == 1.0) sum.xyz += radiance * mix(texelFetch(second, pixel, 0).xyz, a, v.xyz);
  if (light.w == 2.0) sum.xyz += radiance;
  if (countsCoverage) sum.w += v.w;
}
`;var ia=`// What the decoder of one part answers for the queries on it.
uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D lit0;
uniform int number;          // of the part
uniform bool hasLight;

layout(location = 0) out vec4 first;   // visible, or emitted
layout(location = 1) out vec4 second;  // shadowed

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0);
  vec4 light = texelFetch(lit0, pixel, 0);
  if (int(row0.w) != number + 1 || (hasLight && light.w != 1.0)) discard;
  vec4 row1 = texelFetch(rows1, pixel, 0);
  vec3 wo = texelFetch(rows2, pixel, 0).xyz, wi = hasLight ? light.xyz : wo;
  first = vec4(0.0, 0.0, 0.0, 1.0);
  second = vec4(0.0, 0.0, 0.0, 1.0);
  if (row1.xyz == vec3(0.0)) return;  // an argument was no direction (spec, 8.1)
  float h = isFiber ? clamp(row1.w, -1.0, 1.0) : 0.0;
  fillValues(row0.xyz, row1.xyz, h, wo, wi);
  decode(first.xyz, second.xyz);
}
`;var sa=`// The layers of a decoder (spec, 6.4). Values are in groups of four, weights in blocks of 4 x 4: four texels, one of
// outputs for each of four inputs.

uniform sampler2D weights;

vec4 values[GROUPS];
vec4 next[GROUPS];

vec4 weightAt(uint k) {
  return texelFetch(weights, ivec2(k & 1023u, k >> 10), 0);
}

void runLayer(RnaLayer layer) {
  bool isInt8 = layer.int8_step > 0.0;
  if (isInt8) {
    // Products and their sums are whole numbers below 2^24 as long as layers are narrower than 512.
    for (uint i = 0u; i < layer.inputs; i++) values[i] = clamp(roundEven(values[i] / layer.int8_step), 0.0, 255.0);
  }
  uint at = layer.weights;
  for (uint o = 0u; o < layer.outputs; o++) {
    vec4 bias = weightAt(layer.bias + o), sum = isInt8 ? vec4(0.0) : bias;
    for (uint i = 0u; i < layer.inputs; i++, at += 4u) {
      vec4 x = values[i];
      sum += weightAt(at) * x.x + weightAt(at + 1u) * x.y + weightAt(at + 2u) * x.z + weightAt(at + 3u) * x.w;
    }
    if (isInt8) sum = (sum + bias) * weightAt(layer.units + o);
    next[o] = layer.relu == 1u ? max(sum, 0.0) : sum;
  }
  for (uint o = 0u; o < layer.outputs; o++) values[o] = next[o];
}

// The colours, of \`values\` filled with the query.
void decode(out vec3 first, out vec3 second) {
  for (uint i = 0u; i < part.query_groups; i++) {
    vec4 value = clamp(values[i], part.query_low, part.query_high);
    values[i] = part.gain == RNA_NONE ? value : value * weightAt(part.gain + i) + weightAt(part.gain + part.query_groups + i);
  }
  for (uint k = 0u; k < part.layer_count; k++) runLayer(part.layers[k]);
  uint last = part.layers[part.layer_count - 1u].outputs;
  for (uint i = 0u; i < last; i++) values[i] = (exp(clamp(values[i], 0.0, part.top)) - 1.0) * part.unit;
  if (part.matrix.inputs != 0u) runLayer(part.matrix);
  first = max(values[0].xyz, 0.0);
  second = max(vec3(values[0].w, values[1].xy), 0.0);
}
`;var oa=`// A ray from the camera through each pixel, to the query of its first hit.
#include random

uniform vec3 cameraAt;
uniform vec3 corner;       // direction through the image's top left corner
uniform vec3 stepX;        // of a pixel
uniform vec3 stepY;
uniform int height;        // of the picture
uniform int firstRow;      // of the band
uniform float jitter;      // 0: rays through the middles of pixels, 1: anywhere in them

layout(location = 0) out vec4 row0;  // x; part + 1, or 0
layout(location = 1) out vec4 row1;  // n or t; of a fiber h, of a surface b1
layout(location = 2) out vec4 row2;  // wo; place of the primitive
layout(location = 3) out vec4 row3;  // throughput; b2

const int LAYERS_SEEN_THROUGH = 32;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) + ivec2(0, firstRow);
  pixel.y = height - 1 - pixel.y;  // rows from the top, as the random numbers of WebGPU have them
  vec2 at = vec2(pixel) + mix(vec2(0.5), random(pixel, PLACE), jitter);
  vec3 d = normalize(corner + at.x * stepX + at.y * stepY), origin = cameraAt, through = vec3(1.0);
  row0 = vec4(0.0);
  row1 = vec4(0.0);
  row2 = vec4(-d, 0.0);
  row3 = vec4(0.0);
  for (int k = 0; k < LAYERS_SEEN_THROUGH; k++) {
    Hit hit = nearest(origin, d);
    if (hit.t == FAR) break;
    uvec4 primitive = wordsAt(primitives, hit.place);
    bool fiber = isSegment(primitive);
    vec3 tau = fiber ? vec3(0.0) : transmittance(primitive, hit, d);
    float chance = max(tau.x, max(tau.y, tau.z));
    // Straight on, or stopped here: chosen at random (spec, 4.4).
    if (chance > 0.0 && random(pixel, STOPPED + uint(k)).x < chance) {
      through *= tau / chance;
      origin += d * (hit.t + 4.0 * epsilon);
      continue;
    }
    if (chance > 0.0) through *= (1.0 - tau) / (1.0 - chance);
    vec3 x = origin + hit.t * d;
    float part = float(surfaceRow(primitive, SURFACE_PART_ROW)[SURFACE_PART] + 1u);
    if (fiber) {
      vec3 t = tangentOf(primitive);
      row1 = vec4(t, offsetAcross(hit.n, t, -d));
    } else {
      x = mixed(cornersOf(primitive).p, weightsOf(hit));
      row1 = vec4(shadingNormal(primitive, hit), hit.b1);
    }
    row0 = vec4(x, part);
    row2.w = float(hit.place);
    row3.w = hit.b2;
    break;
  }
  row3.xyz = through;
}
`;var aa=`// Where a ray meets a triangle or a round segment (spec, 4.1 and 4.2).

// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013): both sides.
struct Shear {
  ivec3 axes;
  vec3 s;
};

Shear shearOf(vec3 d) {
  vec3 a = abs(d);
  int z = a.x > a.y ? 0 : 1;
  if (a.z > a[z]) z = 2;
  int x = (z + 1) % 3, y = (z + 2) % 3;
  return Shear(ivec3(x, y, z), vec3(d[x], d[y], 1.0) / d[z]);
}

bool meetsTriangle(uvec4 primitive, vec3 origin, Shear shear, float far, inout Hit hit) {
  vec3 v[3];
  for (int k = 0; k < 3; k++) {
    vec3 p = valuesAt(points, int(primitive[k])).xyz - origin;
    vec3 q = vec3(p[shear.axes.x], p[shear.axes.y], p[shear.axes.z]);
    v[k] = vec3(q.xy - shear.s.xy * q.z, q.z);
  }
  float u0 = v[2].x * v[1].y - v[2].y * v[1].x;
  float u1 = v[0].x * v[2].y - v[0].y * v[2].x;
  float u2 = v[1].x * v[0].y - v[1].y * v[0].x;
  if (min(u0, min(u1, u2)) < 0.0 && max(u0, max(u1, u2)) > 0.0) return false;
  float sum = u0 + u1 + u2;
  if (sum == 0.0) return false;
  float t = (u0 * v[0].z + u1 * v[1].z + u2 * v[2].z) * shear.s.z / sum;
  if (!(t >= 0.0 && t < far)) return false;
  hit.t = t;
  hit.b1 = u1 / sum;
  hit.b2 = u2 / sum;
  return true;
}

struct Cone {
  vec3 a, b;
  float ra, rb;
};

Cone coneAt(int point) {
  vec4 a = valuesAt(points, point), b = valuesAt(points, point + 1);
  return Cone(a.xyz, b.xyz, a.w, b.w);
}

// The entry into a sphere, from a point near it.
float entersSphere(vec3 origin, vec3 d, vec3 centre, float radius) {
  vec3 between = origin - centre;
  float along = dot(between, d);
  vec3 across = between - along * d;
  float h = radius * radius - dot(across, across);
  return h > 0.0 ? -along - sqrt(h) : 1e30;
}

// The first of all points where the line enters one of the two spheres or the side between them.
bool entersCone(Cone cone, vec3 origin, vec3 d, out float t, out vec3 n) {
  vec3 axis = cone.b - cone.a;
  // From the point of the line nearest to the segment, so that distances do not cancel.
  float shift = dot(0.5 * (cone.a + cone.b) - origin, d);
  vec3 near = (origin - cone.a) + shift * d;
  float dr = cone.ra - cone.rb, length2 = dot(axis, axis), d2 = length2 - dr * dr;
  float ta = entersSphere(near, d, vec3(0.0), cone.ra), tb = entersSphere(near, d, axis, cone.rb);
  t = min(ta, tb);
  n = near + t * d - (ta < tb ? vec3(0.0) : axis);
  if (d2 > 0.0) {
    float m1 = dot(axis, near), m2 = dot(axis, d), m3 = dot(d, near);
    float k2 = d2 - m2 * m2, k1 = d2 * m3 - m1 * m2 + m2 * dr * cone.ra;
    float k0 = d2 * dot(near, near) - m1 * m1 + 2.0 * m1 * dr * cone.ra - length2 * cone.ra * cone.ra;
    float h = k1 * k1 - k0 * k2;
    if (h >= 0.0 && k2 != 0.0) {
      for (float way = -1.0; way < 2.0; way += 2.0) {
        float side = (-k1 + way * sqrt(h)) / k2, y = m1 - cone.ra * dr + side * m2;
        vec3 normal = d2 * (near + side * d) - axis * y;
        if (y > 0.0 && y < d2 && side < t && dot(normal, d) < 0.0) {
          t = side;
          n = normal;
        }
      }
    }
  }
  if (t > 1e29) return false;
  t += shift;
  n = unit(n);
  return true;
}

// How far p is outside of the cone; negative inside.
float distanceTo(Cone cone, vec3 p) {
  vec3 axis = cone.b - cone.a, near = p - cone.a;
  float dr = cone.ra - cone.rb, size = length(axis), y = dot(near, axis) / size, z = y - size;
  float x = length(near - axis * (y / size));
  float toA = length(vec2(x, y)) - cone.ra, toB = length(vec2(x, z)) - cone.rb;
  if (size * size <= dr * dr) return dr > 0.0 ? toA : toB;
  float slope = dr / size, lean = sqrt(1.0 - slope * slope), along = y * lean - x * slope;
  if (along <= 0.0) return toA;
  if (along >= size * lean) return toB;
  return x * lean + y * slope - cone.ra;
}

// An entry inside the segment before or after is no surface.
bool insideNeighbour(int point, uint neighbours, vec3 p) {
  for (int k = 0; k < 2; k++) {
    if ((neighbours & (k == 0 ? RNA_HAS_BEFORE : RNA_HAS_AFTER)) == 0u) continue;
    Cone cone = coneAt(point + (k == 0 ? -1 : 1));
    if (distanceTo(cone, p) < -1e-4 * min(cone.ra, cone.rb)) return true;
  }
  return false;
}

bool meetsSegment(uvec4 primitive, vec3 origin, vec3 d, float far, inout Hit hit) {
  int point = int(primitive[PRIMITIVE_A]);
  float t;
  vec3 n;
  if (!entersCone(coneAt(point), origin, d, t, n)) return false;
  if (!(t >= 0.0 && t < far)) return false;
  if (insideNeighbour(point, primitive[PRIMITIVE_B], origin + t * d)) return false;
  hit.t = t;
  hit.n = n;
  return true;
}
`;var ca=`// For each query a direction of one light, the radiance from there, and how much of it the asset lets through.
#include random

uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
uniform sampler2D given;        // directions, of the conformance kit
uniform int lightKind;          // LIGHT_SUN and so on, of sources.js
uniform vec3 lightDirection;    // of a sun
uniform vec3 lightColour;       // its irradiance, or a factor of the environment
uniform sampler2D sky;          // the environment's numbers: see light/environment.js
uniform ivec4 skyPlaces;        // of texels, heights, sums of rows, sums of columns
uniform ivec2 skySize;          // width, height
uniform float skyTotal;
uniform vec2 turn;              // cosine and sine of the environment's rotation
uniform vec4 ground;            // height, 1 if there is one, middle x and z
uniform vec3 groundColour;      // radiance of it in full light, over the light's irradiance
uniform float groundSize;
uniform vec3 cameraAt;
uniform int height;
uniform int firstRow;

layout(location = 0) out vec4 lit0;  // wi; 0 nothing, 1 a query, 2 radiance in lit2
layout(location = 1) out vec4 lit1;  // visibility; coverage
layout(location = 2) out vec4 lit2;  // radiance over density, times the throughput

const float PI = 3.14159265358979;

float skyNumber(int at) {
  return valuesAt(sky, at >> 2)[at & 3];
}

// A cell between the middles of four texels, and how bright each is.
struct Cell {
  vec3 a, b, c, d;
  vec4 luminance;
};

vec3 skyTexel(int row, int column) {
  int at = skyPlaces.x + 3 * (clamp(row, 0, skySize.y - 1) * skySize.x + column % skySize.x);
  return vec3(skyNumber(at), skyNumber(at + 1), skyNumber(at + 2));
}

Cell skyCell(int row, int column) {
  vec3 a = skyTexel(row - 1, column), b = skyTexel(row - 1, column + 1);
  vec3 c = skyTexel(row, column), d = skyTexel(row, column + 1), weights = vec3(0.2126, 0.7152, 0.0722);
  return Cell(a, b, c, d, vec4(dot(a, weights), dot(b, weights), dot(c, weights), dot(d, weights)));
}

// Radiance in a cell, bilinear; and the density of brightDirection there, in proportion to its luminance.
vec3 inCell(Cell cell, int row, vec2 f, float sine, out float density) {
  vec3 radiance = mix(mix(cell.a, cell.b, f.x), mix(cell.c, cell.d, f.x), f.y);
  density = dot(radiance, vec3(0.2126, 0.7152, 0.0722)) * float(skySize.x) / (2.0 * PI * max(skyTotal, 1e-30));
  if (row > 0 && row < skySize.y) {
    density *= skyNumber(skyPlaces.y + row) * float(skySize.y) / (PI * max(sine, 1e-30));
  }
  return radiance;
}

vec3 skyAt(vec3 d, out float density) {
  float sine = length(d.xz), azimuth = sine > 0.0 ? atan(d.x, -d.z) : 0.0;
  vec2 at = vec2(0.5 + azimuth / (2.0 * PI), atan(sine, d.y) / PI) * vec2(skySize) + vec2(-0.5, 0.5), low = floor(at);
  int row = clamp(int(low.y), 0, skySize.y), column = (int(low.x) + skySize.x) % skySize.x;
  return inCell(skyCell(row, column), row, at - vec2(low.x, row), sine, density);
}

// The interval of \`count\` running sums from \`first\` on that a value is in; the place in it, from 0 to 1.
int interval(int first, int count, float value, out float place) {
  int low = 0, high = count;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (skyNumber(first + middle) <= value) low = middle;
    else high = middle;
  }
  float before = skyNumber(first + low), size = skyNumber(first + low + 1) - before;
  place = size > 0.0 ? clamp((value - before) / size, 0.0, 0.99999994) : 0.0;
  return low;
}

// A place in [0, 1] with density in proportion to a line from a to b.
float linearPlace(float a, float b, float u) {
  float root = sqrt(max(mix(a * a, b * b, u), 0.0));
  return a + root > 0.0 ? u * (a + b) / (a + root) : u;
}

// A row of cells, a cell of it, and a place in that, in proportion to the luminance; at the poles uniform in the cosine.
vec3 brightDirection(vec2 u) {
  vec2 at;
  int rows = skySize.y, row = interval(skyPlaces.z, rows + 1, u.y * skyNumber(skyPlaces.z + rows + 1), at.y);
  int sums = skyPlaces.w + row * (skySize.x + 1), column = interval(sums, skySize.x, u.x * skyNumber(sums + skySize.x), at.x);
  vec4 l = skyCell(row, column).luminance;
  float cap = 2.0 * asin(sqrt(0.5 * at.y * skyNumber(skyPlaces.y + row))) / PI * float(rows);
  float y = row == 0 ? cap + 0.5 : row == rows ? 0.5 - cap : linearPlace(l.x + l.y, l.z + l.w, at.y);
  float x = linearPlace(mix(l.x, l.z, y), mix(l.y, l.w, y), at.x);
  float theta = PI * (float(row) - 0.5 + y) / float(rows), sine = sin(theta);
  float phi = 2.0 * PI * ((float(column) + 0.5 + x) / float(skySize.x) - 0.5);
  vec3 d = vec3(sine * sin(phi), cos(theta), -sine * cos(phi));
  return vec3(turn.x * d.x + turn.y * d.z, d.y, turn.x * d.z - turn.y * d.x);
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
  vec3 n;  // turned to the viewer
  vec3 mirror;
};

const float MIRRORED = 1.0 / 3.0, MIRROR_KAPPA = 20.0;  // of a von Mises-Fisher distribution
const float FROM_ALL_SIDES = 0.25, EVEN = 0.25 / PI;

float mirroredShare(Surroundings at) {
  return at.mirror == vec3(0.0) ? 0.0 : MIRRORED;
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
vec3 along(vec3 axis, float cosine, float phi) {
  float side = axis.z < 0.0 ? -1.0 : 1.0, c = -1.0 / (side + axis.z), d = axis.x * axis.y * c;
  vec3 s = vec3(1.0 + side * axis.x * axis.x * c, side * d, -side * axis.x);
  vec3 t = vec3(d, side + axis.y * axis.y * c, -axis.y);
  return normalize(sqrt(max(0.0, 1.0 - cosine * cosine)) * (cos(phi) * s + sin(phi) * t) + cosine * axis);
}

vec3 directionAbout(Surroundings at, vec2 u) {
  float share = mirroredShare(at), phi = 2.0 * PI * u.x;
  if (u.y < share) {
    float v = u.y / share;
    return along(at.mirror, 1.0 + log(v + (1.0 - v) * exp(-2.0 * MIRROR_KAPPA)) / MIRROR_KAPPA, phi);
  }
  float rest = (u.y - share) / (1.0 - share);
  bool allSides = rest < FROM_ALL_SIDES;
  float v = allSides ? rest / FROM_ALL_SIDES : (rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES);
  vec3 ball = along(vec3(0.0, 0.0, 1.0), 1.0 - 2.0 * v, phi);
  return normalize(ball + (allSides ? vec3(0.0) : at.n * 1.0001));
}

float densityAbout(Surroundings at, vec3 wi) {
  if (at.n == vec3(0.0)) return EVEN;
  float rest = mix(max(0.0, dot(at.n, wi)) / PI, EVEN, FROM_ALL_SIDES);
  float fisher = MIRROR_KAPPA / (2.0 * PI) * exp(MIRROR_KAPPA * (dot(at.mirror, wi) - 1.0));
  return mix(rest, fisher, mirroredShare(at));
}

Surroundings surroundingsOf(vec4 row0, vec4 row1, vec4 row2) {
  if (row0.w == 0.0) return Surroundings(vec3(0.0, 1.0, 0.0), vec3(0.0));  // of the ground
  if (isSegment(wordsAt(primitives, int(row2.w)))) return Surroundings(vec3(0.0), vec3(0.0));
  vec3 n = row1.xyz, wo = row2.xyz;
  return Surroundings(dot(n, wo) < 0.0 ? -n : n, reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
vec3 sampleLight(ivec2 pixel, Surroundings at, out vec3 wi) {
  if (lightKind == LIGHT_SUN || lightKind == LIGHT_GIVEN) {
    wi = lightKind == LIGHT_SUN ? lightDirection : texelFetch(given, pixel, 0).xyz;
    return lightColour;
  }
  vec2 u = random(ivec2(pixel.x, height - 1 - pixel.y - firstRow), DIRECTION);
  wi = lightKind == LIGHT_ENVIRONMENT ? brightDirection(u) : directionAbout(at, u);
  vec3 d = vec3(turn.x * wi.x - turn.y * wi.z, wi.y, turn.x * wi.z + turn.y * wi.x);
  float density;
  vec3 radiance = skyAt(d, density);
  return lightColour * radiance / (density + densityAbout(at, wi));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
  vec3 origin;
  uint strand;  // that is no obstacle
  vec3 weight;
  float coverage;
};

Start startOf(vec4 row0, vec4 row1, vec4 row2, float b2, vec3 wi) {
  int place = int(row2.w);
  uvec4 primitive = wordsAt(primitives, place);
  if (isSegment(primitive)) return Start(row0.xyz, primitive[PRIMITIVE_C], vec3(1.0), 1.0);
  Hit hit = Hit(0.0, place, row1.w, b2, vec3(0.0));
  return Start(liftedOrigin(primitive, hit, wi), NONE, vec3(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
Start startOnGround(vec3 d, vec3 wi) {
  if (ground.y == 0.0 || d.y * (cameraAt.y - ground.x) >= 0.0) return Start(vec3(0.0), NONE, vec3(0.0), 0.0);
  vec3 x = cameraAt + d * ((ground.x - cameraAt.y) / d.y);
  float fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - ground.zw) / groundSize);
  return Start(x + vec3(0.0, epsilon, 0.0), NONE, fade * max(0.0, wi.y) * groundColour, fade);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0), row1 = texelFetch(rows1, pixel, 0);
  vec4 row2 = texelFetch(rows2, pixel, 0), row3 = texelFetch(rows3, pixel, 0);
  bool isQuery = row0.w != 0.0;
  vec3 wi, radiance = row3.xyz * sampleLight(pixel, surroundingsOf(row0, row1, row2), wi);
  Start start;
  if (isQuery) start = startOf(row0, row1, row2, row3.w, wi);
  else start = startOnGround(-row2.xyz, wi);
  bool needed = any(greaterThan(start.weight, vec3(0.0)));
  vec3 passed = needed ? passes(start.origin, wi, start.strand) : vec3(0.0);
  lit0 = vec4(wi, isQuery ? 1.0 : 2.0);
  lit1 = vec4(passed, start.coverage);
  lit2 = vec4(isQuery ? radiance : start.weight * passed * radiance, 0.0);
}
`;var la=`// The normals of hits whose place and barycentric coordinates are in the rows.
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int place = int(texelFetch(rows2, pixel, 0).w);
  Hit hit = Hit(0.0, place, texelFetch(rows1, pixel, 0).w, texelFetch(rows3, pixel, 0).w, vec3(0.0));
  first = vec4(shadingNormal(wordsAt(primitives, place), hit), 1.0);
  second = vec4(0.0);
}
`;var ua=`// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and its own ray to the light (7.1).

struct Corners {
  vec3 p[3], n[3];
  vec2 uv[3];
};

Corners cornersOf(uvec4 primitive) {
  Corners corners;
  for (int k = 0; k < 3; k++) {
    vec4 place = valuesAt(points, int(primitive[PRIMITIVE_A + k])), normal = valuesAt(normals, int(primitive[PRIMITIVE_A + k]));
    corners.p[k] = place.xyz;
    corners.n[k] = normal.xyz;
    corners.uv[k] = vec2(place.w, normal.w);
  }
  return corners;
}

vec3 weightsOf(Hit hit) {
  return vec3(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2);
}

vec3 mixed(vec3 v[3], vec3 b) {
  return b.x * v[0] + b.y * v[1] + b.z * v[2];
}

vec2 uvOf(Corners corners, vec3 b) {
  return b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
vec3 lookUp(uint image, vec2 uv) {
  uvec4 record = wordsAt(surfaces, texturesAt + TEXTURE_ROWS * int(image));
  ivec2 size = ivec2(record[TEXTURE_SIZE] & 0xffffu, record[TEXTURE_SIZE] >> 16u);
  vec2 place = uv * vec2(size) - 0.5, low = floor(place), f = place - low;
  // Repeat before integers: coordinates may be large.
  ivec2 at = clamp(ivec2(low - vec2(size) * floor(low / vec2(size))), ivec2(0), size - 1), next = (at + 1) % size;
  ivec4 places = int(record[TEXTURE_PLACE]) + ivec4(at.y, at.y, next.y, next.y) * size.x + ivec4(at.x, next.x, at.x, next.x);
  vec3 lower = mix(vec3(wordsAt(texels, places.x).xyz), vec3(wordsAt(texels, places.y).xyz), f.x);
  vec3 upper = mix(vec3(wordsAt(texels, places.z).xyz), vec3(wordsAt(texels, places.w).xyz), f.x);
  return mix(lower, upper, f.y);
}

float fresnel(float index, float c) {
  float g2 = index * index - 1.0 + c * c;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2), r = (g - c) / (g + c), s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

vec3 transmittance(uvec4 primitive, Hit hit, vec3 d) {
  uint flags = surfaceRow(primitive, SURFACE_FLAGS_ROW)[SURFACE_FLAGS];
  if ((flags & LETS_THROUGH) == 0u) return vec3(0.0);
  uint through = surfaceRow(primitive, SURFACE_THROUGH_ROW)[SURFACE_THROUGH];
  float cutoff = uintBitsToFloat(surfaceRow(primitive, SURFACE_CUTOFF_ROW)[SURFACE_CUTOFF]);
  uvec4 iors = surfaceRow(primitive, SURFACE_IOR_ROW);
  vec2 ior = uintBitsToFloat(uvec2(iors[SURFACE_IOR], iors[SURFACE_IOR + 1]));  // in front and behind
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), tau = lookUp(through, uvOf(corners, b)) / 255.0;
  if ((flags & HAS_CUTOFF) != 0u) tau = vec3(tau.x > cutoff ? 1.0 : 0.0);
  if (ior.x > 0.0) {
    vec3 n = unit(mixed(corners.n, b)), ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
    tau *= 1.0 - fresnel(dot(d, ng) < 0.0 ? ior.x : ior.y, abs(dot(n, d)));
  }
  return tau;
}

// The normal with relief, 4.5.
vec3 mappedNormal(uint map, Corners corners, vec3 b, vec3 n) {
  if (map == NONE) return n;
  vec3 e1 = corners.p[1] - corners.p[0], e2 = corners.p[2] - corners.p[0];
  vec2 a = corners.uv[1] - corners.uv[0], c = corners.uv[2] - corners.uv[0];
  float area = a.x * c.y - c.x * a.y;
  if (area == 0.0) return n;
  vec3 u = (c.y * e1 - a.y * e2) * sign(area), v = (a.x * e2 - c.x * e1) * sign(area);
  vec3 along = u - dot(u, n) * n;
  if (length(along) <= 1e-6 * length(u)) return n;
  vec3 t = unit(along), up = cross(n, t);
  if (dot(up, v) > 0.0) up = -up;
  vec2 q = (lookUp(map, uvOf(corners, b)).xy - 127.0) / 127.0;
  vec3 m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
  return length(m) <= 1e-6 ? n : normalize(m);
}

vec3 shadingNormal(uvec4 primitive, Hit hit) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  return mappedNormal(surfaceRow(primitive, SURFACE_NORMAL_MAP_ROW)[SURFACE_NORMAL_MAP], corners, b, unit(mixed(corners.n, b)));
}

vec3 tangentOf(uvec4 primitive) {
  int point = int(primitive[PRIMITIVE_A]);
  return unit(valuesAt(points, point + 1).xyz - valuesAt(points, point).xyz);
}

// h of 4.2.
float offsetAcross(vec3 n, vec3 t, vec3 wo) {
  vec3 across = cross(t, wo);
  float size = length(across);
  return size > 1e-6 ? clamp(dot(n, across) / size, -1.0, 1.0) : 0.0;
}

// Where the visibility ray of a mesh starts.
vec3 liftedOrigin(uvec4 primitive, Hit hit, vec3 wi) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit), x = mixed(corners.p, b), n = unit(mixed(corners.n, b));
  vec3 ng = unit(cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
  float side = dot(ng, wi) < 0.0 ? -1.0 : 1.0;
  if (dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && dot(ng, wi) < 0.1) {
    vec3 lift = vec3(0.0);
    for (int k = 0; k < 3; k++) lift += b[k] * max(0.0, dot(corners.p[k] - x, corners.n[k])) * corners.n[k];
    x += (1.0 - max(0.0, dot(ng, wi)) / 0.1) * lift;
    side = 1.0;
  }
  return x + side * epsilon * ng;
}
`;var fa=`// Numbers in [0, 1). Of a pixel's place and of the light: of each pixel a start of its own, and from there the additive
// recurrence in four dimensions (Roberts 2018), so that the samples of a pixel are spread evenly. All others: hashed.

uniform uint sampleNumber;

uint hashed(uint x) {  // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

const uint PLACE = 0u, DIRECTION = 1u, STOPPED = 2u;  // and those behind it

vec2 random(ivec2 pixel, uint dimension) {
  uint own = dimension >= STOPPED ? sampleNumber : 0u;
  uint seed = hashed(uint(pixel.x) + hashed(uint(pixel.y) + hashed(dimension + hashed(own))));
  vec2 start = vec2(seed >> 8u, hashed(seed) >> 8u) / 16777216.0;
  if (dimension >= STOPPED) return start;
  // In whole numbers: floats of later samples would lose digits.
  uvec2 turn = dimension == DIRECTION ? uvec2(2700274805u, 2313257605u) : uvec2(3679390609u, 3152041523u);
  return fract(start + vec2((turn * sampleNumber) >> 8u) / 16777216.0);
}
`;var Pi=`// The asset's geometry in textures: see geometry/scene_arrays.js.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;

uniform usampler2D nodes;       // two texels a node: min, right child or first primitive; max, number of primitives
uniform usampler2D primitives;  // RnaPrimitive, one a texel, in the order of the leaves
uniform sampler2D points;       // position, and u or the radius
uniform sampler2D normals;      // normal and v
uniform usampler2D surfaces;    // rows of surfaces, then of textures: see geometry/surface_table.js
uniform usampler2D texels;      // of textures
uniform int texturesAt;
uniform float epsilon;          // the spec's e, 7.1

uvec4 wordsAt(usampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

vec4 valuesAt(sampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

bool isSegment(uvec4 primitive) {
  return (primitive[PRIMITIVE_TAG] & RNA_IS_SEGMENT) != 0u;
}

// Row k of the record of a primitive's surface.
uvec4 surfaceRow(uvec4 primitive, int k) {
  return wordsAt(surfaces, SURFACE_ROWS * int(primitive[PRIMITIVE_TAG] >> RNA_SURFACE_SHIFT) + k);
}

struct Hit {
  float t;
  int place;       // of the primitive in the table
  float b1, b2;    // barycentric coordinates
  vec3 n;          // of a segment, outward
};

vec3 unit(vec3 v) {
  vec3 size = abs(v);
  float largest = max(size.x, max(size.y, size.z));
  return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}
`;var ha=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
uniform float rounds;
uniform float exposure;  // a factor
uniform float filmicView;  // 1 for the filmic view transform, 0 for none
uniform float spread;    // of noise, in values of the screen; 0 to leave it
uniform vec3 backdrop;   // linear light of the screen
uniform vec2 size;       // of the canvas, pixels
out vec4 colour;

vec4 at(ivec2 place) {
  return texelFetch(picture, clamp(place, ivec2(0), textureSize(picture, 0) - 1), 0);
}

// As rna_render/image/view_transform.py, which names the source.
vec3 filmic(vec3 radiance) {
  vec3 c = 1.461926 * min(radiance, vec3(1e9));
  vec3 x = vec3(dot(c, vec3(0.59719, 0.35458, 0.04823)), dot(c, vec3(0.07600, 0.90834, 0.01566)),
                dot(c, vec3(0.02840, 0.13383, 0.83777)));
  // Both parts divided by x, so that none overflows.
  vec3 inv = 1.0 / max(x, vec3(1e-9));
  vec3 y = (x + 0.0245786 - 0.000090537 * inv) / (0.983729 * x + 0.4329510 + 0.238081 * inv);
  return vec3(dot(y, vec3(1.60475, -0.53108, -0.07367)), dot(y, vec3(-0.10208, 1.10813, -0.00605)),
              dot(y, vec3(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, of a mean.
vec3 displayed(vec4 mean) {
  vec3 exposed = max(mean.xyz * exposure, vec3(0.0));
  vec3 light = filmicView > 0.5 ? filmic(exposed) : exposed;
  vec3 linear = clamp(light, 0.0, 1.0) + max(0.0, 1.0 - mean.w) * backdrop;
  vec3 encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
  return clamp(encoded, 0.0, 1.0);
}

void main() {
  vec2 scale = vec2(textureSize(picture, 0)) / size;
  vec2 place = gl_FragCoord.xy * scale - 0.5, low = floor(place), f = place - low;
  ivec2 a = ivec2(low);
  vec4 mean = mix(mix(at(a), at(a + ivec2(1, 0)), f.x), mix(at(a + ivec2(0, 1)), at(a + ivec2(1, 1)), f.x), f.y) / rounds;
  vec3 here = displayed(mean);
  colour = vec4(here, 1.0);
  if (spread == 0.0) return;
  // Bilateral: neighbours count by how near and how like they are.
  vec4 sum = vec4(here, 1.0);
  vec2 middle = floor(place + 0.5);
  for (float dy = -2.0; dy <= 2.0; dy += 1.0) {
    for (float dx = -2.0; dx <= 2.0; dx += 1.0) {
      vec2 there = middle + vec2(dx, dy), away = there - place;
      vec4 other = at(ivec2(there)) / rounds;
      vec3 value = displayed(other), unlike = (value - here) / spread;
      float edge = 4.0 * (other.w - mean.w);
      sum += vec4(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
    }
  }
  colour = vec4(sum.xyz / sum.w, 1.0);
}
`;var pa=`// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48, ROOT = 1;  // node 0 is rna_gpu's, of the only instance
const float FAR = 1e30;

// No axis is exactly parallel: 0 times infinity would be no number.
vec3 inverseOf(vec3 d) {
  vec3 tiny = vec3(1e-20);
  return 1.0 / mix(d, tiny, lessThan(abs(d), tiny));
}

// Where a ray enters the box of a node, FAR if not.
float boxAt(int node, vec3 origin, vec3 inverse, float far) {
  vec3 a = (uintBitsToFloat(wordsAt(nodes, 2 * node).xyz) - origin) * inverse;
  vec3 b = (uintBitsToFloat(wordsAt(nodes, 2 * node + 1).xyz) - origin) * inverse, low = min(a, b), high = max(a, b);
  float near = max(max(low.x, low.y), max(low.z, 0.0)), last = min(min(high.x, high.y), min(high.z, far)) * 1.0000004;
  return near <= last ? near : FAR;
}

// The nearest hit of a ray, in \`hit\`, of which t is FAR for none; or, if it weakens, the light that passes to infinity.
// Strand \`own\` is no obstacle.
vec3 traced(vec3 origin, vec3 d, uint own, bool weakens, out Hit hit) {
  hit = Hit(FAR, 0, 0.0, 0.0, vec3(0.0));
  vec3 light = vec3(1.0), inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = ROOT;
  if (boxAt(ROOT, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    int first = int(wordsAt(nodes, 2 * node).w), count = int(wordsAt(nodes, 2 * node + 1).w);
    for (int k = first; k < first + count; k++) {
      uvec4 primitive = wordsAt(primitives, k);
      bool segment = isSegment(primitive);
      if (segment && primitive[PRIMITIVE_C] == own) continue;
      bool isHit = segment ? meetsSegment(primitive, origin, d, hit.t, hit) : meetsTriangle(primitive, origin, shear, hit.t, hit);
      if (!isHit) continue;
      hit.place = k;
      if (!weakens) continue;
      light *= segment ? vec3(0.0) : transmittance(primitive, hit, d);
      if (light == vec3(0.0)) return light;
      hit.t = FAR;
    }
    if (count == 0) {
      int left = node + 1, right = first;
      float a = boxAt(left, origin, inverse, hit.t), b = boxAt(right, origin, inverse, hit.t);
      if (max(a, b) < FAR) stack[top++] = a <= b ? right : left;
      if (min(a, b) < FAR) {
        node = a <= b ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}

Hit nearest(vec3 origin, vec3 d) {
  Hit hit;
  traced(origin, d, NONE, false, hit);
  return hit;
}

vec3 passes(vec3 origin, vec3 d, uint own) {
  Hit hit;
  return traced(origin, d, own, true, hit);
}
`;var{Surface:ma,Texture:da,RnaPrimitive:Uf}=ce,Df=([n])=>n.startsWith("RNA_")||["NONE","LETS_THROUGH","HAS_CUTOFF"].includes(n),zi=(n,{members:e},t)=>t.map(r=>{let{at:i}=e[r],s=`${n}_${r.toUpperCase()}`;return`const int ${s}_ROW = ${i>>2}, ${s} = ${i&3};
`}).join(""),va=`precision highp int;
const int SURFACE_ROWS = ${ma.words/4}, TEXTURE_ROWS = ${da.words/4};
${zi("SURFACE",ma,["part","flags","normal_map","through","cutoff","ior"])}
${zi("TEXTURE",da,["place","size"])}
${zi("PRIMITIVE",Uf,["a","b","c","tag"])}
${Object.entries(se).filter(Df).map(([n,e])=>`const uint ${n} = ${e}u;`).join(`
`)}
${Vn((n,e)=>`const int ${n} = ${e};`)}
`,Ci=[va,Pi,aa,ua,pa].join(`
`),ga=n=>n.replace("#include random",fa),mr={hit:Ci+ga(oa),light:Ci+ga(ca),normals:Ci+la,decode:(n,e)=>[va,Pi,n,`const int GROUPS = ${e};`,sa,na,ia].join(`
`),clear:"precision highp float; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = b = vec4(0.0); }",combine:ra,show:ha};function wa(n,e){let{resolution:t,channels:r,precision:i}=e,s=Math.ceil(r/4),o=n.getParameter(n.MAX_TEXTURE_SIZE);if(t>o)throw new H(`planes of ${t} texels a side; this device has ${o}`);let c=n.createTexture();n.bindTexture(n.TEXTURE_2D_ARRAY,c),n.pixelStorei(n.UNPACK_ALIGNMENT,1);let l=i==="float32"?n.RGBA32F:n.RGBA16F,f=i==="float16"?n.HALF_FLOAT:n.FLOAT;n.texStorage3D(n.TEXTURE_2D_ARRAY,1,l,t,t,3*s),Li(n,n.TEXTURE_2D_ARRAY);let h=new(i==="float16"?Uint16Array:Float32Array)(4*t*t);for(let m=0;m<3;m++){let g=pr(e,m);for(let _=0;_<s;_++){for(let x=0;x<h.length;x++)h[x]=g[4*((x>>2)*s+_)+(x&3)];n.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,m*s+_,t,t,1,n.RGBA,f,h)}}return{target:n.TEXTURE_2D_ARRAY,texture:c}}function _a(n){return Object.entries(ce[n].members).map(([e,{type:t,record:r,count:i}])=>{let[s,o]=t==="f32"?["float","vec"]:["uint","uvec"];return r?`${r} ${e}${i>1?`[${i}]`:""};`:i>4?`${o}4 ${e}[${Math.ceil(i/4)}];`:`${i>1?o+i:s} ${e};`}).join(" ")}var Hf=`struct RnaLayer { ${_a("RnaLayer")} };
layout(std140) uniform Part { ${_a("RnaPart")} } part;
`,yn=class{constructor(e,t,r,i,s,o){let{weights:c,record:l,groups:f}=jt(r,i,s);this.weights=Le(e,c,1024),this.planes=o,this.record=e.createBuffer(),e.bindBuffer(e.UNIFORM_BUFFER,this.record),e.bufferData(e.UNIFORM_BUFFER,l,e.STATIC_DRAW),this.program=new $t(e,mr.decode(Hf,f)),this.uniforms={number:["1i",t],isFiber:["1i",+(r.kind==="fiber")],hasLight:["1i",+(i.outputs===6)]}}get textures(){return{planes:this.planes,weights:this.weights}}delete(e){this.program.delete(),e.deleteBuffer(this.record),e.deleteTexture(this.weights.texture)}};var Bf=1<<17,dr=class n{static label="WebGL2";static async open(e){let t=Yo(e),r=new n;Object.assign(r,{gl:t,canvas:e,parts:[],target:null,lost:!1,bandPixels:Bf}),r.programs=Object.fromEntries(["hit","light","normals","clear","combine","show"].map(i=>[i,new $t(t,mr[i])]));for(let i of Object.values(r.programs))i.check();return e.addEventListener("webglcontextlost",i=>{i.preventDefault(),r.lost=!0,r.closed||r.onlost?.("the WebGL context was lost")}),r}setAsset(e,t){let{gl:r}=this;this._deleteAsset(),this.asset={nodes:Le(r,e.nodes),primitives:Le(r,e.primitives),points:Le(r,e.points),normals:Le(r,e.normals),surfaces:Le(r,e.table),texels:Le(r,new Uint8Array(e.images.buffer))},this.geometry={texturesAt:["1i",e.texturesAt],epsilon:["1f",e.extent*2**-18]},this.parts=t.map((i,s)=>{let o=wa(r,i.planes),c=new yn(r,s,i,i.transport,i.inputs,o),l=i.emission&&new yn(r,s,i,i.emission,i.emission.inputs,o);return{planes:o,transport:c,emission:l}});for(let{transport:i,emission:s}of this.parts)i.program.check(),s?.program.check()}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment({floats:e,places:t,total:r,width:i,height:s}){this.sky&&this.gl.deleteTexture(this.sky.texture),this.sky=Le(this.gl,e),this.skyNumbers={skyPlaces:["4i",...t],skySize:["2i",i,s],skyTotal:["1f",r]}}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let{gl:r}=this,i=Math.max(1,Math.min(t,Math.floor(this.bandPixels/e)));this._deleteImages(),this.target={width:e,height:t},this.rows=new ct(r,e,i,4),this.lit=new ct(r,e,i,3),this.answers=new ct(r,e,i,2),this.added=new ct(r,e,i,1),this.sum=new ct(r,e,t,1)}trace(e,t,r,i){let{height:s}=this.target;this.span={rows:i-r,firstRow:s-i};let{position:o,corner:c,stepX:l,stepY:f,jitter:h=1}=e;this.frame={cameraAt:["3fv",o],height:["1i",s],firstRow:["1i",this.span.firstRow],sampleNumber:["1ui",t]},this._pass("hit",this.rows,this.asset,{...this.geometry,...this.frame,jitter:["1f",h],corner:["3fv",c],stepX:["3fv",l],stepY:["3fv",f]})}light(e,{isFirst:t,countsCoverage:r}){this._light(e),this._decode("transport"),this._combine({isFirst:t,countsCoverage:r,isEmission:!1})}_light(e,t=null){let[r,i,s,o]=this.rows.images;this._pass("light",this.lit,{...this.asset,rows0:r,rows1:i,rows2:s,rows3:o,given:t??r,sky:this.sky??r},{...this.geometry,...this.frame,...this.skyNumbers,...Gf(e)})}emission(){this._pass("clear",this.answers,{},{}),this._decode("emission"),this._combine({isFirst:!1,countsCoverage:!1,isEmission:!0})}_combine({isEmission:e,countsCoverage:t,isFirst:r}){let{gl:i}=this,{width:s}=this.target,{rows:o,firstRow:c}=this.span,[l,,,f]=this.rows.images,[h,m,g]=this.lit.images,[_,x]=this.answers.images,R=F=>["1i",Number(F)];this._pass("combine",this.added,{before:this.sum.images[0],rows0:l,rows3:f,lit0:h,lit1:m,lit2:g,first:_,second:x},{isEmission:R(e),countsCoverage:R(t),isFirst:R(r),firstRow:["1i",c]}),i.bindFramebuffer(i.READ_FRAMEBUFFER,this.added.frame),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,this.sum.frame),i.disable(i.SCISSOR_TEST),i.blitFramebuffer(0,0,s,o,0,c,s,c+o,i.COLOR_BUFFER_BIT,i.NEAREST)}_pass(e,t,r,i){fr(this.gl,this.programs[e],t,{to:this.span.rows,textures:r,uniforms:i})}show({rounds:e,exposure:t,backdrop:r,filmic:i,spread:s}){let{width:o,height:c}=this.canvas;fr(this.gl,this.programs.show,null,{textures:{picture:this.sum.images[0]},uniforms:{rounds:["1f",e],exposure:["1f",t],backdrop:["3fv",r],size:["2f",o,c],filmicView:["1f",Number(i)],spread:["1f",s]}})}done(){return Xo(this.gl)}async picture(){let{width:e,height:t}=this.target,r=this.sum.read(0),i=new Float32Array(r.length);for(let s=0;s<t;s++)i.set(r.subarray(4*e*s,4*e*(s+1)),4*e*(t-1-s));return i}_decode(e){let[t,r,i]=this.rows.images,s=this.lit.images[0];for(let o of this.parts){let c=o[e];c&&(this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER,0,c.record),fr(this.gl,c.program,this.answers,{to:this.span.rows,textures:{...c.textures,rows0:t,rows1:r,rows2:i,lit0:s},uniforms:c.uniforms}))}}_deleteAsset(){for(let{texture:e}of Object.values(this.asset??{}))this.gl.deleteTexture(e);for(let{planes:e,transport:t,emission:r}of this.parts)this.gl.deleteTexture(e.texture),t.delete(this.gl),r?.delete(this.gl);this.parts=[]}_deleteImages(){for(let e of[this.rows,this.lit,this.answers,this.added,this.sum])e?.delete();this.target=null}close(){this.closed=!0,this._deleteAsset(),this._deleteImages();for(let e of Object.values(this.programs))e.delete();this.gl.getExtension("WEBGL_lose_context")?.loseContext()}};function Gf({kind:n,direction:e=[0,1,0],colour:t,angle:r=0,ground:i}){return{lightKind:["1i",cn[n]],lightDirection:["3fv",e],lightColour:["3fv",t],turn:["2f",Math.cos(r),Math.sin(r)],ground:["4f",i?.height??0,i?1:0,i?.x??0,i?.z??0],groundColour:["3fv",i?.colour??[0,0,0]],groundSize:["1f",i?.size??1]}}var _t={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["row_records.wgsl","arguments.wgsl","evaluate.wgsl"],"render/step":["render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl","render/sampler.wgsl"],"render/scene":["render/step","geometry_records.wgsl","geometry.wgsl","segment.wgsl","normal_maps.wgsl","visibility.wgsl","render/surfaces.wgsl","render/textures.wgsl","render/transmittance.wgsl","render/bumps.wgsl","render/vertex.wgsl"],"render/lit":["render/directions.wgsl","render/lights.wgsl","render/environment.wgsl","render/triangle_lights.wgsl"],"render/traced":["triangle.wgsl","bvh.wgsl","render/light_shapes.wgsl","render/passing.wgsl","render/tracing.wgsl"],rays:["render/scene","triangle.wgsl","bvh.wgsl","render/passing.wgsl","render/tracing.wgsl"],hit:["rays"],light:["rays","render/lit","render/light_shapes.wgsl","render/lobe_constants.wgsl"],columns:["geometry_records.wgsl","queue"],queue:["row_records.wgsl","render/scene_records.wgsl","render/table_records.wgsl","render/frame.wgsl"]},lt={"arguments.wgsl":`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
// by their bits, since WGSL may assume that there is no NaN, and may take subnormal numbers for 0.

const RNA_EXPONENT: u32 = 0x7f800000u;

fn rna_is_finite(bits: vec4<u32>) -> bool {
    return all((bits & vec4<u32>(RNA_EXPONENT)) != vec4<u32>(RNA_EXPONENT));
}

// A component, divided by 2^(largest - 127); of a subnormal largest 0, by 2^-149.
fn rna_scaled(bits: u32, largest: u32) -> f32 {
    let exponent = (bits & RNA_EXPONENT) >> 23u;
    let mantissa = f32(bits & 0x7fffffu);
    var size = 0.0;
    if largest == 0u {
        size = mantissa;
    } else if exponent != 0u {
        let down = largest - exponent;
        if down < 64u {
            size = bitcast<f32>(((127u - down) << 23u) | (bits & 0x7fffffu));
        }
    } else if largest < 64u {
        size = mantissa * bitcast<f32>((105u - largest) << 23u);
    }
    return select(size, -size, (bits >> 31u) == 1u);
}

// The unit vector along one of any length; 0 of length 0.
fn rna_unit(bits: vec3<u32>) -> vec3f {
    let exponents = (bits & vec3<u32>(RNA_EXPONENT)) >> vec3<u32>(23u);
    let largest = max(exponents.x, max(exponents.y, exponents.z));
    let v = vec3f(
        rna_scaled(bits.x, largest), rna_scaled(bits.y, largest), rna_scaled(bits.z, largest),
    );
    let square = dot(v, v);
    if square == 0.0 {
        return vec3f(0.0);
    }
    return v / sqrt(square);
}
`,"blocks.wgsl":`// Input blocks that surfaces and fibers share: spec/RNA.md, 6.3 Input blocks. Each block starts at
// a group of 4 columns of its own; the packer has spread the rows of the first matrix likewise.

// First group of an input block, RNA_NONE where the decoder does not have it.
fn rna_slot(block: u32) -> u32 {
    return rna_part.slots[block / 4u][block % 4u];
}

fn rna_put(slot: u32, values: vec4f) {
    if slot != RNA_NONE {
        rna_values[slot] = values;
    }
}

// Writes \`features\`, \`position\`, \`wo\` and \`wi\`; returns the first three features.
fn rna_common_blocks(x: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let p = rna_relative(x);
    let texels = rna_texels(p);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    let groups = select(rna_part.channel_groups, 1u, slot == RNA_NONE);
    var first = vec4f(0.0);
    for (var group = 0u; group < groups; group++) {
        let features = rna_features(texels, group);
        first = select(first, features, group == 0u);
        rna_put(select(slot + group, RNA_NONE, slot == RNA_NONE), features);
    }
    rna_put(rna_slot(RNA_BLOCK_POSITION), vec4f(2.0 * p - 1.0, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WO), vec4f(wo, 0.0));
    rna_put(rna_slot(RNA_BLOCK_WI), vec4f(wi, 0.0));
    return first.xyz;
}

// Halfway between wo and wi, \`instead\` where they are opposite ("In float32": the difference of
// their lengths goes).
fn rna_halfway(wo: vec3f, wi: vec3f, instead: vec3f) -> vec3f {
    var s = wi + wo;
    let e = wi - wo;
    let square = dot(e, e);
    if dot(s, s) < square {
        s -= e * (dot(s, e) / square);
    }
    let size = length(s);
    if size < 1e-6 {
        return instead;
    }
    return s / size;
}
`,"bvh.wgsl":`// Closest and any hits: a tree over instances, and one in each body's object space. Loops take
// their lengths from the data. Of every hit of a triangle they call
//     fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool
// which opaque.wgsl answers, or a host that knows what lets light through; found: (t, b1, b2).

// Nodes to come back to: of the tree over instances, then of a body's. Private, since a function's own
// array would be set to 0 at every call.
var<private> rna_stack: array<u32, 2u * RNA_STACK>;

fn rna_inverse(d: vec3f) -> vec3f {
    let tiny = select(vec3f(1e-20), vec3f(-1e-20), d < vec3f(0.0));
    return vec3f(1.0) / select(d, tiny, abs(d) < vec3f(1e-20));
}

// Where the ray enters a node's box; RNA_FAR where it does not.
fn rna_enter_node(node: u32, origin: vec3f, inverse: vec3f, near: f32, far: f32) -> f32 {
    let a = (rna_nodes[node].low - origin) * inverse;
    let b = (rna_nodes[node].high - origin) * inverse;
    let lower = min(a, b);
    let upper = max(a, b);
    let enter = max(max(lower.x, lower.y), max(lower.z, near));
    let leave = min(min(upper.x, upper.y), min(upper.z, far));
    return select(RNA_FAR, enter, enter <= leave * 1.0000005);
}

// The next node down, nearer child first; RNA_NOTHING where none is hit.
fn rna_descend(
    node: u32, ray: RnaRay, inverse: vec3f, far: f32, top: ptr<function, u32>,
) -> u32 {
    let left = node + 1u;
    let right = rna_nodes[node].child;
    let to_left = rna_enter_node(left, ray.origin, inverse, ray.near, far);
    let to_right = rna_enter_node(right, ray.origin, inverse, ray.near, far);
    if to_left >= RNA_FAR && to_right >= RNA_FAR {
        return RNA_NOTHING;
    }
    if to_left >= RNA_FAR {
        return right;
    }
    if to_right >= RNA_FAR {
        return left;
    }
    let left_first = to_left <= to_right;
    rna_stack[*top] = select(left, right, left_first);
    *top += 1u;
    return select(right, left, left_first);
}

// Tests a primitive; whether it is hit nearer than \`hit\`, which is then set to it.
fn rna_meet(primitive: u32, ray: RnaRay, own_strand: u32, hit: ptr<function, RnaHit>) -> bool {
    let record = rna_primitives[primitive];
    let line = RnaRay(ray.origin, ray.near, ray.direction, (*hit).t);
    if !rna_is_segment(record) {
        let found = rna_meet_triangle(
            line, rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
        );
        if found.x >= RNA_FAR || !rna_stops(primitive, ray, found, (*hit).instance) {
            return false;
        }
        *hit = RnaHit(found.x, (*hit).instance, primitive, found.y, found.z, vec3f(0.0));
        return true;
    }
    if rna_strand(record) == own_strand {
        return false;
    }
    let entry = rna_meet_segment(line, record);
    if entry.t >= RNA_FAR {
        return false;
    }
    *hit = RnaHit(entry.t, (*hit).instance, primitive, 0.0, 0.0, entry.normal);
    return true;
}

// The closest hit of a body below \`root\`, ray in its object space, nearer than \`hit\`; with \`any\`
// the first that is found.
fn rna_trace_body(
    root: u32, ray: RnaRay, own_strand: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    var top = RNA_STACK;
    var node = root;
    var found = false;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, (*hit).t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_meet(first + k, ray, own_strand, hit) {
                found = true;
                if any {
                    return true;
                }
            }
        }
        if next == RNA_NOTHING {
            if top == RNA_STACK {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return found;
}

// Tests an instance, world ray; \`own\` is passed through, and so is what \`rays\` has no bit of.
fn rna_trace_instance(
    instance: u32, ray: RnaRay, own: u32, rays: u32, any: bool, hit: ptr<function, RnaHit>,
) -> bool {
    if instance == own || (rna_instances[instance].rays & rays) == 0u {
        return false;
    }
    let scale = rna_instances[instance].scale;
    let local = rna_to_object(ray, instance);
    var nearest = *hit;
    nearest.instance = instance;
    nearest.t = min((*hit).t / scale, RNA_FAR);
    if !rna_trace_body(rna_instances[instance].root, local, RNA_NOTHING, any, &nearest) {
        return false;
    }
    nearest.t *= scale;
    *hit = nearest;
    return true;
}

// The closest hit in the world, or with \`any\` some hit.
fn rna_trace(ray: RnaRay, own: u32, rays: u32, any: bool) -> RnaHit {
    var hit = rna_miss(ray.far);
    var top = 0u;
    var node = 0u;
    let inverse = rna_inverse(ray.direction);
    loop {
        let count = rna_nodes[node].count;
        var next = RNA_NOTHING;
        if count == 0u {
            next = rna_descend(node, ray, inverse, hit.t, &top);
        }
        let first = rna_nodes[node].child;
        for (var k = 0u; k < count; k++) {
            if rna_trace_instance(first + k, ray, own, rays, any, &hit) && any {
                return hit;
            }
        }
        if next == RNA_NOTHING {
            if top == 0u {
                break;
            }
            top -= 1u;
            next = rna_stack[top];
        }
        node = next;
    }
    return hit;
}
`,"decoder.wgsl":`// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile. Drivers inline each call: one call, in a loop, compiles
// sooner than two.

struct RnaTransport {
    visible: vec3f, // of emission: what is emitted
    shadowed: vec3f,
}

// Clip, and gain and offset of an int8 decoder.
fn rna_prepare_queries() {
    for (var k = 0u; k < rna_part.query_groups; k++) {
        var x = clamp(rna_values[k], vec4f(rna_part.query_low), vec4f(rna_part.query_high));
        if rna_part.gain != RNA_NONE {
            x = x * rna_weight(rna_part.gain + k)
                + rna_weight(rna_part.gain + rna_part.query_groups + k);
        }
        rna_values[k] = x;
    }
}

// QuantizeLinear: whole numbers from 0 to 255, halves to even.
fn rna_quantize(layer: RnaLayer, source: u32) {
    for (var k = 0u; k < layer.inputs; k++) {
        let x = rna_values[source + k] / layer.int8_step;
        rna_values[source + k] = clamp(round(x), vec4f(0.0), vec4f(255.0));
    }
}

// What a group of columns adds to the sums of an output group, with its block at \`at\`.
fn rna_block(x: vec4f, at: u32) -> vec4f {
    return x.x * rna_weight(at) + x.y * rna_weight(at + 1u)
        + x.z * rna_weight(at + 2u) + x.w * rna_weight(at + 3u);
}

fn rna_finish(layer: RnaLayer, o: u32, sums: vec4f, place: u32) {
    var y = sums + rna_weight(layer.bias + o);
    if layer.int8_step != 0.0 {
        y *= rna_weight(layer.units + o);
    }
    if layer.relu == 1u {
        y = max(y, vec4f(0.0));
    }
    rna_values[place + o] = y;
}

// Four output groups at a time: a value is read once for 16 sums. Sums of int8 layers are whole
// and below 2^24: exact.
fn rna_run_layer(layer: RnaLayer, source: u32, place: u32) {
    if layer.int8_step != 0.0 {
        rna_quantize(layer, source);
    }
    let stride = 4u * layer.inputs;
    var o = 0u;
    for (; o + 4u <= layer.outputs; o += 4u) {
        var a = vec4f(0.0);
        var b = vec4f(0.0);
        var c = vec4f(0.0);
        var d = vec4f(0.0);
        var at = layer.weights + o * stride;
        for (var k = 0u; k < layer.inputs; k++) {
            let x = rna_values[source + k];
            a += rna_block(x, at);
            b += rna_block(x, at + stride);
            c += rna_block(x, at + 2u * stride);
            d += rna_block(x, at + 3u * stride);
            at += 4u;
        }
        rna_finish(layer, o, a, place);
        rna_finish(layer, o + 1u, b, place);
        rna_finish(layer, o + 2u, c, place);
        rna_finish(layer, o + 3u, d, place);
    }
    for (; o < layer.outputs; o++) {
        var sums = vec4f(0.0);
        for (var k = 0u; k < layer.inputs; k++) {
            sums += rna_block(rna_values[source + k], layer.weights + o * stride + 4u * k);
        }
        rna_finish(layer, o, sums, place);
    }
}

// What the last layer gives, clipped, as radiance.
fn rna_expand(source: u32) {
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
}

// The place of the results in rna_values, from the queries there.
fn rna_run_decoder() -> u32 {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k <= rna_part.layer_count; k++) {
        var layer = rna_part.matrix;
        if k < rna_part.layer_count {
            layer = rna_part.layers[k];
        } else {
            rna_expand(source);
        }
        if layer.inputs == 0u {
            break; // there is no matrix
        }
        rna_run_layer(layer, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    return source;
}

// The colours for the queries in rna_values.
fn rna_decode() -> RnaTransport {
    let source = rna_run_decoder();
    let first = rna_values[source];
    let second = rna_values[source + 1u];
    let visible = max(first.xyz, vec3f(0.0));
    return RnaTransport(visible, max(vec3f(first.w, second.xy), vec3f(0.0)));
}
`,"environment_lobes.wgsl":`// Lobes of the transport for light from whole environments: spec/RNA.md, 12, RNA_environment. Whoever composes the files
// declares RNA_LOBES, RNA_IS_FIBER (1 or 0) and RNA_VISIBILITY_GROUPS: 4, or 0 of parts without harmonics.

const RNA_AXIS_SHIFT: f32 = 8.0;
const RNA_LEAST_KAPPA: f32 = 0.01;
const RNA_WIDE: f32 = 2.0; // kappa of a lobe that the decoder leaves as it is, of the first half
const RNA_SHARP: f32 = 10.0; // and of the rest

struct RnaLobe {
    amplitude: vec3f,
    kappa: f32,
    axis: vec3f, // its length is kappa, but for those below RNA_LEAST_KAPPA
}

// Runs the decoder. m: the mirror direction. visibility: harmonics of the asset's own, coefficients. The result is where
// rna_lobe finds its values.
fn rna_run_lobes(
    x: vec3f, axis: vec3f, h: f32, wo: vec3f, m: vec3f, visibility: array<vec4f, 4>,
) -> u32 {
    rna_put_queries(x, axis, h, wo, m);
    let first = rna_part.query_groups - RNA_VISIBILITY_GROUPS;
    for (var k = 0u; k < RNA_VISIBILITY_GROUPS; k++) {
        rna_values[first + k] = visibility[k];
    }
    return rna_run_decoder();
}

fn rna_three(place: u32, k: u32) -> vec3f {
    let x = rna_values[place + k / 4u][k % 4u];
    let y = rna_values[place + (k + 1u) / 4u][(k + 1u) % 4u];
    let z = rna_values[place + (k + 2u) / 4u][(k + 2u) % 4u];
    return max(vec3f(x, y, z), vec3f(0.0));
}

// Lobe j. free: the asset's own visibility along m.
fn rna_lobe(place: u32, j: u32, axis: vec3f, wo: vec3f, m: vec3f, free: f32) -> RnaLobe {
    var base = RNA_SHARP * m;
    if j < RNA_LOBES / 2u {
        base = RNA_WIDE * select(axis, -wo, RNA_IS_FIBER == 1u);
    }
    let a = rna_three(place, 9u * j + 6u) - RNA_AXIS_SHIFT + base;
    let amplitude = mix(rna_three(place, 9u * j + 3u), rna_three(place, 9u * j), free);
    return RnaLobe(amplitude, max(length(a), RNA_LEAST_KAPPA), a);
}
`,"evaluate.wgsl":`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<RnaRow>;
@group(1) @binding(1) var<storage, read_write> rna_results: array<vec4f>;
@group(1) @binding(2) var<storage, read> rna_row_count: array<u32>; // [0]

// RNA_COLOURS, 2 of transport and 1 of emission, is declared by whoever composes the files.
fn rna_write(row: u32, result: RnaTransport) {
    rna_results[RNA_COLOURS * row] = vec4f(result.visible, 0.0);
    if RNA_COLOURS == 2u {
        rna_results[2u * row + 1u] = vec4f(result.shadowed, 0.0);
    }
}

@compute @workgroup_size(64)
fn rna_evaluate(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= rna_row_count[0] {
        return;
    }
    let at = rna_rows[row];
    let finite = rna_is_finite(vec4<u32>(at.position, at.h)) && rna_is_finite(vec4<u32>(at.axis, 0u))
        && rna_is_finite(vec4<u32>(at.wo, 0u)) && rna_is_finite(vec4<u32>(at.wi, 0u));
    let a = rna_unit(at.axis);
    let o = rna_unit(at.wo);
    let i = rna_unit(at.wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        result = rna_query(bitcast<vec3f>(at.position), a, bitcast<f32>(at.h), o, i);
    }
    rna_write(row, result);
}
`,"fiber.wgsl":`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, t, h, wo, wi);
    return rna_decode();
}

fn rna_put_queries(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_common_blocks(x, wo, wi);
    rna_fiber_blocks(t, clamp(h, -1.0, 1.0), wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi);
}
`,"fiber_blocks.wgsl":`// Input blocks of fibers alone: spec/RNA.md, 6.3 Input blocks and "In float32".

const RNA_ETA: f32 = 1.55;

// c_o, cos phi and sin phi. Products with t have lost the component along it: t x wo and t x wi
// have the lengths c_o and c_i, and phi is between them.
fn rna_azimuth(t: vec3f, wo: vec3f, wi: vec3f) -> vec3f {
    let o = cross(t, wo);
    let i = cross(t, wi);
    let c_o = length(o);
    let d = c_o * length(i);
    if d < 1e-6 {
        return vec3f(c_o, 1.0, 0.0);
    }
    return vec3f(c_o, clamp(dot(o, i) / d, -1.0, 1.0), clamp(dot(t, cross(o, i)) / d, -1.0, 1.0));
}

// Cosine and sine of twice the angle within 90 degrees that has this sine.
fn rna_doubled(sine: f32) -> vec2f {
    let cosine = sqrt(max(0.0, (1.0 - sine) * (1.0 + sine)));
    return vec2f(1.0 - 2.0 * sine * sine, 2.0 * sine * cosine);
}

// cos(phi - Phi_p) for p = 0, 1, 2, by the addition theorems; each segment turns by -2 g_t - pi.
fn rna_lobes(h: f32, s_o: f32, azimuth: vec3f) -> vec3f {
    let segment = rna_doubled(h * azimuth.x / sqrt(RNA_ETA * RNA_ETA - s_o * s_o));
    let r = rna_doubled(h);
    let tt = vec2f(-r.x * segment.x - r.y * segment.y, r.x * segment.y - r.y * segment.x);
    let trt = vec2f(-tt.x * segment.x - tt.y * segment.y, tt.x * segment.y - tt.y * segment.x);
    let phi = azimuth.yz;
    return vec3f(dot(phi, r), dot(phi, tt), dot(phi, trt));
}

fn rna_fiber_blocks(t: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_TANGENT), vec4f(t, 0.0));
    rna_put(rna_slot(RNA_BLOCK_H), vec4f(h, 0.0, 0.0, 0.0));
    let angles = rna_slot(RNA_BLOCK_FIBER_ANGLES);
    let lobes = rna_slot(RNA_BLOCK_FIBER_LOBES);
    if angles == RNA_NONE && lobes == RNA_NONE {
        return;
    }
    let s_o = dot(t, wo);
    let s_i = dot(t, wi);
    let cone = s_i + s_o;
    let azimuth = rna_azimuth(t, wo, wi);
    if angles != RNA_NONE {
        rna_values[angles] = vec4f(s_i, s_o, cone, log2(cone * cone + 1e-3) / 6.0);
        rna_values[angles + 1u] = vec4f(azimuth.yz, 0.0, 0.0);
    }
    rna_put(lobes, vec4f(rna_lobes(h, s_o, azimuth), 0.0));
}
`,"geometry.wgsl":`// Geometry and rays: spec/RNA.md, 4 Geometry. Trees, triangles and segments of all bodies lie in
// three buffers; instances place the bodies in the world. \`geometry.py\` fills them.

// The tree over instances comes first.
@group(2) @binding(0) var<storage, read> rna_nodes: array<RnaNode>;

@group(2) @binding(1) var<storage, read> rna_primitives: array<RnaPrimitive>;

// Position and, of curves, radius; the fourth number of a mesh's points is the host's.
@group(2) @binding(2) var<storage, read> rna_points: array<vec4f>;

@group(2) @binding(3) var<storage, read> rna_instances: array<RnaInstance>;

const RNA_FAR: f32 = 1e30;
const RNA_STACK: u32 = 48u;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct RnaHit {
    t: f32,
    instance: u32, // RNA_NOTHING for a miss
    primitive: u32,
    b1: f32, // barycentric coordinates of a triangle's second and third corner
    b2: f32,
    normal: vec3f, // outward, of a segment
}

fn rna_miss(far: f32) -> RnaHit {
    return RnaHit(far, RNA_NOTHING, 0u, 0.0, 0.0, vec3f(0.0));
}

fn rna_is_segment(primitive: RnaPrimitive) -> bool {
    return (primitive.tag & RNA_IS_SEGMENT) != 0u;
}

fn rna_surface(primitive: RnaPrimitive) -> u32 {
    return primitive.tag >> RNA_SURFACE_SHIFT;
}

// Of a segment.
fn rna_strand(primitive: RnaPrimitive) -> u32 {
    return primitive.c;
}

// The ray in an instance's object space, where its direction is unit as well.
fn rna_to_object(ray: RnaRay, instance: u32) -> RnaRay {
    let scale = rna_instances[instance].scale;
    return RnaRay(
        rna_object_point(ray.origin, instance),
        ray.near / scale,
        rna_object_direction(ray.direction, instance),
        min(ray.far / scale, RNA_FAR),
    );
}

fn rna_object_point(x: vec3f, instance: u32) -> vec3f {
    let p = vec4f(x, 1.0);
    return vec3f(
        dot(rna_instances[instance].to_object[0], p),
        dot(rna_instances[instance].to_object[1], p),
        dot(rna_instances[instance].to_object[2], p),
    );
}

fn rna_object_direction(d: vec3f, instance: u32) -> vec3f {
    return d.x * rna_instances[instance].rotation[0].xyz
        + d.y * rna_instances[instance].rotation[1].xyz
        + d.z * rna_instances[instance].rotation[2].xyz;
}

fn rna_world_direction(d: vec3f, instance: u32) -> vec3f {
    return vec3f(
        dot(rna_instances[instance].rotation[0].xyz, d),
        dot(rna_instances[instance].rotation[1].xyz, d),
        dot(rna_instances[instance].rotation[2].xyz, d),
    );
}

fn rna_world_point(x: vec3f, instance: u32) -> vec3f {
    return rna_instances[instance].scale * rna_world_direction(x, instance)
        + rna_instances[instance].place;
}
`,"geometry_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NOTHING: u32 = 0xffffffffu;
const RNA_IS_SEGMENT: u32 = 1u;
const RNA_SURFACE_SHIFT: u32 = 1u;
const RNA_HAS_BEFORE: u32 = 1u;
const RNA_HAS_AFTER: u32 = 2u;

struct RnaNode { // 32 bytes
    low: vec3f, // 0
    child: u32, // 12; the right one, the left one is the next node; a leaf's first primitive
    high: vec3f, // 16
    count: u32, // 28; a leaf's primitives; 0 of inner nodes
}

struct RnaPrimitive { // 16 bytes
    a: u32, // 0; point: a triangle's first corner, a segment's start
    b: u32, // 4; second corner; of a segment RNA_HAS_BEFORE and RNA_HAS_AFTER
    c: u32, // 8; third corner; of a segment its strand
    tag: u32, // 12; surface << RNA_SURFACE_SHIFT, and RNA_IS_SEGMENT
}

struct RnaInstance { // 128 bytes
    to_object: array<vec4f, 3>, // 0; rows of the matrix
    rotation: array<vec4f, 3>, // 48; to the world: rows, the fourth column free
    place: vec3f, // 96; in the world
    scale: f32, // 108; to the world
    root: u32, // 112; node
    rays: u32, // 116; bits of those that can hit it
    extent: f32, // 120; largest coordinate of its body
    own: u32, // 124; a number of the host's
}
`,"normal_maps.wgsl":`// The mapped normal of a hit: spec/RNA.md, 4.5 Normal maps. The host declares
//     fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f
// which gives the two numbers from 0 to 255 of a texel.

// at modulo sides. Vulkan leaves \`%\` of a negative number undefined, and drivers differ.
fn rna_repeated(at: vec2<i32>, sides: vec2<i32>) -> vec2<i32> {
    let left = at - at / sides * sides;
    return select(left, left + sides, left < vec2<i32>(0));
}

// x and y of a map of \`size\` (columns, rows) at uv; it repeats.
fn rna_map_value(map: u32, size: vec2<u32>, uv: vec2f) -> vec2f {
    let at = uv * vec2f(size) - 0.5;
    let low = floor(at);
    let part = at - low;
    let sides = vec2<i32>(size);
    let i = vec2<u32>(rna_repeated(vec2<i32>(low), sides));
    let j = vec2<u32>(rna_repeated(vec2<i32>(low) + 1, sides));
    let upper = mix(rna_map_texel(map, i.y, i.x), rna_map_texel(map, i.y, j.x), part.x);
    let lower = mix(rna_map_texel(map, j.y, i.x), rna_map_texel(map, j.y, j.x), part.x);
    return (mix(upper, lower, part.y) - 127.0) / 127.0;
}

// n: interpolated normal; p: corners; uv: their texture coordinates; b: barycentric coordinates.
fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    let e1 = p[1] - p[0];
    let e2 = p[2] - p[0];
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = sign(area);
    let along_u = (d2.y * e1 - d1.y * e2) * side;
    let along_v = (d1.x * e2 - d2.x * e1) * side;
    let t = along_u - dot(along_u, n) * n;
    if area == 0.0 || length(t) <= 1e-6 * length(along_u) {
        return n;
    }
    let tangent = normalize(t);
    var bitangent = cross(n, tangent);
    if dot(bitangent, along_v) > 0.0 {
        bitangent = -bitangent;
    }
    let xy = rna_map_value(map, size, uv * b);
    let z = sqrt(max(0.0, 1.0 - dot(xy, xy)));
    let m = xy.x * tangent + xy.y * bitangent + z * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}
`,"part.wgsl":`// The bindings of one part of a tier: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;
`,"part_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const RNA_NONE: u32 = 0xffffffffu;
const RNA_FLOAT32: u32 = 0u;
const RNA_FLOAT16: u32 = 1u;
const RNA_INT8: u32 = 2u;
const RNA_BLOCK_FEATURES: u32 = 0u;
const RNA_BLOCK_POSITION: u32 = 1u;
const RNA_BLOCK_NORMAL: u32 = 2u;
const RNA_BLOCK_TANGENT: u32 = 3u;
const RNA_BLOCK_H: u32 = 4u;
const RNA_BLOCK_WO: u32 = 5u;
const RNA_BLOCK_WI: u32 = 6u;
const RNA_BLOCK_HALF_VECTOR: u32 = 7u;
const RNA_BLOCK_HIGHLIGHT: u32 = 8u;
const RNA_BLOCK_LEARNED_NORMAL: u32 = 9u;
const RNA_BLOCK_FIBER_ANGLES: u32 = 10u;
const RNA_BLOCK_FIBER_LOBES: u32 = 11u;
const RNA_CHANNEL_GROUPS: u32 = 16u;

struct RnaLayer { // 32 bytes
    inputs: u32, // 0; groups of 4 columns
    outputs: u32, // 4
    weights: u32, // 8; place of [outputs][inputs][4] vec4f
    bias: u32, // 12; place of [outputs] vec4f
    units: u32, // 16; place of [outputs] vec4f of an int8 layer: what a sum of 1 means
    relu: u32, // 20; 1: negative results are 0
    int8_step: f32, // 24; of an int8 layer: what 1 means in its inputs; else 0
    reserved: u32, // 28
}

struct RnaPart { // 1936 bytes
    low: vec3f, // 0; smallest corner of the bounds
    resolution: u32, // 12
    high: vec3f, // 16
    channel_groups: u32, // 28; channels / 4, rounded up
    query_groups: u32, // 32; of the decoder's input
    layer_count: u32, // 36
    plane_precision: u32, // 40; RNA_FLOAT32, RNA_FLOAT16 or RNA_INT8
    gain: u32, // 44; place of [query_groups] gains, then the offsets; RNA_NONE without
    query_low: f32, // 48; the decoder's first Clip
    query_high: f32, // 52
    top: f32, // 56; of the Clip before Exp
    unit: f32, // 60; result = (exp(x) - 1) unit, or times the matrix; then 1
    matrix: RnaLayer, // 64; [n, 6], with a bias of 0; all 0 without
    scales: array<vec4f, 48>, // 96; of int8 planes, [plane][group]
    layers: array<RnaLayer, 32>, // 864
    slots: array<vec4<u32>, 3>, // 1888; first group of each block, RNA_NONE for none: see rna_slot
}
`,"planes.wgsl":`// Features of a position: spec/RNA.md, 5 Planes.

fn rna_plane_word(plane: u32, at: u32) -> u32 {
    switch plane {
        case 0u: { return rna_plane_xy[at]; }
        case 1u: { return rna_plane_yz[at]; }
        default: { return rna_plane_zx[at]; }
    }
}

// The value of a float16; drivers may take subnormal ones for 0, the format does not.
fn rna_from_float16(bits: u32) -> f32 {
    let exponent = (bits >> 10u) & 31u;
    let mantissa = bits & 1023u;
    let size = select(
        bitcast<f32>(((exponent + 112u) << 23u) | (mantissa << 13u)),
        f32(mantissa) * 0x1p-24f,
        exponent == 0u,
    );
    return select(size, -size, (bits & 0x8000u) != 0u);
}

// Channels 4 group to 4 group + 3 of a texel; texel = row * resolution + column.
fn rna_texel(plane: u32, texel: u32, group: u32) -> vec4f {
    let at = texel * rna_part.channel_groups + group;
    switch rna_part.plane_precision {
        case RNA_FLOAT32: {
            return vec4f(
                bitcast<f32>(rna_plane_word(plane, 4u * at)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 1u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 2u)),
                bitcast<f32>(rna_plane_word(plane, 4u * at + 3u)),
            );
        }
        case RNA_FLOAT16: {
            let a = rna_plane_word(plane, 2u * at);
            let b = rna_plane_word(plane, 2u * at + 1u);
            return vec4f(
                rna_from_float16(a & 0xffffu),
                rna_from_float16(a >> 16u),
                rna_from_float16(b & 0xffffu),
                rna_from_float16(b >> 16u),
            );
        }
        default: {
            let word = bitcast<i32>(rna_plane_word(plane, at));
            let integers = vec4<i32>(word << 24u, word << 16u, word << 8u, word) >> vec4<u32>(24u);
            return vec4f(integers) * rna_part.scales[plane * RNA_CHANNEL_GROUPS + group];
        }
    }
}

// Where a position is on one axis: texel, the next one, and the fraction between them.
struct RnaTexel {
    low: vec3<u32>,
    high: vec3<u32>,
    fraction: vec3f,
}

fn rna_texels(p: vec3f) -> RnaTexel {
    let last = f32(rna_part.resolution - 1u);
    let s = clamp(p * f32(rna_part.resolution) - 0.5, vec3f(0.0), vec3f(last));
    let below = floor(s);
    let low = vec3<u32>(below);
    let high = min(low + vec3<u32>(1u), vec3<u32>(rna_part.resolution - 1u));
    return RnaTexel(low, high, s - below);
}

// x: (texel, next) along the columns, y: along the rows.
fn rna_bilinear(
    plane: u32, group: u32, columns: vec2<u32>, rows: vec2<u32>, a: f32, b: f32,
) -> vec4f {
    let lower = rows.x * rna_part.resolution;
    let upper = rows.y * rna_part.resolution;
    let at_lower = (1.0 - a) * rna_texel(plane, lower + columns.x, group)
        + a * rna_texel(plane, lower + columns.y, group);
    let at_upper = (1.0 - a) * rna_texel(plane, upper + columns.x, group)
        + a * rna_texel(plane, upper + columns.y, group);
    return (1.0 - b) * at_lower + b * at_upper;
}

// Position as a fraction of the bounds, clamped to them.
fn rna_relative(x: vec3f) -> vec3f {
    let inside = clamp(x, rna_part.low, rna_part.high);
    return clamp((inside - rna_part.low) / (rna_part.high - rna_part.low), vec3f(0.0), vec3f(1.0));
}

// Channels 4 group to 4 group + 3 of the features at p, in [0, 1].
fn rna_features(t: RnaTexel, group: u32) -> vec4f {
    var sum = vec4f(0.0);
    for (var plane = 0u; plane < 3u; plane++) {
        let next = (plane + 1u) % 3u;
        let columns = vec2<u32>(t.low[plane], t.high[plane]);
        let rows = vec2<u32>(t.low[next], t.high[next]);
        sum += rna_bilinear(plane, group, columns, rows, t.fraction[plane], t.fraction[next]);
    }
    return sum;
}
`,"render/bumps.wgsl":`// Normals of materials with the relief of a normal texture: rna_render/materials/bumps.py.

const MIN_MIRROR_COSINE: f32 = 0.01;

fn unit_or_zero(v: vec3f) -> vec3f {
    let size = length(v);
    return select(vec3f(0.0), v / max(size, 1e-30), size > 0.0);
}

fn point_tangent(base: u32, point: u32) -> vec4f {
    let at = base + 4u * point;
    return bitcast<vec4f>(vec4<u32>(images[at], images[at + 1u], images[at + 2u], images[at + 3u]));
}

// The file's tangent, interpolated, and the bitangent's sign; a sign of 0 where a corner has none.
fn given_tangent(record: RnaPrimitive, b: vec3f) -> vec4f {
    let base = surface_tangents(rna_surface(record));
    if base == NONE {
        return vec4f(0.0);
    }
    let first = point_tangent(base, record.a);
    let second = point_tangent(base, record.b);
    let third = point_tangent(base, record.c);
    let all_there = first.w != 0.0 && second.w != 0.0 && third.w != 0.0;
    let t = b.x * first.xyz + b.y * second.xyz + b.z * third.xyz;
    return vec4f(t, select(0.0, first.w, all_there));
}

// The direction of u on the triangle, and the sign that makes the bitangent go against v.
fn derived_tangent(record: RnaPrimitive, uv: mat3x2f, n: vec3f) -> vec4f {
    let p = rna_points[record.a].xyz;
    let e1 = rna_points[record.b].xyz - p;
    let e2 = rna_points[record.c].xyz - p;
    let d1 = uv[1] - uv[0];
    let d2 = uv[2] - uv[0];
    let area = d1.x * d2.y - d2.x * d1.y;
    let side = select(1.0, -1.0, area < 0.0);
    let along_u = side * (d2.y * e1 - d1.y * e2);
    let along_v = side * (d1.x * e2 - d2.x * e1);
    let sign = select(1.0, -1.0, dot(cross(n, along_u), along_v) > 0.0);
    return vec4f(along_u, select(0.0, sign, area != 0.0));
}

// m, or the nearest normal that mirrors o above the surface; g is on o's side.
fn kept_above(m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let mirror = 2.0 * dot(m, o) * m - o;
    let missing = min(0.9 * dot(g, o), MIN_MIRROR_COSINE) - dot(g, mirror);
    if missing <= 0.0 {
        return m;
    }
    return unit_or_zero(o + unit_or_zero(mirror + missing * g));
}

// The normal m with the relief of its material's normal texture; g, o: geometric normal and unit
// direction to the viewer.
fn bumped_normal(record: RnaPrimitive, b1: f32, b2: f32, m: vec3f, g: vec3f, o: vec3f) -> vec3f {
    let texture = surface_textures(rna_surface(record), RELIEF);
    if texture == NONE {
        return m;
    }
    let uvs = corner_uvs(record, (image_of(texture).form >> 5u) & 1u);
    let b = weights_of(b1, b2);
    var tangent = given_tangent(record, b);
    if tangent.w == 0.0 {
        tangent = derived_tangent(record, uvs, m);
    }
    let t = unit_or_zero(tangent.xyz - dot(tangent.xyz, m) * m);
    if tangent.w == 0.0 || dot(t, t) == 0.0 {
        return m;
    }
    let scale = surface_normal_scale(rna_surface(record));
    let relief = 2.0 * texture_value(texture, uvs * b) - 1.0;
    let bitangent = tangent.w * cross(m, t);
    let bent = unit_or_zero(relief.z * m + scale * (relief.x * t + relief.y * bitangent));
    // All on the side of the surface that o is on, and back.
    let side = select(1.0, -1.0, dot(g, o) < 0.0);
    let own = select(-side, side, dot(m, g) >= 0.0);
    return own * kept_above(own * bent, side * g, o);
}
`,"render/directions.wgsl":`// Directions about an axis.

const SPHERE_PDF: f32 = 1.0 / (4.0 * PI);

struct Tangents {
    s: vec3f,
    t: vec3f,
}

// Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
fn tangents_of(n: vec3f) -> Tangents {
    let sign = select(1.0, -1.0, n.z < 0.0);
    let c = -1.0 / (sign + n.z);
    let d = n.x * n.y * c;
    return Tangents(
        vec3f(1.0 + sign * n.x * n.x * c, sign * d, -sign * n.x),
        vec3f(d, sign + n.y * n.y * c, -n.y),
    );
}

fn about(axis: vec3f, sine: f32, cosine: f32, turns: f32) -> vec3f {
    let frame_of = tangents_of(axis);
    let phi = 2.0 * PI * turns;
    return sine * cos(phi) * frame_of.s + sine * sin(phi) * frame_of.t + cosine * axis;
}

fn along_axis(axis: vec3f, cosine: f32, turns: f32) -> vec3f {
    return about(axis, sqrt(max(0.0, 1.0 - cosine * cosine)), cosine, turns);
}

// Cosine to the axis of a von Mises-Fisher direction.
fn fisher_cosine(u: f32, kappa: f32) -> f32 {
    return max(-1.0, 1.0 + log(u + (1.0 - u) * exp(-2.0 * kappa)) / kappa);
}

fn fisher_pdf(cosine: f32, kappa: f32) -> f32 {
    return kappa * exp(kappa * (cosine - 1.0)) / (2.0 * PI * (1.0 - exp(-2.0 * kappa)));
}

// Uniform within a cone about a unit axis, by 1 - cos of the angle to its rim.
fn cone_direction(axis: vec3f, one_minus_cosine: f32, u: vec2f) -> vec3f {
    let height = u.x * one_minus_cosine;
    return about(axis, sqrt(max(0.0, height * (2.0 - height))), 1.0 - height, u.y);
}
`,"render/environment.wgsl":`// An equirectangular image: see rna_render/lights/equirectangular.py and image_kernels.py, which this follows. In \`images\`
// a light has texels (h, w, 3), heights (h + 1), running sums of rows (h + 2) and of each row's cells
// (h + 1, w + 1).

struct Cell {
    corners: mat4x3f,
    luminances: vec4f,
}

fn image_float(at: u32) -> f32 {
    return bitcast<f32>(images[at]);
}

fn luminance(c: vec3f) -> f32 {
    return dot(c, vec3f(0.2126, 0.7152, 0.0722));
}

fn image_size(light: u32) -> vec2<u32> {
    return vec2<u32>(u32(image_rows(light)), u32(image_columns(light)));
}

fn image_texel(light: u32, row: u32, column: u32) -> vec3f {
    let at = image_texels(light) + 3u * (row * image_size(light).y + column);
    return vec3f(image_float(at), image_float(at + 1u), image_float(at + 2u));
}

fn image_cell(light: u32, row: u32, column: u32) -> Cell {
    let size = image_size(light);
    let upper = max(row, 1u) - 1u;
    let lower = min(row, size.x - 1u);
    let right = select(0u, column + 1u, column + 1u < size.y);
    let a = image_texel(light, upper, column);
    let b = image_texel(light, upper, right);
    let c = image_texel(light, lower, column);
    let d = image_texel(light, lower, right);
    return Cell(
        mat4x3f(a, b, c, d), vec4f(luminance(a), luminance(b), luminance(c), luminance(d)),
    );
}

fn in_cell(cell: Cell, x: f32, y: f32) -> vec3f {
    return cell.corners * vec4f((1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y);
}

// The interval of running sums from \`at\` on, \`count\` of them, that a value is in, by bisection.
fn interval(at: u32, count: u32, value: f32) -> u32 {
    var low = 0u;
    var high = count;
    while high - low > 1u {
        let middle = (low + high) / 2u;
        if image_float(at + middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

fn place_within(at: u32, k: u32, value: f32) -> f32 {
    let size = image_float(at + k + 1u) - image_float(at + k);
    if size <= 0.0 {
        return 0.0;
    }
    return clamp((value - image_float(at + k)) / size, 0.0, 0.99999994);
}

// A place in [0, 1] with density in proportion to a line from a to b.
fn sample_linear(a: f32, b: f32, u: f32) -> f32 {
    let root = sqrt(max(a * a + u * (b * b - a * a), 0.0));
    if a + root <= 0.0 {
        return u;
    }
    return u * (a + b) / (a + root);
}

fn image_density(light: u32, row: u32, sine: f32, here: f32, mean_here: f32) -> f32 {
    let total = image_total(light);
    let mean = image_mean(light);
    if total <= 0.0 {
        return 0.0;
    }
    let size = image_size(light);
    var pdf = here * f32(size.y) / (2.0 * PI * total);
    if mean > 0.0 {
        pdf *= max(mean_here - mean, 0.0) / max(mean_here, 1e-30);
    }
    if row > 0u && row < size.x {
        let height = image_float(image_heights(light) + row);
        pdf *= height * f32(size.x) / (PI * max(sine, 1e-30));
    }
    return pdf;
}

// Where in a cell of that row, down from the middles above.
fn sample_down(light: u32, row: u32, l: vec4f, u: f32) -> f32 {
    let h = image_size(light).x;
    let height = image_float(image_heights(light) + row);
    let cap = 2.0 * asin(sqrt(u * height / 2.0)) / PI * f32(h);
    if row == 0u {
        return cap + 0.5;
    }
    if row == h {
        return 0.5 - cap;
    }
    return sample_linear(l.x + l.y, l.z + l.w, u);
}

fn sample_image(light: u32, u: vec2f) -> LightSample {
    let size = image_size(light);
    let rows = image_row_sums(light);
    let down = u.y * image_float(rows + size.x + 1u);
    let row = interval(rows, size.x + 1u, down);
    let columns = image_column_sums(light) + row * (size.y + 1u);
    let across = u.x * image_float(columns + size.y);
    let column = interval(columns, size.y, across);
    let cell = image_cell(light, row, column);
    let l = cell.luminances;
    let y = sample_down(light, row, l, place_within(rows, row, down));
    let left = mix(l.x, l.z, y);
    let x = sample_linear(left, mix(l.y, l.w, y), place_within(columns, column, across));
    let theta = PI * (f32(row) - 0.5 + y) / f32(size.x);
    let phi = 2.0 * PI * ((f32(column) + 0.5 + x) / f32(size.y) - 0.5);
    let sine = sin(theta);
    let away = sine * sin(phi);
    let along = -sine * cos(phi);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let wi = vec3f(turn.x * away + turn.y * along, cos(theta), turn.x * along - turn.y * away);
    let radiance = in_cell(cell, x, y);
    let pdf = image_density(light, row, sine, luminance(radiance), dot(l, vec4f(0.25)));
    return light_sample(wi, RNA_FAR, light_colour(light) * radiance, pdf);
}

fn look_up_image(light: u32, d: vec3f) -> LightHit {
    let size = image_size(light);
    let turn = vec2f(image_turn_cosine(light), image_turn_sine(light));
    let x = turn.x * d.x - turn.y * d.z;
    let z = turn.y * d.x + turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    var azimuth = 0.0;
    if sine > 0.0 {
        azimuth = atan2(x, -z);
    }
    let s = (0.5 + azimuth / (2.0 * PI)) * f32(size.y) - 0.5;
    let t = atan2(sine, d.y) / PI * f32(size.x) + 0.5;
    let row = u32(clamp(floor(t), 0.0, f32(size.x)));
    let left = floor(s);
    let column = select(size.y - 1u, u32(max(left, 0.0)), left >= 0.0 && left < f32(size.y));
    let cell = image_cell(light, row, column);
    let radiance = in_cell(cell, s - left, t - f32(row));
    let mean = dot(cell.luminances, vec4f(0.25));
    let pdf = image_density(light, row, sine, luminance(radiance), mean);
    return LightHit(light_colour(light) * radiance, pdf);
}
`,"render/frame.wgsl":`// What all steps of the renderer share: the step's numbers, paths, sums, and tables.

const PI: f32 = 3.14159265358979;
const SHORTER: f32 = 1.0 - 0x1p-13f; // shadow rays end before the light

const DEAD: u32 = 0u;
const ALIVE: u32 = 1u;

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;
@group(0) @binding(2) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> queries: array<PathQueries>;
@group(0) @binding(4) var<storage, read> table: array<vec4f>;
@group(0) @binding(5) var<storage, read> images: array<u32>; // floats of skies, bytes of textures

fn path_number(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.y * groups.x * 64u + id.x;
}

fn add_light(k: u32, light: u32, radiance: vec3f) {
    let at = frame.sums * k;
    sums[at + SUM_BEAUTY] += vec4f(radiance, 0.0);
    let group = light_group(light);
    if group != NONE {
        sums[at + SUM_GROUPS + 2u * group] += vec4f(radiance, 0.0);
    }
}

// Clamped after two or more scatterings.
fn clamped(radiance: vec3f) -> vec3f {
    if frame.clamp <= 0.0 || frame.depth < 2u {
        return radiance;
    }
    let largest = max(max(radiance.x, max(radiance.y, radiance.z)), 1e-30);
    return radiance * (min(frame.clamp, largest) / largest);
}

// Power heuristic: the part of the estimate that belongs to the first way.
fn share(pdf: f32, other: f32) -> f32 {
    if pdf <= 0.0 {
        return 0.0;
    }
    let ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
`,"render/light_shapes.wgsl":`// Lights with a shape, which rays meet.

// The hit, or a nearer one of a light with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    var hit = found;
    for (var light = 0u; light < frame.light_count; light++) {
        let hidden = frame.rays == CAMERA_RAY && !light_is(light, LIGHT_SEEN);
        let t = meet_light(light, RnaRay(ray.origin, ray.near, ray.direction, hit.t));
        if !hidden && t < RNA_FAR && (hit.instance == RNA_NOTHING || t < hit.t) {
            hit = rna_miss(t);
            hit.instance = IS_LIGHT | light;
        }
    }
    return hit;
}
`,"render/lights.wgsl":`// Lights: samples of them, and their radiance and density at hits of rays. They are those of rna_render.lights.

const MAX_PDF: f32 = 1e18;
const MIN_SOLID_ANGLE: f32 = 1e-3; // float32 knows no smaller one to 1e-3 of itself

struct LightSample {
    wi: vec3f,
    distance: f32,
    radiance: vec3f, // of an asset's triangles a factor on what they emit
    pdf: f32,
    primitive: u32, // of triangles
    b1: f32,
    b2: f32,
}

fn light_sample(wi: vec3f, distance: f32, radiance: vec3f, pdf: f32) -> LightSample {
    return LightSample(wi, distance, radiance, pdf, NONE, 0.0, 0.0);
}

// A light along a ray: its radiance, and the density of sampling it there.
struct LightHit {
    radiance: vec3f,
    pdf: f32,
}

// Samples that a light gets at a point, on average.
fn samples_of(light: u32, depth: u32) -> f32 {
    return light_probability(light)[min(depth, 3u) - 1u];
}

fn light_is(light: u32, flag: u32) -> bool {
    return (light_flags(light) & flag) != 0u;
}

// Of points of a plane: per_area, seen along d; 0 from behind.
fn flat_pdf(point: vec3f, normal: vec3f, per_area: f32, x: vec3f, d: vec3f) -> f32 {
    let cosine = -dot(d, normal);
    let height = dot(x - point, normal);
    if cosine <= 0.0 || height <= 0.0 {
        return 0.0;
    }
    let t = height / cosine;
    let pdf = per_area * t * t / cosine;
    return select(0.0, pdf, pdf < MAX_PDF);
}

fn edge_angle(x: f32, y: f32, sign: f32, height: f32) -> f32 {
    return atan2(height * sqrt(x * x + y * y + height * height), sign * x * y);
}

// Solid angle of a rectangle from (x0, y0) to (x1, y1), and the sum k of Ure\xF1a, Fajardo and King,
// An Area-Preserving Parametrization for Spherical Rectangles (EGSR 2013), section 5.
fn solid_angle(e: vec4f, height: f32) -> vec2f {
    let k = 2.0 * PI - edge_angle(e.x, e.w, 1.0, height) - edge_angle(e.x, e.z, -1.0, height);
    let right = edge_angle(e.y, e.z, 1.0, height) + edge_angle(e.y, e.w, -1.0, height);
    return vec2f(right - k, k);
}

// Edges x0, x1, y0, y1 of a rectangle as seen from x.
fn rectangle_edges(light: u32, from_place: vec3f) -> vec4f {
    let a = dot(from_place, rectangle_frame(light)[0]);
    let b = dot(from_place, rectangle_frame(light)[1]);
    let half = rectangle_half(light);
    return vec4f(-half.x - a, half.x - a, -half.y - b, half.y - b);
}

fn rectangle_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let half = rectangle_half(light);
    let f = rectangle_frame(light);
    let flat = flat_pdf(f[3], f[2], 0.25 / (half.x * half.y), x, d);
    let height = dot(x - f[3], f[2]);
    let angle = solid_angle(rectangle_edges(light, x - f[3]), max(height, 1e-30)).x;
    if flat == 0.0 || angle < MIN_SOLID_ANGLE {
        return flat;
    }
    return 1.0 / angle;
}

fn rectangle_point(e: vec4f, height: f32, u: vec2f) -> vec2f {
    let angle = solid_angle(e, height);
    if angle.x < MIN_SOLID_ANGLE {
        return mix(e.xz, e.yw, u);
    }
    let b0 = -e.z / sqrt(height * height + e.z * e.z);
    let b1 = e.w / sqrt(height * height + e.w * e.w);
    let turn = u.x * angle.x + angle.y;
    let sine = sin(turn);
    let f = (cos(turn) * b0 - b1) / select(sine, 1e-20, abs(sine) < 1e-20);
    let c = clamp(select(-1.0, 1.0, f >= 0.0) / sqrt(f * f + b0 * b0), -1.0, 1.0);
    let x = clamp(c * height / sqrt(max(1.0 - c * c, 1e-20)), e.x, e.y);
    let squared = x * x + height * height;
    let h0 = e.z / sqrt(squared + e.z * e.z);
    let h1 = e.w / sqrt(squared + e.w * e.w);
    let h = h0 + u.y * (h1 - h0);
    let y = h * sqrt(squared / max(1.0 - h * h, 1e-20));
    return vec2f(x, clamp(y, e.z, e.w));
}

// Shirley and Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
fn concentric(u: vec2f) -> vec2f {
    let a = 2.0 * u - 1.0;
    if a.x == 0.0 && a.y == 0.0 {
        return vec2f(0.0);
    }
    if abs(a.x) > abs(a.y) {
        let phi = PI / 4.0 * (a.y / a.x);
        return a.x * vec2f(cos(phi), sin(phi));
    }
    let phi = PI / 2.0 - PI / 4.0 * (a.x / a.y);
    return a.y * vec2f(cos(phi), sin(phi));
}

// 1 - cos of the angular radius of a sphere light; 0 from within.
fn sphere_cone(light: u32, x: vec3f) -> f32 {
    let to_centre = sphere_centre(light) - x;
    let radius = sphere_radius(light);
    let squared = dot(to_centre, to_centre);
    if squared <= radius * radius {
        return 0.0;
    }
    let sin2 = radius * radius / squared;
    return sin2 / (1.0 + sqrt(1.0 - sin2));
}

fn shape_pdf(light: u32, x: vec3f, d: vec3f) -> f32 {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        return rectangle_pdf(light, x, d);
    }
    if kind == DISK {
        let radius = disk_radius(light);
        let per_area = 1.0 / (PI * radius * radius);
        return flat_pdf(disk_frame(light)[3], disk_frame(light)[2], per_area, x, d);
    }
    let cone = sphere_cone(light, x);
    return select(0.0, 1.0 / (2.0 * PI * max(cone, 1e-18)), cone > 0.0);
}

// A point of a shape, relative to x.
fn shape_point(light: u32, x: vec3f, u: vec2f) -> vec3f {
    let kind = light_kind(light);
    if kind == RECTANGLE {
        let f = rectangle_frame(light);
        let height = dot(x - f[3], f[2]);
        if height <= 0.0 {
            return f[3] - x;
        }
        let p = rectangle_point(rectangle_edges(light, x - f[3]), height, u);
        return p.x * f[0] + p.y * f[1] - height * f[2];
    }
    if kind == DISK {
        let f = disk_frame(light);
        let p = disk_radius(light) * concentric(u);
        return f[3] + p.x * f[0] + p.y * f[1] - x;
    }
    let to_centre = sphere_centre(light) - x;
    let wi = cone_direction(normalize(to_centre), sphere_cone(light, x), u);
    let along = dot(to_centre, wi);
    let rest = to_centre - along * wi;
    let radius = sphere_radius(light);
    return (along - sqrt(max(0.0, radius * radius - dot(rest, rest)))) * wi;
}

fn point_light(light: u32, x: vec3f) -> LightSample {
    let way = point_place(light) - x;
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let wi = way / r;
    let cosine = -dot(wi, point_axis(light));
    let inner = point_cos_inner(light);
    let outer = point_cos_outer(light);
    var factor = 1.0;
    if cosine < inner {
        let t = clamp((cosine - outer) / max(inner - outer, 1e-20), 0.0, 1.0);
        factor = t * t * (3.0 - 2.0 * t);
    }
    let pdf = select(0.0, 1.0, factor > 0.0);
    return light_sample(wi, r, factor / (r * r) * light_colour(light), pdf);
}

fn sample_light(light: u32, x: vec3f, u: vec2f) -> LightSample {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return sample_image(light, u);
    }
    if kind == UNIFORM {
        return light_sample(
            cone_direction(vec3f(0.0, 0.0, 1.0), 2.0, u), RNA_FAR, colour, SPHERE_PDF,
        );
    }
    if kind == SUN {
        let cone = sun_one_minus_cosine(light);
        let wi = cone_direction(sun_axis(light), cone, u);
        return light_sample(wi, RNA_FAR, colour, 1.0 / (2.0 * PI * cone));
    }
    if kind == DIRECTIONAL {
        return light_sample(directional_axis(light), RNA_FAR, colour, 1.0);
    }
    if kind == TRIANGLES {
        return sample_triangles(light, x, u);
    }
    if kind == POINT {
        return point_light(light, x);
    }
    let way = shape_point(light, x, u);
    let r = length(way);
    if r <= 0.0 {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    return light_sample(way / r, r, colour, shape_pdf(light, x, way / r));
}

// An infinite light along d.
fn environment_along(light: u32, d: vec3f) -> LightHit {
    let kind = light_kind(light);
    let colour = light_colour(light);
    if kind == IMAGE {
        return look_up_image(light, d);
    }
    if kind == UNIFORM {
        return LightHit(colour, SPHERE_PDF);
    }
    if kind == SUN {
        let off = d - sun_axis(light);
        let cone = sun_one_minus_cosine(light);
        if dot(off, off) <= 2.0 * cone {
            return LightHit(colour, 1.0 / (2.0 * PI * cone));
        }
    }
    return LightHit(vec3f(0.0), 0.0);
}

// Where a ray meets the plane of a flat light; RNA_FAR where it is along it.
fn meet_plane(f: mat4x3f, ray: RnaRay) -> f32 {
    let down = dot(ray.direction, f[2]);
    if abs(down) < 1e-20 {
        return RNA_FAR;
    }
    return dot(f[3] - ray.origin, f[2]) / down;
}

// The ray's position there, along the light's axes.
fn on_plane(f: mat4x3f, ray: RnaRay, t: f32) -> vec2f {
    let p = ray.origin + t * ray.direction - f[3];
    return vec2f(dot(p, f[0]), dot(p, f[1]));
}

// Where a ray meets the shape of a light; RNA_FAR where it does not.
fn meet_light(light: u32, ray: RnaRay) -> f32 {
    let kind = light_kind(light);
    var t = RNA_FAR;
    if kind == SPHERE {
        let centre = sphere_centre(light);
        let radius = sphere_radius(light);
        t = rna_enter_sphere(ray.origin, ray.direction, centre, radius);
        let from_centre = ray.origin - centre;
        if dot(from_centre, from_centre) < radius * radius && t < RNA_FAR {
            t = -t - 2.0 * dot(from_centre, ray.direction);
        }
    } else if kind == RECTANGLE {
        let f = rectangle_frame(light);
        t = meet_plane(f, ray);
        let p = abs(on_plane(f, ray, t));
        t = select(RNA_FAR, t, all(p <= rectangle_half(light)));
    } else if kind == DISK {
        let f = disk_frame(light);
        t = meet_plane(f, ray);
        t = select(RNA_FAR, t, length(on_plane(f, ray, t)) <= disk_radius(light));
    }
    return select(RNA_FAR, t, t >= ray.near && t < ray.far);
}
`,"render/lobe_constants.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const SURFACE_SHARES = vec3f(0.2, 0.35, 0.45);
const FIBER_SHARES = vec3f(0.3, 0.45, 0.25);
const MIRROR_KAPPA: f32 = 20.0;
const CONE_SCALE: f32 = 0.06;
const FORWARD_KAPPA: f32 = 5.0;
`,"render/passing.wgsl":`// What rays pass through: rna_trace/embree/filters.py. Rays pass hits at random, as often as these
// let light through; shadow rays pass all and are weakened.

const ALL_STOP: u32 = 0u;
const AT_RANDOM: u32 = 1u; // the mean of the colours
const WEAKEN: u32 = 2u;
const WEIGH: u32 = 3u; // stops at nothing; colour over mean of what AT_RANDOM has passed

var<private> passing: u32;
var<private> passed_weight: vec3f;
var<private> is_coloured: bool;
var<private> stopped_share: vec3f; // of the last hit that stopped: what colours it leaves
var<private> chance_key: u32;

fn start_passing(how: u32) {
    passing = select(ALL_STOP, how, (frame.flags & TRANSMITS) != 0u);
    passed_weight = vec3f(1.0);
    is_coloured = false;
}

// In [0, 1), a fixed number for each primitive and ray.
fn chance(primitive: u32, instance: u32) -> f32 {
    let state = hash_bits(hash_bits(chance_key ^ primitive) + instance);
    return f32(state >> 8u) * 0x1p-24f;
}

fn pass_at_random(tau: vec3f, mean: f32, passes: bool) -> bool {
    let coloured = any(tau != vec3f(tau.x));
    if passes {
        is_coloured = is_coloured || coloured;
        return false;
    }
    stopped_share = select(vec3f(1.0), (1.0 - tau) / max(1.0 - mean, 1e-6), coloured);
    return true;
}

fn rna_stops(primitive: u32, ray: RnaRay, found: vec3f, instance: u32) -> bool {
    stopped_share = vec3f(1.0);
    if passing == ALL_STOP {
        return true;
    }
    let record = rna_primitives[primitive];
    if !surface_has(rna_surface(record), LETS_THROUGH) {
        return passing != WEIGH;
    }
    let p = rna_points[record.a].xyz;
    let ng = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let facing = dot(ng, ray.direction) < 0.0;
    let tau = transmittance(record, found.y, found.z, ray.direction, facing);
    if passing == WEAKEN {
        passed_weight *= tau;
        return all(passed_weight <= vec3f(0.0));
    }
    let mean = (tau.x + tau.y + tau.z) / 3.0;
    let passes = mean > 0.0 && chance(primitive, instance) < mean;
    if passing == AT_RANDOM {
        return pass_at_random(tau, mean, passes);
    }
    if passes {
        passed_weight *= tau / mean;
    }
    return false;
}
`,"render/sampler.wgsl":`// Owen-scrambled Sobol' points, the very ones of rna_render.paths.sampling: a pure function of seed, pixel,
// sample and dimension.

fn hash_bits(value: u32) -> u32 {
    var x = (value ^ (value >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

// Burley, Practical Hash-based Owen Scrambling (JCGT 9(4), 2020).
fn owen(value: u32, seed: u32) -> u32 {
    var x = reverseBits(value) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reverseBits(x);
}

fn second_sobol(index: u32) -> u32 {
    var x = reverseBits(index);
    x ^= x << 16u;
    x ^= (x & 0x00ff00ffu) << 8u;
    x ^= (x & 0x0f0f0f0fu) << 4u;
    x ^= (x & 0x33333333u) << 2u;
    return x ^ ((x & 0x55555555u) << 1u);
}

// A point of the unit square for a dimension of the path at its present point.
fn square(pixel: u32, dimension: u32, number: u32) -> vec2f {
    let image_key = hash_bits(hash_bits(frame.seed) + dimension);
    let key = hash_bits(image_key ^ hash_bits(pixel + 1u));
    let index = owen(number, key);
    let first = owen(reverseBits(index), hash_bits(key + 1u));
    let second = owen(second_sobol(index), hash_bits(key + 2u));
    return vec2f(f32(first >> 8u), f32(second >> 8u)) * 0x1p-24f;
}

// Number of the path among all of its pixel that have come to this point.
fn path_of_pixel() -> u32 {
    return frame.sample * frame.branches + frame.branch;
}

fn at_point(pixel: u32, dimension: u32) -> vec2f {
    return square(pixel, (frame.depth - 1u) * DIMENSIONS + dimension, path_of_pixel());
}

// What a path's next ray passes at random through.
fn chance_of(pixel: u32) -> u32 {
    let path = hash_bits(hash_bits(frame.seed + 1u) ^ hash_bits(pixel + 1u));
    return hash_bits(hash_bits(path ^ path_of_pixel()) + frame.depth);
}
`,"render/scene_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const NONE: u32 = 0xffffffffu;
const SUM_BEAUTY: u32 = 0u;
const SUM_NORMAL: u32 = 1u;
const SUM_POSITION: u32 = 2u;
const SUM_LIGHT_SAMPLES: u32 = 3u;
const SUM_BEHIND: u32 = 4u;
const IS_LIGHT: u32 = 0x80000000u;
const MATERIAL_PART: u32 = 0xfffffffeu;
const CATCHER_PART: u32 = 0xfffffffdu;
const SUM_GROUPS: u32 = 5u;
const CAMERA_RAY: u32 = 1u;
const SHADOW_RAY: u32 = 4u;
const ALL_DIRECTIONS: u32 = 0xffffffffu;
const HEMISPHERE: u32 = 0xfffffffeu;
const CHOICES: u32 = 1u;
const DIRECTION: u32 = 2u;
const ROULETTE: u32 = 3u;
const LIGHT: u32 = 4u;
const DIMENSIONS: u32 = 7u;
const HAS_SKY: u32 = 1u;
const FOR_BETA: u32 = 2u;
const RAYS_MEET_LIGHTS: u32 = 4u;
const FOR_EMISSION: u32 = 8u;
const FOR_LIGHT: u32 = 16u;
const TRANSMITS: u32 = 32u;

struct Frame { // 160 bytes
    camera: vec3f, // 0
    width: u32, // 12
    corner: vec3f, // 16; direction through the image's top left corner
    paths: u32, // 28
    step_x: vec3f, // 32; of a pixel
    sample: u32, // 44
    step_y: vec3f, // 48
    seed: u32, // 60
    depth: u32, // 64; points of the path so far
    light: u32, // 68; that is sampled; NONE: one that is chosen
    part: u32, // 72; number of the sample of this light at this point
    parts: u32, // 76; samples of this light at this point
    rays: u32, // 80; bit of the sort of rays
    clamp: f32, // 84
    light_count: u32, // 88
    sums: u32, // 92; vec4f of a path in \`sums\`: SUM_GROUPS, and two a group of lights
    flags: u32, // 96; of those below
    branch: u32, // 100; number of the ray that went on from the first point
    branches: u32, // 104; of those rays; 1 before them
    neural_part: u32, // 108
    list: u32, // 112; start in \`live\` of the list of paths that the step is for
    next_list: u32, // 116; likewise, of those that go on from there
    table_size: u32, // 120; of albedo
    objects: u32, // 124; this and the rest: starts of the sections of \`table\`
    surfaces: u32, // 128
    lights: u32, // 132
    albedo: u32, // 136
    domains: u32, // 140
    textures: u32, // 144
}

struct Path { // 96 bytes
    origin: vec3f, // 0
    pixel: u32, // 12
    direction: vec3f, // 16
    pdf: f32, // 28; of the direction; 0 of camera rays
    beta: vec3f, // 32
    state: u32, // 44
    normal: vec3f, // 48; of a segment
    t: f32, // 60
    instance: u32, // 64
    primitive: u32, // 68
    own: u32, // 72; instance that the ray passes through
    b1: f32, // 76
    leaving: vec3f, // 80; of a ray that leaves an asset: its start in object space
    b2: f32, // 92
}

struct Query { // 96 bytes
    x: vec3f, // 0
    h: f32, // 12
    axis: vec3f, // 16
    part: u32, // 28; whose decoder answers, or NONE, MATERIAL_PART, CATCHER_PART
    wo: vec3f, // 32
    light: u32, // 44
    wi: vec3f, // 48
    strand: u32, // 60; that a ray from here passes through
    weight: vec3f, // 64
    seen: f32, // 76; mean of what all that is in the way leaves of the light
    visible: vec3f, // 80; what the asset itself leaves of it
    reserved: u32, // 92
}

struct PathQueries { // 192 bytes
    at_point: Query, // 0; what the path's point scatters or emits
    at_light: Query, // 96; what an asset emits at its point that was sampled as a light
}
`,"render/surfaces.wgsl":`// Surfaces of the scene, by the number that primitives have; scene_surfaces.py fills them.

@group(2) @binding(4) var<storage, read> normals: array<vec4f>; // and v of meshes

fn surface_has(surface: u32, flag: u32) -> bool {
    return (surface_flags(surface) & flag) != 0u;
}

// Texture coordinates of a point, of the first or the second set.
fn corner_uv(surface: u32, point: u32, uv_set: u32) -> vec2f {
    if uv_set == 0u {
        return vec2f(rna_points[point].w, normals[point].w);
    }
    let at = surface_second_uvs(surface) + 2u * point;
    return vec2f(bitcast<f32>(images[at]), bitcast<f32>(images[at + 1u]));
}

fn corner_uvs(record: RnaPrimitive, uv_set: u32) -> mat3x2f {
    let surface = rna_surface(record);
    return mat3x2f(
        corner_uv(surface, record.a, uv_set),
        corner_uv(surface, record.b, uv_set),
        corner_uv(surface, record.c, uv_set),
    );
}

fn weights_of(b1: f32, b2: f32) -> vec3f {
    return vec3f(1.0 - b1 - b2, b1, b2);
}
`,"render/table_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

const OF_MATERIAL: u32 = 0u;
const OF_NEURAL: u32 = 1u;
const OF_FIBERS: u32 = 2u;
const EMITS: u32 = 1u;
const LETS_THROUGH: u32 = 2u;
const IS_GLASS: u32 = 4u;
const HAS_CUTOFF: u32 = 8u;
const HAS_SCHLICK: u32 = 16u;
const BASE: u32 = 0u;
const METAL: u32 = 1u;
const COAT: u32 = 2u;
const GLOW: u32 = 3u;
const CLEAR: u32 = 4u;
const CLEAR_ROUGH: u32 = 5u;
const THROUGH: u32 = 6u;
const RELIEF: u32 = 7u;
const LIGHT_SEEN: u32 = 1u;
const LIGHT_DELTA: u32 = 2u;
const LIGHT_INFINITE: u32 = 4u;
const DIRECTIONAL: u32 = 0u;
const SUN: u32 = 1u;
const POINT: u32 = 2u;
const RECTANGLE: u32 = 3u;
const DISK: u32 = 4u;
const SPHERE: u32 = 5u;
const UNIFORM: u32 = 6u;
const IMAGE: u32 = 7u;
const TRIANGLES: u32 = 8u;

fn object_number(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].x;
}
fn object_catches(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].y);
}
fn object_step(k: u32) -> f32 {
    return table[frame.objects + 1u * k + 0u].z;
}
fn object_passes(k: u32) -> u32 {
    return bitcast<u32>(table[frame.objects + 1u * k + 0u].w);
}

fn surface_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].x);
}
fn surface_part(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].y);
}
fn surface_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].z);
}
fn surface_normal_map(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 0u].w);
}
fn surface_base_color(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 1u].xyz;
}
fn surface_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 1u].w;
}
fn surface_metallic(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].x;
}
fn surface_coat_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].y;
}
fn surface_coat_weight(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].z;
}
fn surface_transmission(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 2u].w;
}
fn surface_emission(k: u32) -> vec3f {
    return table[frame.surfaces + 9u * k + 3u].xyz;
}
fn surface_normal_scale(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 3u].w;
}
fn surface_clear_coat(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].x;
}
fn surface_clear_coat_roughness(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 4u].y;
}
fn surface_second_uvs(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].z);
}
fn surface_tangents(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 4u].w);
}
fn surface_textures(k: u32, i: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 5u + i / 4u][i % 4u]);
}
fn surface_through(k: u32) -> u32 {
    return bitcast<u32>(table[frame.surfaces + 9u * k + 7u].x);
}
fn surface_cutoff(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 7u].y;
}
fn surface_ior(k: u32) -> vec2f {
    return table[frame.surfaces + 9u * k + 7u].zw;
}
fn surface_f0(k: u32) -> f32 {
    return table[frame.surfaces + 9u * k + 8u].x;
}

fn texture_place(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].x);
}
fn texture_size(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].y);
}
fn texture_form(k: u32) -> u32 {
    return bitcast<u32>(table[frame.textures + 3u * k + 0u].z);
}
fn texture_row_u(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 1u].xyz;
}
fn texture_row_v(k: u32) -> vec3f {
    return table[frame.textures + 3u * k + 2u].xyz;
}

fn light_kind(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].x);
}
fn light_group(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].y);
}
fn light_flags(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].z);
}
fn light_instance(k: u32) -> u32 {
    return bitcast<u32>(table[frame.lights + 8u * k + 0u].w);
}
fn light_numbers(k: u32, i: u32) -> f32 {
    return table[frame.lights + 8u * k + 1u + i / 4u][i % 4u];
}
fn light_probability(k: u32) -> vec3f {
    return table[frame.lights + 8u * k + 6u].xyz;
}
fn light_places(k: u32) -> vec4<u32> {
    return bitcast<vec4<u32>>(table[frame.lights + 8u * k + 7u].xyzw);
}

fn light_colour(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 0u), light_numbers(k, 1u), light_numbers(k, 2u));
}
fn directional_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sun_one_minus_cosine(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn point_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn point_axis(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 6u), light_numbers(k, 7u), light_numbers(k, 8u));
}
fn point_cos_inner(k: u32) -> f32 {
    return light_numbers(k, 9u);
}
fn point_cos_outer(k: u32) -> f32 {
    return light_numbers(k, 10u);
}
fn rectangle_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn rectangle_half(k: u32) -> vec2f {
    return vec2f(light_numbers(k, 15u), light_numbers(k, 16u));
}
fn disk_frame(k: u32) -> mat4x3f {
    return mat4x3f(light_numbers(k, 3u), light_numbers(k, 7u), light_numbers(k, 11u), light_numbers(k, 4u), light_numbers(k, 8u), light_numbers(k, 12u), light_numbers(k, 5u), light_numbers(k, 9u), light_numbers(k, 13u), light_numbers(k, 6u), light_numbers(k, 10u), light_numbers(k, 14u));
}
fn disk_radius(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn sphere_centre(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 3u), light_numbers(k, 4u), light_numbers(k, 5u));
}
fn sphere_radius(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn image_turn_cosine(k: u32) -> f32 {
    return light_numbers(k, 3u);
}
fn image_turn_sine(k: u32) -> f32 {
    return light_numbers(k, 4u);
}
fn image_total(k: u32) -> f32 {
    return light_numbers(k, 5u);
}
fn image_mean(k: u32) -> f32 {
    return light_numbers(k, 6u);
}
fn image_rows(k: u32) -> f32 {
    return light_numbers(k, 7u);
}
fn image_columns(k: u32) -> f32 {
    return light_numbers(k, 8u);
}
fn triangles_rotation(k: u32) -> mat3x3f {
    return mat3x3f(light_numbers(k, 3u), light_numbers(k, 6u), light_numbers(k, 9u), light_numbers(k, 4u), light_numbers(k, 7u), light_numbers(k, 10u), light_numbers(k, 5u), light_numbers(k, 8u), light_numbers(k, 11u));
}
fn triangles_place(k: u32) -> vec3f {
    return vec3f(light_numbers(k, 12u), light_numbers(k, 13u), light_numbers(k, 14u));
}
fn triangles_scale(k: u32) -> f32 {
    return light_numbers(k, 15u);
}
fn image_texels(k: u32) -> u32 {
    return light_places(k).x;
}
fn image_heights(k: u32) -> u32 {
    return light_places(k).y;
}
fn image_row_sums(k: u32) -> u32 {
    return light_places(k).z;
}
fn image_column_sums(k: u32) -> u32 {
    return light_places(k).w;
}
fn triangles_sums(k: u32) -> u32 {
    return light_places(k).x;
}
fn triangles_primitives(k: u32) -> u32 {
    return light_places(k).y;
}
fn triangles_densities(k: u32) -> u32 {
    return light_places(k).z;
}
fn triangles_count(k: u32) -> u32 {
    return light_places(k).w;
}
`,"render/textures.wgsl":`// Textures on triangles: rna_render/materials/textures.py. A texel is a u32 of three bytes.

const REPEAT: u32 = 0u;
const MIRROR: u32 = 2u;

struct Image {
    place: u32,
    size: vec2<u32>, // columns, rows
    form: u32,
}

fn image_of(texture: u32) -> Image {
    let size = texture_size(texture);
    return Image(
        texture_place(texture), vec2<u32>(size & 0xffffu, size >> 16u), texture_form(texture),
    );
}

fn texel(at: Image, column: u32, row: u32) -> vec3f {
    let word = images[at.place + row * at.size.x + column];
    let c = vec3f((vec3<u32>(word) >> vec3<u32>(0u, 8u, 16u)) & vec3<u32>(255u)) / 255.0;
    if (at.form & 16u) == 0u {
        return c;
    }
    return select(pow((c + 0.055) / 1.055, vec3f(2.4)), c / 12.92, c <= vec3f(0.04045));
}

struct Around {
    first: u32,
    second: u32,
    part: f32,
}

// The two texels whose centres x is between.
fn texels_around(x: f32, size: u32, wrap: u32) -> Around {
    var inside = clamp(x, 0.0, 1.0);
    if wrap == REPEAT {
        inside = x - floor(x);
    } else if wrap == MIRROR {
        let twice = x - 2.0 * floor(0.5 * x);
        inside = select(twice, 2.0 - twice, twice > 1.0);
    }
    let place = inside * f32(size) - 0.5;
    let low = floor(place);
    let first = i32(low);
    let last = i32(size) - 1;
    if wrap == REPEAT {
        let wrapped = select(first, last, first < 0);
        return Around(u32(wrapped), u32(select(first + 1, 0, first + 1 > last)), place - low);
    }
    return Around(u32(max(first, 0)), u32(min(first + 1, last)), place - low);
}

// Bilinear, mixed after decoding, at the mesh's coordinates.
fn texture_value(texture: u32, uv: vec2f) -> vec3f {
    let at = image_of(texture);
    let u = dot(texture_row_u(texture), vec3f(uv, 1.0));
    let v = dot(texture_row_v(texture), vec3f(uv, 1.0));
    let x = texels_around(u, at.size.x, at.form & 3u);
    let y = texels_around(v, at.size.y, (at.form >> 2u) & 3u);
    let upper = mix(texel(at, x.first, y.first), texel(at, x.second, y.first), x.part);
    let lower = mix(texel(at, x.first, y.second), texel(at, x.second, y.second), x.part);
    return mix(upper, lower, y.part);
}

// On a triangle at barycentrics.
fn texture_on(texture: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let uv_set = (image_of(texture).form >> 5u) & 1u;
    return texture_value(texture, corner_uvs(record, uv_set) * weights_of(b1, b2));
}

// A texture of the triangle's material; 1 where it has none.
fn factor_on(k: u32, record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    let texture = surface_textures(rna_surface(record), k);
    if texture == NONE {
        return vec3f(1.0);
    }
    return texture_on(texture, record, b1, b2);
}

// Radiance that a material emits, to both sides.
fn emission_on(record: RnaPrimitive, b1: f32, b2: f32) -> vec3f {
    return surface_emission(rna_surface(record)) * factor_on(GLOW, record, b1, b2);
}
`,"render/tracing.wgsl":`// Rays of the three sorts through the whole scene. light_shapes.wgsl adds lights with a shape, or a host says
//     fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit
// where there are none.

struct Through {
    hit: RnaHit,
    weight: vec3f, // for what the ray passed or hit at random, if that has a colour
}

// The closest hit of a camera or indirect ray; \`key\` decides what it passes.
fn closest_through(ray: RnaRay, own: u32, key: u32) -> Through {
    var hit = rna_miss(ray.far);
    var line = ray;
    var share = vec3f(1.0);
    chance_key = key;
    stopped_share = vec3f(1.0);
    start_passing(AT_RANDOM);
    loop {
        let found = rna_trace(line, own, frame.rays, false);
        if passing == WEIGH {
            break;
        }
        hit = with_lights(ray, found);
        let is_triangle = (hit.instance & IS_LIGHT) == 0u
            && !rna_is_segment(rna_primitives[hit.primitive]);
        share = select(share, stopped_share, is_triangle);
        if !is_coloured {
            break;
        }
        passing = WEIGH;
        line.far = hit.t;
    }
    return Through(hit, share * passed_weight);
}

// What a shadow ray keeps of its light.
fn kept_on(ray: RnaRay, own: u32) -> vec3f {
    start_passing(WEAKEN);
    var hit = rna_trace(ray, own, frame.rays, true);
    if hit.instance == RNA_NOTHING {
        hit = with_lights(ray, hit);
    }
    return select(vec3f(0.0), passed_weight, hit.instance == RNA_NOTHING);
}

// What an asset leaves of light along a ray from itself, in its object space.
fn own_kept(instance: u32, ray: RnaRay, strand: u32) -> vec3f {
    var hit = rna_miss(ray.far);
    let root = rna_instances[instance].root;
    start_passing(WEAKEN);
    let stopped = rna_trace_body(root, ray, strand, true, &hit);
    return select(passed_weight, vec3f(0.0), stopped);
}
`,"render/transmittance.wgsl":`// What triangles let through, of materials and of assets: spec/RNA.md, 4.4 Transmittance, and
// rna_trace/transmittance.py.

// Unpolarised, of an interface of relative index eta.
fn dielectric_reflectance(eta: f32, cosine: f32) -> f32 {
    let squared = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    if squared <= 0.0 {
        return 1.0;
    }
    let root = sqrt(squared);
    let s = (cosine - eta * root) / (cosine + eta * root);
    let p = (eta * cosine - root) / (eta * cosine + root);
    return 0.5 * (s * s + p * p);
}

// The part that a smooth interface does not reflect of a ray along d, in object space.
fn passed_interface(
    record: RnaPrimitive, b: vec3f, d: vec3f, facing: bool,
) -> f32 {
    let surface = rna_surface(record);
    let ior = surface_ior(surface);
    let eta = select(ior.y, ior.x, facing);
    let schlick = surface_has(surface, HAS_SCHLICK);
    if eta == 0.0 && !schlick {
        return 1.0;
    }
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz) * b;
    let cosine = min(abs(dot(n, d)) / max(sqrt(dot(n, n) * dot(d, d)), 1e-30), 1.0);
    if eta != 0.0 {
        return 1.0 - dielectric_reflectance(eta, cosine);
    }
    let f0 = surface_f0(surface);
    let away = 1.0 - cosine;
    return (1.0 - f0) * (1.0 - away * away * away * away * away);
}

// Of a triangle, for a ray along d in object space. facing: it meets the normal's side.
fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    let surface = rna_surface(record);
    if !surface_has(surface, LETS_THROUGH) {
        return vec3f(0.0);
    }
    var tau = texture_on(surface_through(surface), record, b1, b2);
    if surface_has(surface, HAS_CUTOFF) {
        tau = select(vec3f(0.0), vec3f(1.0), tau > vec3f(surface_cutoff(surface)));
    }
    let passed = passed_interface(record, weights_of(b1, b2), d, facing);
    return min(tau * passed, vec3f(1.0));
}
`,"render/triangle_lights.wgsl":`// Triangles that shine, of an object or an asset: rna_render/lights/mesh.py. In \`images\` a light has
// running sums of its triangles' shares (count + 1), their primitives (count), and densities per area
// by primitive of the body.

// Of points on either side of a triangle, seen from x along d, in object space.
fn triangle_pdf(light: u32, primitive: u32, x: vec3f, d: vec3f) -> f32 {
    let per_area = bitcast<f32>(images[triangles_densities(light) + primitive]);
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let area = cross(rna_points[record.b].xyz - p, rna_points[record.c].xyz - p);
    let normal = area / max(length(area), 1e-30);
    let side = select(1.0, -1.0, dot(x - p, normal) < 0.0);
    return flat_pdf(p, side * normal, per_area, x, d);
}

// Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct Lighting
// Calculations (TOG 15(1), 1996), section 3.2.
fn sample_triangles(light: u32, x_world: vec3f, u: vec2f) -> LightSample {
    let sums_at = triangles_sums(light);
    let count = triangles_count(light);
    if count == 0u {
        return light_sample(vec3f(0.0, 0.0, 1.0), 0.0, vec3f(0.0), 0.0);
    }
    let instance = light_instance(light);
    let x = rna_object_point(x_world, instance);
    let value = u.x * image_float(sums_at + count);
    let chosen = interval(sums_at, count, value);
    let root = sqrt(place_within(sums_at, chosen, value));
    let b = vec2f(root * (1.0 - u.y), root * u.y);
    let primitive = images[triangles_primitives(light) + chosen];
    let record = rna_primitives[primitive];
    let p = rna_points[record.a].xyz;
    let way = p - x + b.x * (rna_points[record.b].xyz - p) + b.y * (rna_points[record.c].xyz - p);
    let r = length(way);
    let wi = way / max(r, 1e-30);
    let pdf = select(0.0, triangle_pdf(light, primitive, x, wi), r > 0.0);
    let scale = rna_instances[instance].scale;
    let wi_world = rna_world_direction(wi, instance);
    let colour = light_colour(light);
    return LightSample(wi_world, r * scale, colour, pdf, primitive, b.x, b.y);
}
`,"render/vertex.wgsl":`// The point that a path has come to, from its hit.

struct Vertex {
    x: vec3f, // object space, as all that is not said otherwise
    kind: u32,
    n: vec3f, // interpolated normal, or that of a segment
    surface: u32,
    ng: vec3f,
    part: u32,
    lift: vec3f,
    h: f32,
    axis: vec3f, // of a decoder's queries: mapped normal or tangent
    strand: u32,
    wo: vec3f,
    instance: u32,
    x_world: vec3f,
    shading: vec3f, // mapped normal of meshes, n of strands
    n_world: vec3f, // the same
    b1: f32,
    ng_world: vec3f,
    b2: f32,
    record: RnaPrimitive, // of its primitive
}

// Of a normal map: a u32 a texel, whose first two bytes are its numbers.
fn rna_map_texel(map: u32, row: u32, column: u32) -> vec2f {
    let at = image_of(map);
    let word = images[at.place + row * at.size.x + column];
    return vec2f(f32(word & 255u), f32((word >> 8u) & 255u));
}

fn triangle_vertex(record: RnaPrimitive, b1: f32, b2: f32) -> Vertex {
    var v: Vertex;
    let b = weights_of(b1, b2);
    let p = mat3x3f(
        rna_points[record.a].xyz, rna_points[record.b].xyz, rna_points[record.c].xyz,
    );
    let n = mat3x3f(normals[record.a].xyz, normals[record.b].xyz, normals[record.c].xyz);
    v.x = p[0] + b1 * (p[1] - p[0]) + b2 * (p[2] - p[0]);
    let mixed = n * b;
    v.n = select(vec3f(0.0), mixed / max(length(mixed), 1e-30), dot(mixed, mixed) > 0.0);
    let area = cross(p[1] - p[0], p[2] - p[0]);
    let largest = max(abs(area.x), max(abs(area.y), abs(area.z)));
    if largest > 0.0 {
        v.ng = normalize(area / largest);
    }
    v.lift = rna_lift(v.x, b, p, n);
    v.shading = v.n;
    v.b1 = b1;
    v.b2 = b2;
    let map = surface_normal_map(rna_surface(record));
    if map != NONE {
        v.shading = rna_mapped_normal(map, image_of(map).size, v.n, p, corner_uvs(record, 0u), b);
    }
    v.axis = v.shading;
    v.strand = RNA_NOTHING;
    return v;
}

fn segment_vertex(path: Path, record: RnaPrimitive, wo: vec3f) -> Vertex {
    var v: Vertex;
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    let size = max(abs(way.x), max(abs(way.y), abs(way.z)));
    v.axis = normalize(way / size);
    v.n = path.normal;
    v.ng = path.normal;
    v.x = path.t * rna_object_direction(path.direction, path.instance)
        / rna_instances[path.instance].scale
        + rna_object_point(path.origin, path.instance);
    v.x = on_cone(cone, v.x, v.n);
    let across = cross(v.axis, wo);
    let width = length(across);
    if width > 1e-6 {
        v.h = clamp(dot(v.n, across) / width, -1.0, 1.0);
    }
    v.shading = v.n;
    v.strand = rna_strand(record);
    return v;
}

// The point of the surface of normal n near x: that of the sphere which touches it there. The error
// of x is that of its ray's length.
fn on_cone(cone: RnaCone, x: vec3f, n: vec3f) -> vec3f {
    let way = cone.b - cone.a;
    let radius = dot(x - cone.a, n);
    let along = dot(x - cone.a - clamp(radius, 0.0, max(cone.ra, cone.rb)) * n, way);
    let u = clamp(along / dot(way, way), 0.0, 1.0);
    return mix(cone.a, cone.b, u) + mix(cone.ra, cone.rb, u) * n;
}

fn vertex_of(path: Path) -> Vertex {
    let record = rna_primitives[path.primitive];
    let wo = rna_object_direction(-path.direction, path.instance);
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, path.b1, path.b2);
    } else {
        v = segment_vertex(path, record, wo);
    }
    v.record = record;
    v.surface = rna_surface(record);
    v.kind = surface_kind(v.surface);
    v.part = surface_part(v.surface);
    if v.kind == OF_MATERIAL {
        v.shading = bumped_normal(record, v.b1, v.b2, v.n, v.ng, wo);
    }
    v.wo = wo;
    v.instance = path.instance;
    v.x_world = rna_world_point(v.x, path.instance);
    v.n_world = rna_world_direction(v.shading, path.instance);
    v.ng_world = rna_world_direction(v.ng, path.instance);
    return v;
}

// Where rays along wi start in the world: on materials a step off the surface.
fn origin_of(v: Vertex, wi_world: vec3f) -> vec3f {
    let step = object_step(v.instance);
    return v.x_world + select(step, -step, dot(v.ng_world, wi_world) < 0.0) * v.ng_world;
}

// Origin of the visibility ray along wi against the asset itself; object space.
fn leaving_point(v: Vertex, wi: vec3f) -> vec3f {
    if v.kind == OF_FIBERS {
        return v.x;
    }
    let extent = rna_instances[v.instance].extent;
    return rna_leaving_origin(v.x, v.n, v.ng, v.lift, wi, extent);
}

fn instance_scale(instance: u32) -> f32 {
    return rna_instances[instance].scale;
}
`,"row_records.wgsl":`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit.

struct RnaRow { // 64 bytes
    position: vec3<u32>, // 0; object space
    h: u32, // 12
    axis: vec3<u32>, // 16; normal or tangent
    reserved: u32, // 28
    wo: vec3<u32>, // 32
    reserved_2: u32, // 44
    wi: vec3<u32>, // 48
    reserved_3: u32, // 60
}
`,"segment.wgsl":`// Where a ray enters a round cone from outside: spec/RNA.md, 4.2 Curves and 7.1 Transport.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

fn rna_cone(point: u32) -> RnaCone {
    let a = rna_points[point];
    let b = rna_points[point + 1u];
    return RnaCone(a.xyz, a.w, b.xyz, b.w);
}

// Along d from p to where it enters the sphere; RNA_FAR where it does not.
fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    let v = p - centre;
    let along = dot(v, d);
    let rest = v - along * d;
    let h = radius * radius - dot(rest, rest);
    if h <= 0.0 {
        return RNA_FAR;
    }
    return -along - sqrt(h);
}

// How far p is outside of the cone; negative inside.
fn rna_cone_distance(cone: RnaCone, p: vec3f) -> f32 {
    let axis = cone.b - cone.a;
    let size = length(axis);
    let dr = cone.ra - cone.rb;
    let v = p - cone.a;
    let y = dot(v, axis) / size;
    let x = length(v - axis * (y / size));
    let to_a = length(vec2f(x, y)) - cone.ra;
    let to_b = length(vec2f(x, y - size)) - cone.rb;
    if size <= abs(dr) {
        return select(to_b, to_a, dr > 0.0);
    }
    let slope = dr / size;
    let lean = sqrt(1.0 - slope * slope);
    let along = y * lean - x * slope;
    if along <= 0.0 {
        return to_a;
    }
    if along >= size * lean {
        return to_b;
    }
    return x * lean + y * slope - cone.ra;
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

// The entry of the line into the cone: of the points where it enters a sphere at an end, or the side
// between them, the first. \`from\` is near the cone, to keep digits.
fn rna_enter_cone(cone: RnaCone, p: vec3f, d: vec3f) -> RnaEntry {
    let ta = rna_enter_sphere(p, d, cone.a, cone.ra);
    let tb = rna_enter_sphere(p, d, cone.b, cone.rb);
    var entry = RnaEntry(min(ta, tb), vec3f(0.0));
    entry.normal = p + entry.t * d - select(cone.b, cone.a, ta < tb);
    let axis = cone.b - cone.a;
    let v = p - cone.a;
    let dr = cone.ra - cone.rb;
    let squared = dot(axis, axis);
    let d2 = squared - dr * dr;
    let m1 = dot(axis, v);
    let m2 = dot(axis, d);
    let k2 = d2 - m2 * m2;
    let k1 = d2 * dot(d, v) - m1 * m2 + m2 * dr * cone.ra;
    let k0 = d2 * dot(v, v) - m1 * m1 + 2.0 * m1 * dr * cone.ra - squared * cone.ra * cone.ra;
    let h = k1 * k1 - k0 * k2;
    if d2 <= 0.0 || h < 0.0 || k2 == 0.0 {
        return entry;
    }
    for (var sign = -1.0; sign <= 1.0; sign += 2.0) {
        let side = (sign * sqrt(h) - k1) / k2;
        let y = m1 - cone.ra * dr + side * m2;
        let normal = d2 * (v + side * d) - axis * y;
        if y > 0.0 && y < d2 && side < entry.t && dot(normal, d) < 0.0 {
            entry = RnaEntry(side, normal);
        }
    }
    return entry;
}

// Whether p, on a segment, is inside the one before or after it: there is no surface there.
fn rna_in_neighbour(segment: RnaPrimitive, p: vec3f) -> bool {
    if (segment.b & RNA_HAS_BEFORE) != 0u {
        let before = rna_cone(segment.a - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.b & RNA_HAS_AFTER) != 0u {
        let after = rna_cone(segment.a + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, vec3f(0.0));
    let cone = rna_cone(segment.a);
    let shift = dot(0.5 * (cone.a + cone.b) - ray.origin, ray.direction);
    let p = ray.origin + shift * ray.direction;
    let entry = rna_enter_cone(cone, p, ray.direction);
    let t = entry.t + shift;
    if entry.t >= RNA_FAR || !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    if rna_in_neighbour(segment, p + entry.t * ray.direction) {
        return miss;
    }
    return RnaEntry(t, normalize(entry.normal));
}
`,"surface.wgsl":`// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi.
fn rna_surface(x: vec3f, n: vec3f, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_put_queries(x, n, 0.0, wo, wi);
    return rna_decode();
}

fn rna_put_queries(x: vec3f, n: vec3f, h: f32, wo: vec3f, wi: vec3f) {
    let features = rna_common_blocks(x, wo, wi);
    rna_surface_blocks(n, features, wo, wi);
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_surface(x, axis, wo, wi);
}
`,"surface_blocks.wgsl":`// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

// log2(1 - min(n.m, 1) + 1e-4) / 6
fn rna_log_gap(n: vec3f, m: vec3f) -> f32 {
    let gap = n - m;
    return log2(0.5 * dot(gap, gap) + 1e-4) / 6.0;
}

fn rna_half_vector(slot: u32, n: vec3f, m: vec3f, wo: vec3f, wi: vec3f) {
    if slot != RNA_NONE {
        rna_values[slot] = vec4f(dot(n, m), rna_log_gap(n, m), dot(n, wi), dot(n, wo));
        rna_values[slot + 1u] = vec4f(dot(wi, m), 0.0, 0.0, 0.0);
    }
}

fn rna_highlight(slot: u32, n: vec3f, m: vec3f) {
    let aside = cross(n, m);
    rna_put(slot, vec4f(log2(dot(aside, aside) + 1e-8) / 12.0, 0.0, 0.0, 0.0));
}

fn rna_learned_normal(slot: u32, n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    if slot == RNA_NONE {
        return;
    }
    var q = n + 0.1 * features;
    let size = length(q);
    if size < 1e-6 {
        q = n;
    } else {
        q = q / size;
    }
    let m = rna_halfway(wo, wi, q);
    rna_values[slot] = vec4f(dot(q, m), rna_log_gap(q, m), 0.0, 0.0);
}

fn rna_surface_blocks(n: vec3f, features: vec3f, wo: vec3f, wi: vec3f) {
    rna_put(rna_slot(RNA_BLOCK_NORMAL), vec4f(n, 0.0));
    let m = rna_halfway(wo, wi, n);
    rna_half_vector(rna_slot(RNA_BLOCK_HALF_VECTOR), n, m, wo, wi);
    rna_highlight(rna_slot(RNA_BLOCK_HIGHLIGHT), n, m);
    rna_learned_normal(rna_slot(RNA_BLOCK_LEARNED_NORMAL), n, features, wo, wi);
}
`,"triangle.wgsl":`// Where a ray meets a triangle, from either side, watertight: Woop, Benthin and Wald, Watertight
// Ray/Triangle Intersection (JCGT 2(1), 2013).

// Coordinates with the ray's largest one last.
fn rna_turned(v: vec3f, axis: u32) -> vec3f {
    if axis == 0u {
        return v.yzx;
    }
    if axis == 1u {
        return v.zxy;
    }
    return v;
}

fn rna_largest_axis(d: vec3f) -> u32 {
    let size = abs(d);
    if size.x > size.y && size.x > size.z {
        return 0u;
    }
    return select(2u, 1u, size.y > size.z);
}

// (t, b1, b2), t of RNA_FAR for a miss.
fn rna_meet_triangle(ray: RnaRay, p0: vec3f, p1: vec3f, p2: vec3f) -> vec3f {
    let miss = vec3f(RNA_FAR, 0.0, 0.0);
    let axis = rna_largest_axis(ray.direction);
    let d = rna_turned(ray.direction, axis);
    let shear = vec3f(d.x / d.z, d.y / d.z, 1.0 / d.z);
    let a = rna_turned(p0 - ray.origin, axis);
    let b = rna_turned(p1 - ray.origin, axis);
    let c = rna_turned(p2 - ray.origin, axis);
    let a2 = a.xy - shear.xy * a.z;
    let b2 = b.xy - shear.xy * b.z;
    let c2 = c.xy - shear.xy * c.z;
    let u = c2.x * b2.y - c2.y * b2.x;
    let v = a2.x * c2.y - a2.y * c2.x;
    let w = b2.x * a2.y - b2.y * a2.x;
    if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
        return miss;
    }
    let sum = u + v + w;
    if sum == 0.0 {
        return miss;
    }
    let t = (u * a.z + v * b.z + w * c.z) * shear.z / sum;
    if !(t >= ray.near && t <= ray.far) {
        return miss;
    }
    return vec3f(t, v / sum, w / sum);
}
`,"visibility.wgsl":`// Where visibility rays of meshes start: spec/RNA.md, 7.1 Transport. Those of strands start at x.

// From x, at barycentric coordinates b of a triangle, onto the smooth surface it stands for.
fn rna_lift(x: vec3f, b: vec3f, p: mat3x3f, n: mat3x3f) -> vec3f {
    return b.x * max(0.0, dot(p[0] - x, n[0])) * n[0]
        + b.y * max(0.0, dot(p[1] - x, n[1])) * n[1]
        + b.z * max(0.0, dot(p[2] - x, n[2])) * n[2];
}

// n: interpolated, ng: of the triangle; extent: largest absolute coordinate of the asset.
fn rna_leaving_origin(
    x: vec3f, n: vec3f, ng: vec3f, lift: vec3f, wi: vec3f, extent: f32,
) -> vec3f {
    let step = extent * 0x1p-18f;
    let above = dot(ng, wi);
    if dot(n, wi) > 0.0 && dot(n, ng) > 0.0 && above < 0.1 {
        return x + (1.0 - max(0.0, above) / 0.1) * lift + step * ng;
    }
    return x + select(step, -step, above < 0.0) * ng;
}
`,"weights_storage.wgsl":`// Weights of more than 64 KiB.

@group(0) @binding(1) var<storage, read> rna_weights: array<vec4f>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`,"weights_uniform.wgsl":`// Weights of up to 64 KiB. On software drivers they are read ten times faster from a uniform
// buffer than from storage.

@group(0) @binding(1) var<uniform> rna_weights: array<vec4f, 4096>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`};var wt=`// A band of the picture between the kernels, and the viewer's own numbers of a step, with rna_gpu's Frame.

struct View {
    first: u32,  // pixel of the band
    jitter: f32, // 0: rays through the middles of pixels, 1: anywhere in them
    kind: u32,   // of the light: LIGHT_SUN and so on
    is_first: u32, // 1: the sum starts with this
    direction: vec3f, // of a sun
    counts_coverage: u32,
    colour: vec3f, // irradiance of a sun
    ground: f32,   // its height
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    middle: vec2f,        // of the ground, x and z
    part: u32,     // of the queries, + 1
    form: u32,     // of the answers: FORM_TRANSPORT, two vec4f each; FORM_EMISSION or FORM_ENVIRONMENT, one
    shift: vec2f,  // of the rays, pixels
    pixels: u32,   // of the whole picture
    shares: f32,   // rays a pixel of the first look's edges
}

const FORM_TRANSPORT = 0u;
const FORM_EMISSION = 1u;
const FORM_ENVIRONMENT = 2u;

// A pixel: the members of a row of rna_evaluate, with two numbers in free ones; and its weights.
struct Pixel {
    position: vec4<u32>, // and h of a fiber
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the primitive
    wi: vec4<u32>,
    through: vec3f, // throughput
    b1: f32,        // barycentric coordinates; of a segment how far along it, 0 to 1
    radiance: vec3f, // over the density, times the throughput; of the ground what it sends on
    b2: f32,
    visibility: vec3f,
    coverage: f32, // of the ground
}

@group(1) @binding(0) var<storage, read_write> band: array<Pixel>;
@group(1) @binding(1) var<uniform> view: View;
`;var ya=`// What decoders of lobes are told of the asset's own visibility about a query's point.

@group(2) @binding(0) var<storage, read> count: array<u32>; // [0]; then the pixel of each row
@group(2) @binding(1) var<storage, read> primitives: array<RnaPrimitive>;
@group(2) @binding(2) var<storage, read> harmonics: array<vec4<u32>>; // of a point, 16 int8: of 127
@group(2) @binding(3) var<storage, read_write> columns: array<vec4f>; // 4 a row

fn harmonic(point: u32, k: u32) -> vec4f {
    return unpack4x8snorm(harmonics[point][k]);
}

@compute @workgroup_size(64)
fn tell_visibility(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= count[0] {
        return;
    }
    let pixel = band[count[at + 1u]];
    let record = primitives[pixel.wo.w];
    let is_segment = (record.tag & RNA_IS_SEGMENT) != 0u;
    let second = select(record.b, record.a + 1u, is_segment);
    let third = select(record.c, record.a, is_segment);
    for (var k = 0u; k < 4u; k++) {
        let first = (1.0 - pixel.b1 - pixel.b2) * harmonic(record.a, k);
        columns[4u * at + k] = first + pixel.b1 * harmonic(second, k) + pixel.b2 * harmonic(third, k);
    }
}
`;var xa=`// A ray from the camera through each pixel of the band, to the query of its first hit.

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

// There are no lights with a shape.
fn with_lights(ray: RnaRay, found: RnaHit) -> RnaHit {
    return found;
}

fn along_segment(record: RnaPrimitive, x: vec3f) -> f32 {
    let cone = rna_cone(record.a);
    let way = cone.b - cone.a;
    return clamp(dot(x - cone.a, way) / max(dot(way, way), 1e-30), 0.0, 1.0);
}

fn pixel_of(hit: RnaHit, wo: vec3f) -> Pixel {
    var pixel: Pixel;
    pixel.wo = words(wo, hit.primitive);
    if hit.instance == RNA_NOTHING {
        return pixel;
    }
    let record = rna_primitives[hit.primitive];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, hit.b1, hit.b2);
    } else {
        var path: Path;
        path.origin = frame.camera;
        path.direction = -wo;
        path.t = hit.t;
        path.normal = hit.normal;
        v = segment_vertex(path, record, wo);
    }
    pixel.position = words(v.x, bitcast<u32>(v.h));
    pixel.axis = words(v.axis, surface_part(rna_surface(record)) + 1u);
    pixel.b1 = select(hit.b1, along_segment(record, v.x), rna_is_segment(record));
    pixel.b2 = hit.b2;
    return pixel;
}

@compute @workgroup_size(64)
fn trace_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let place = vec2f(vec2<u32>(number % frame.width, number / frame.width));
    let at = place + mix(vec2f(0.5), square(number, 0u, frame.sample), view.jitter) + view.shift;
    let d = normalize(frame.corner + at.x * frame.step_x + at.y * frame.step_y);
    let ray = RnaRay(frame.camera, 0.0, d, RNA_FAR);
    let found = closest_through(ray, RNA_NOTHING, chance_of(number));
    var pixel = pixel_of(found.hit, -d);
    pixel.through = found.weight;
    band[k] = pixel;
}

// The normals of hits whose primitives and barycentric coordinates are in the band.
@compute @workgroup_size(64)
fn find_normals(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k < frame.paths {
        let hit = RnaHit(0.0, 0u, band[k].wo.w, band[k].b1, band[k].b2, vec3f(0.0));
        band[k].axis = pixel_of(hit, bitcast<vec3f>(band[k].wo.xyz)).axis;
    }
}
`;var ba=`// For each query a direction of one light, the radiance from there, and how much of it the asset lets through; and
// the light on the ground. sources.js declares the kinds of light.

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const FROM_ALL_SIDES = 0.25;

fn mirrored_share(at: Surroundings) -> f32 {
    return select(MIRRORED, 0.0, all(at.mirror == vec3f(0.0)));
}

fn direction_about(at: Surroundings, u: vec2f) -> vec3f {
    let share = mirrored_share(at);
    if u.y < share {
        return normalize(along_axis(at.mirror, fisher_cosine(u.y / share, MIRROR_KAPPA), u.x));
    }
    let rest = (u.y - share) / (1.0 - share);
    let all_sides = rest < FROM_ALL_SIDES;
    let v = select((rest - FROM_ALL_SIDES) / (1.0 - FROM_ALL_SIDES), rest / FROM_ALL_SIDES, all_sides);
    let ball = along_axis(vec3f(0.0, 0.0, 1.0), 1.0 - 2.0 * v, u.x);
    return normalize(ball + select(at.n * 1.0001, vec3f(0.0), all_sides));
}

fn density_about(at: Surroundings, wi: vec3f) -> f32 {
    if all(at.n == vec3f(0.0)) {
        return SPHERE_PDF;
    }
    let rest = mix(max(0.0, dot(at.n, wi)) / PI, SPHERE_PDF, FROM_ALL_SIDES);
    return mix(rest, fisher_pdf(dot(at.mirror, wi), MIRROR_KAPPA), mirrored_share(at));
}

fn surroundings_of(pixel: Pixel) -> Surroundings {
    if pixel.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if rna_is_segment(rna_primitives[pixel.wo.w]) {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// The direction that lobes are asked with. To the ground one by the cosine, with the irradiance in the view's colour.
fn mirrored(number: u32, pixel: Pixel) -> Arrival {
    if pixel.axis.w == 0u {
        let u = at_point(number, DIRECTION);
        let wi = normalize(along_axis(vec3f(0.0, 1.0, 0.0), 1.0 - 2.0 * u.y, u.x) + vec3f(0.0, 1.0001, 0.0));
        return Arrival(wi, view.colour / max(wi.y, 1e-3));
    }
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let wo = bitcast<vec3f>(pixel.wo.xyz);
    let m = select(reflect(-wo, axis), reflect(wo, axis), rna_is_segment(rna_primitives[pixel.wo.w]));
    return Arrival(m, vec3f(1.0));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(number: u32, pixel: Pixel) -> Arrival {
    if view.kind == LIGHT_SUN {
        return Arrival(view.direction, view.colour);
    }
    if view.kind == LIGHT_GIVEN {
        return Arrival(bitcast<vec3f>(pixel.wi.xyz), view.colour);
    }
    let at = surroundings_of(pixel);
    if view.kind == LIGHT_MIRROR {
        return mirrored(number, pixel);
    }
    if view.kind == LIGHT_ENVIRONMENT {
        let bright = sample_image(0u, at_point(number, LIGHT));
        return Arrival(bright.wi, bright.radiance / (bright.pdf + density_about(at, bright.wi)));
    }
    let wi = direction_about(at, at_point(number, DIRECTION));
    let sky = look_up_image(0u, wi);
    return Arrival(wi, sky.radiance / (sky.pdf + density_about(at, wi)));
}

// How much of the light along wi the asset itself lets through to a point of it.
fn visibility_of(pixel: Pixel, wi: vec3f) -> vec3f {
    let record = rna_primitives[pixel.wo.w];
    var v: Vertex;
    if !rna_is_segment(record) {
        v = triangle_vertex(record, pixel.b1, pixel.b2);
        v.kind = OF_NEURAL;
    } else {
        v.x = bitcast<vec3f>(pixel.position.xyz);
        v.kind = OF_FIBERS;
        v.strand = rna_strand(record);
    }
    return own_kept(0u, RnaRay(leaving_point(v, wi), 0.0, wi, RNA_FAR), v.strand);
}

// The ground, seen along d, shows the shadow and fades with the distance: what it sends on of light along wi; and how
// much it covers.
fn ground_seen(d: vec3f, wi: vec3f) -> vec4f {
    if view.ground_size == 0.0 || d.y * (frame.camera.y - view.ground) >= 0.0 {
        return vec4f(0.0);
    }
    let x = frame.camera + d * ((view.ground - frame.camera.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - view.middle) / view.ground_size);
    let weight = fade * max(0.0, wi.y) * view.ground_colour;
    if all(weight <= vec3f(0.0)) {
        return vec4f(0.0, 0.0, 0.0, fade);
    }
    let step = 0x1p-18f * rna_instances[0].extent;
    let way = RnaRay(x + vec3f(0.0, step, 0.0), 0.0, wi, RNA_FAR);
    return vec4f(weight * own_kept(0u, way, RNA_NOTHING), fade);
}

@compute @workgroup_size(64)
fn light_pixels(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    var pixel = band[k];
    let arrival = arrival_at(view.first + k, pixel);
    pixel.wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), 0u);
    pixel.radiance = pixel.through * arrival.radiance;
    if pixel.axis.w != 0u {
        pixel.visibility = visibility_of(pixel, arrival.wi);
    } else {
        let ground = ground_seen(-bitcast<vec3f>(pixel.wo.xyz), arrival.wi);
        pixel.radiance *= ground.xyz;
        pixel.coverage = ground.w;
    }
    band[k] = pixel;
}
`;var Aa=`// The first look without jagged edges: more rays a pixel, each with the light of the pixels nearby that saw what it sees.

@group(2) @binding(0) var<storage, read_write> seen: array<vec4<u32>>; // from pixels' middles: distance, axis, part + 1
@group(2) @binding(1) var<storage, read_write> look: array<vec4f>;

const UNLIKE = 8.0; // weight of differences: of axes, and of distances to a plane in pixels
const APART = 3.0;  // and of the distance in the picture, pixels squared
const APART_ON_GROUND = 0.5; // whose light is noisy

fn raw_direction(place: vec2f) -> vec3f {
    return frame.corner + place.x * frame.step_x + place.y * frame.step_y;
}

// What the band's pixels see from their middles.
@compute @workgroup_size(64)
fn remember(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let pixel = band[k];
    let axis = bitcast<vec3f>(pixel.axis.xyz);
    let away = length(bitcast<vec3f>(pixel.position.xyz) - frame.camera);
    let packed = vec2<u32>(pack2x16snorm(axis.xy), pack2x16snorm(vec2f(axis.z, 0.0)));
    seen[view.first + k] = vec4<u32>(bitcast<u32>(away), packed, pixel.axis.w);
}

// How unlike what the pixel at \`place\` saw from its middle is to a hit of the same part.
fn difference(hit: Pixel, other: vec4<u32>, place: vec2f) -> f32 {
    if hit.axis.w == 0u {
        return 0.0;
    }
    let n = bitcast<vec3f>(hit.axis.xyz);
    let raw = raw_direction(place);
    let away = bitcast<f32>(other.x);
    let x = frame.camera + away * normalize(raw);
    let size = away * length(frame.step_x) / length(raw); // of a pixel there
    let off = abs(dot(n, x - bitcast<vec3f>(hit.position.xyz))) / max(size, 1e-30);
    return 1.0 - dot(n, vec3f(unpack2x16snorm(other.y), unpack2x16snorm(other.z).x)) + off;
}

// The light of the neighbours that are like the band's hit, whose ray went beside the middle by the view's shift.
fn light_beside(number: u32, hit: Pixel) -> vec4f {
    let middle = vec2<i32>(vec2<u32>(number % frame.width, number / frame.width));
    let narrow = select(APART, APART_ON_GROUND, hit.axis.w == 0u);
    var sum = vec4f(0.0);
    var total = 0.0;
    for (var j = 0; j < 9; j++) {
        let step = vec2<i32>(j % 3 - 1, j / 3 - 1);
        let at = middle + step;
        let there = u32(at.y) * frame.width + u32(at.x);
        if at.x < 0 || at.y < 0 || at.x >= i32(frame.width) || there >= view.pixels || seen[there].w != hit.axis.w {
            continue;
        }
        let apart = vec2f(step) - view.shift;
        let unlike = min(difference(hit, seen[there], vec2f(at) + 0.5), 4.0);
        let weight = exp(-UNLIKE * unlike - narrow * dot(apart, apart));
        sum += weight * sums[there];
        total += weight;
    }
    if total == 0.0 {
        return select(sums[number], vec4f(0.0), hit.axis.w == 0u); // nobody saw such a thing
    }
    return sum / total;
}

// One of \`view.shares\` rays a pixel.
@compute @workgroup_size(64)
fn smooth_edges(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let number = view.first + k;
    let before = select(look[number], vec4f(0.0), view.is_first == 1u);
    look[number] = before + light_beside(number, band[k]) / view.shares;
}
`;var Ui=`// The light of the whole environment that a part sends to the viewer, of each row: its lobes, by one look-up each in the
// prefiltered environment.

struct LobeLight {
    colour: vec3f, // of a texel of 1
    levels: f32,
    turn: vec2f,   // cosine and sine, as render/environment.wgsl turns an image
    least_kappa: f32, // of the first level
    an_octave: f32,   // levels
}

@group(1) @binding(0) var<storage, read> rows: array<RnaRow>; // wi: the mirror direction; then its visibility
@group(1) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(1) @binding(2) var<storage, read> count: array<u32>; // [0]
@group(1) @binding(3) var<storage, read> columns: array<vec4f>; // 4 a row
@group(2) @binding(0) var<uniform> light: LobeLight;
@group(2) @binding(1) var prefiltered: texture_2d_array<f32>;
@group(2) @binding(2) var smooth_sampler: sampler;

fn mean_under(lobe: RnaLobe) -> vec3f {
    let d = lobe.axis;
    let x = light.turn.x * d.x - light.turn.y * d.z;
    let z = light.turn.y * d.x + light.turn.x * d.z;
    let sine = sqrt(x * x + z * z);
    let azimuth = select(0.0, atan2(x, -z), sine > 0.0);
    let size = vec2f(textureDimensions(prefiltered));
    let polar = atan2(sine, d.y) / 3.14159265; // the first row is one pole, the last one the other
    let place = vec2f(0.5 + azimuth / 6.28318531, (polar * (size.y - 1.0) + 0.5) / size.y);
    let level = clamp(log2(lobe.kappa / light.least_kappa) * light.an_octave, 0.0, light.levels - 1.0);
    let wide = u32(level);
    let a = textureSampleLevel(prefiltered, smooth_sampler, place, wide, 0.0).xyz;
    let b = textureSampleLevel(prefiltered, smooth_sampler, place, min(wide + 1u, u32(light.levels) - 1u), 0.0).xyz;
    return mix(a, b, level - f32(wide));
}

@compute @workgroup_size(64)
fn light_by_lobes(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let row = id.y * groups.x * 64u + id.x;
    if row >= count[0] {
        return;
    }
    let at = rows[row];
    let axis = bitcast<vec3f>(at.axis);
    let wo = bitcast<vec3f>(at.wo);
    let m = bitcast<vec3f>(at.wi);
    var visibility: array<vec4f, 4>;
    for (var k = 0u; k < 4u; k++) {
        visibility[k] = columns[4u * row + k];
    }
    let place = rna_run_lobes(bitcast<vec3f>(at.position), axis, bitcast<f32>(at.h), wo, m, visibility);
    var sum = vec3f(0.0);
    for (var j = 0u; j < RNA_LOBES; j++) {
        let lobe = rna_lobe(place, j, axis, wo, m, bitcast<f32>(at.reserved_3));
        sum += lobe.amplitude * mean_under(lobe);
    }
    answers[row] = vec4f(light.colour * sum, 0.0);
}
`;var Di=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

@group(2) @binding(0) var<storage, read_write> rows: array<RnaRow>;
@group(2) @binding(1) var<storage, read_write> answers: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

// What a light brings to the ground, and the coverage. \`sums\` are of the whole picture.
@compute @workgroup_size(64)
fn begin(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths {
        return;
    }
    let is_query = band[k].axis.w != 0u;
    let covered = select(band[k].coverage, 1.0, is_query) * f32(view.counts_coverage);
    let before = select(sums[view.first + k], vec4f(0.0), view.is_first == 1u);
    sums[view.first + k] = before + vec4f(select(band[k].radiance, vec3f(0.0), is_query), covered);
}

@compute @workgroup_size(64)
fn gather(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let k = path_number(id, groups);
    if k >= frame.paths || band[k].axis.w != view.part {
        return;
    }
    let pixel = band[k];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], k);
    // No block of emission reads wi.
    let wi = select(pixel.wi, pixel.wo, view.form == FORM_EMISSION);
    let free = dot(pixel.visibility, vec3f(1.0 / 3.0)); // read with lobes alone
    rows[at] = RnaRow(pixel.position.xyz, pixel.position.w, pixel.axis.xyz, 0u, pixel.wo.xyz, 0u, wi.xyz, bitcast<u32>(free));
}

@compute @workgroup_size(64)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>,
) {
    let at = path_number(id, groups);
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let k = atomicLoad(&count[at + 1u]);
    let pixel = band[k];
    var radiance = pixel.through * answers[at].xyz;
    if view.form == FORM_TRANSPORT {
        radiance = pixel.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, pixel.visibility);
    }
    sums[view.first + k] += vec4f(radiance, 0.0);
}
`;var Hi=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec3f, // linear light of the screen
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    first_look: f32, // share of the first look in what is shown, 0 to 1
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;
@group(0) @binding(2) var<storage, read> first_look: array<vec4f>; // the first look

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

// The mean of the samples and the first look.
fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    let k = place.y * u32(shown.picture.x) + place.x;
    if shown.first_look >= 1.0 {
        return first_look[k];
    }
    let mean = sums[k] / shown.rounds;
    if shown.first_look <= 0.0 {
        return mean;
    }
    return mix(mean, first_look[k], shown.first_look);
}

// As rna_render/image/view_transform.py, which names the source.
fn filmic(radiance: vec3f) -> vec3f {
    let c = 1.461926 * min(radiance, vec3f(1e9));
    let x = vec3f(dot(c, vec3f(0.59719, 0.35458, 0.04823)), dot(c, vec3f(0.07600, 0.90834, 0.01566)),
                  dot(c, vec3f(0.02840, 0.13383, 0.83777)));
    // Both parts divided by x, so that none overflows.
    let inverse = 1.0 / max(x, vec3f(1e-9));
    let y = (x + 0.0245786 - 0.000090537 * inverse) / (0.983729 * x + 0.4329510 + 0.238081 * inverse);
    return vec3f(dot(y, vec3f(1.60475, -0.53108, -0.07367)), dot(y, vec3f(-0.10208, 1.10813, -0.00605)),
                 dot(y, vec3f(-0.00327, -0.07276, 1.07602)));
}

// Values of the screen, sRGB, of a mean.
fn displayed(mean: vec4f) -> vec3f {
    let exposed = max(mean.xyz * shown.exposure, vec3f(0.0));
    let light = select(exposed, filmic(exposed), shown.filmic > 0.5);
    let linear = clamp(light, vec3f(0.0), vec3f(1.0)) + max(0.0, 1.0 - mean.w) * shown.backdrop;
    let encoded = mix(12.92 * linear, 1.055 * pow(linear, vec3f(1.0 / 2.4)) - 0.055, step(vec3f(0.0031308), linear));
    return clamp(encoded, vec3f(0.0), vec3f(1.0));
}

@fragment
fn colour(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let place = at.xy * shown.picture / shown.size - 0.5;
    let low = floor(place);
    let f = place - low;
    let above = mix(picture_at(low.x, low.y), picture_at(low.x + 1.0, low.y), f.x);
    let below = mix(picture_at(low.x, low.y + 1.0), picture_at(low.x + 1.0, low.y + 1.0), f.x);
    let mean = mix(above, below, f.y);
    let here = displayed(mean);
    if (shown.spread == 0.0) {
        return vec4f(here, 1.0);
    }
    // Bilateral: neighbours count by how near and how like they are.
    var sum = vec4f(here, 1.0);
    let middle = round(place);
    for (var dy = -2.0; dy <= 2.0; dy += 1.0) {
        for (var dx = -2.0; dx <= 2.0; dx += 1.0) {
            let there = middle + vec2f(dx, dy);
            let other = picture_at(there.x, there.y);
            let value = displayed(other);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            sum += vec4f(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
        }
    }
    return vec4f(sum.xyz / sum.w, 1.0);
}
`;var Ra=`// What segment.wgsl has, for assets without strands: code that an asset has no use for is not compiled, which takes
// most of the time to its first picture.

struct RnaCone {
    a: vec3f,
    ra: f32,
    b: vec3f,
    rb: f32,
}

struct RnaEntry {
    t: f32,
    normal: vec3f,
}

fn rna_cone(point: u32) -> RnaCone {
    return RnaCone(vec3f(0.0), 0.0, vec3f(0.0), 0.0);
}

fn rna_enter_sphere(p: vec3f, d: vec3f, centre: vec3f, radius: f32) -> f32 {
    return RNA_FAR;
}

fn rna_meet_segment(ray: RnaRay, segment: RnaPrimitive) -> RnaEntry {
    return RnaEntry(RNA_FAR, vec3f(0.0));
}
`;var Ea=`// What normal_maps.wgsl and render/transmittance.wgsl have, for assets without textures.

fn rna_mapped_normal(
    map: u32, size: vec2<u32>, n: vec3f, p: mat3x3f, uv: mat3x2f, b: vec3f,
) -> vec3f {
    return n;
}

fn transmittance(record: RnaPrimitive, b1: f32, b2: f32, d: vec3f, facing: bool) -> vec3f {
    return vec3f(0.0);
}
`;for(let n of[wt,Ui,Di,Hi])ms(n);var Qf=Vn((n,e)=>`const ${n}: u32 = ${e}u;`);var ka=n=>n in lt?[n]:_t[n].flatMap(ka),Wt=(n,e=lt)=>[...new Set(n.flatMap(ka))].map(t=>e[t]).join(`
`);function gr(n,...e){return Object.entries(n).map(([r,i])=>`const ${r}: u32 = ${i}u;
`).join("")+Wt(e)}function vr({hasSegments:n,hasTextures:e}){let t={...lt};return n||(t["segment.wgsl"]=Ra),e||Object.assign(t,{"normal_maps.wgsl":Ea,"render/transmittance.wgsl":""}),{hit:Wt(_t.hit,t)+wt+xa,light:[Wt(_t.light,t),wt,Qf,ba].join(`
`)}}var yt={columns:Wt(_t.columns)+wt+ya,lobes:`${lt["environment_lobes.wgsl"]}
${lt["row_records.wgsl"]}
${Ui}`,look:Wt(_t.queue)+wt+Aa,queue:Wt(_t.queue)+wt+Di,show:Hi};var _r=class{constructor(e){this.device=e,this.made=new Map}get(e,t,r){let i=`${t}
${e}`;return this.made.has(i)||this.made.set(i,this._make(e,t,r)),this.made.get(i)}async _make(e,t,r){let i=await lr(this.device,e),s=r?this.device.createPipelineLayout({bindGroupLayouts:r}):"auto";return this.device.createComputePipelineAsync({layout:s,compute:{module:i,entryPoint:t}})}},Zt=class{static make(e,t,r,i,s,o){let l={constants:{RNA_COLOURS:i.outputs===6?2:1},parts:[r.kind,"evaluate"],kernel:"",entryPoint:"rna_evaluate"};return this.of(e,t,jt(r,i,s),o,l)}static async of(e,t,{weights:r,record:i,groups:s},o,{constants:c,parts:l,kernel:f,entryPoint:h}){let m=new this,{UNIFORM_WEIGHTS:g}=se,_=r.length/4<=g,x=_?"weights_uniform.wgsl":"weights_storage.wgsl";m.pipeline=await t.get(gr({RNA_GROUPS:s,...c},x,...l)+f,h);let{UNIFORM:R,STORAGE:F}=GPUBufferUsage,W=_?new Float32Array(4*g):r;return _&&W.set(r),m.buffers=[te(e,i,R,"a decoder"),te(e,W,_?R:F,"a decoder")],m.part=_n(e,m.pipeline,0,[...m.buffers,...o]),m.device=e,m}run(e,{rows:t,answers:r,count:i},s){this.dispatch(e,[t,r,i],s)}dispatch(e,t,r,i=[]){this.bound??=_n(this.device,this.pipeline,1,t),fe(e,this.pipeline,[this.part,this.bound,...i],r)}delete(){for(let e of this.buffers)e.destroy()}};function Ta(n,[e,t]){let r=e+1,i=n.reduce((c,l)=>c+l,0)/n.length||1,s=eh(n,e,t,i),o=new Uint16Array(4*t*r*19);for(let c=0;c<19;c++){let l=.25*2**(c/2);for(let f=0;f<r;f++){let h=th(s,Math.PI*f/e,e,t/2,l);rh(o,4*t*(c*r+f),h,t)}}return{texels:o,width:t,height:r,levels:19,unit:i}}var Sa=n=>Float64Array.from({length:n},(e,t)=>Math.cos(2*Math.PI*t/n)),Na=(n,e)=>2*Math.PI*(Math.cos(Math.PI*n/e)-Math.cos(Math.PI*(n+1)/e));function eh(n,e,t,r){let i=t/2,s=new Float64Array(6*e*i),o=Sa(t);for(let c=0;c<e;c++){let l=Na(c,e)/t;for(let f=0;f<i;f++)for(let h=0;h<t;h++){let m=f*h,g=6*(c*i+f),_=3*(c*t+h),x=l/r*o[m%t],R=l/r*o[(m+.75*t)%t];for(let F=0;F<3;F++)s[g+F]+=n[_+F]*x,s[g+3+F]+=n[_+F]*R}}return s}function th(n,e,t,r,i){let s=new Float64Array(6*r),o=new Float64Array(r),c=0;for(let l=0;l<t;l++){let f=Math.PI*(l+.5)/t,h=Math.exp(i*(Math.cos(e-f)-1));if(!(h<1e-6)){nh(i*Math.sin(e)*Math.sin(f),o),c+=h*o[0]*Na(l,t);for(let m=0;m<r&&o[m]>1e-6;m++){let g=h*o[m]*(m?2:1),_=6*(r*l+m),x=6*m;for(let R=0;R<6;R++)s[x+R]+=g*n[_+R]}}}return s.map(l=>l/c)}function nh(n,e){let t=Math.min(e.length-1,Math.ceil(8+6*Math.sqrt(n))),r=0;for(let o=t+8;o>0;o--)r=n/(2*o+n*r),o<=t&&(e[o]=r);let i=1,s=1;for(let o=1;o<=t;o++)i*=e[o],e[o]=i,s+=2*i;e[0]=1;for(let o=0;o<=t;o++)e[o]/=s;e.fill(0,t+1)}function rh(n,e,t,r){let i=Sa(r),s=r/2;for(;s>1&&t.subarray(6*s-6,6*s).every(o=>Math.abs(o)<1e-6);)s-=1;for(let o=0;o<r;o++){let c=0,l=0,f=0;for(let h=0,m=0,g=0;h<s;h++,m=(m+o)%r,g+=6){let _=i[m],x=i[(m+.75*r)%r];c+=t[g]*_+t[g+3]*x,l+=t[g+1]*_+t[g+4]*x,f+=t[g+2]*_+t[g+5]*x}[c,l,f].forEach((h,m)=>{n[e+4*o+m]=sh(h)})}}var Ia=new Float32Array(1),ih=new Uint32Array(Ia.buffer);function sh(n){return Ia[0]=Math.max(n,0),Math.max(0,Math.min(31743,(ih[0]+4096>>>13)-114688))}var[Oa,Ma,Bi]=["uniform","storage","read-only-storage"],wr=class n{static async make(e,{harmonics:t,points:r}){let i=new n,{device:s,pipelines:o,bandPixels:c}=e;return Object.assign(i,{device:s,engine:e,rest:null}),i.harmonics=te(s,t??4*r.length,void 0,"the asset's visibility"),i.columns=te(s,4*Ht*c),i.record=te(s,Xe("LobeLight"),GPUBufferUsage.UNIFORM),i.layouts=[ke(s,{0:Oa}),ke(s,{0:Ma,1:Oa}),ke(s,{0:Bi,1:Bi,2:Bi,3:Ma})],i.tell=await o.get(yt.columns,"tell_visibility",i.layouts),i.sampler=s.createSampler({addressModeU:"repeat",magFilter:"linear",minFilter:"linear"}),i}set({rest:e,turn:t,radiance:r}){let{device:i}=this,{texels:s,width:o,height:c,levels:l,unit:f}=e;this.rest!==e&&(this.texture?.destroy(),this.texture=i.createTexture({size:[o,c,l],format:"rgba16float",usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST}),i.queue.writeTexture({texture:this.texture},s,{bytesPerRow:8*o,rowsPerImage:c},[o,c,l]),this.rest=e),i.queue.writeBuffer(this.record,0,le("LobeLight",{colour:r.map(h=>h*f),levels:l,turn:[Math.cos(t),Math.sin(t)],least_kappa:.25,an_octave:2}))}run(e,{count:t},r){let{engine:{frameRecord:i,band:s,viewRecord:o,geometry:c},device:l,layouts:f}=this;this.groups??=[[i],[s,o],[t,c[1],this.harmonics,this.columns]].map((h,m)=>Me(l,f[m],h)),fe(e,this.tell,this.groups,r)}delete(){for(let e of[this.harmonics,this.columns,this.record,this.texture])e?.destroy()}},yr=class extends Zt{static async make(e,t,r,i,s){let{environment:o}=r,c=o.harmonics?Ht:0,l=await super.of(e,t,jt({...r,planes:o.planes},o,o.inputs,c),i,{constants:{RNA_LOBES:o.lobes,RNA_IS_FIBER:+(r.kind==="fiber"),RNA_VISIBILITY_GROUPS:c/4},parts:[r.kind],kernel:yt.lobes,entryPoint:"light_by_lobes"});return Object.assign(l,{shared:s})}run(e,t,r){let{shared:i,device:s,pipeline:o}=this;if(i.run(e,t,r),this.texture!==i.texture){this.texture=i.texture;let c=[{buffer:i.record},i.texture.createView({dimension:"2d-array"}),i.sampler];this.lit=s.createBindGroup({layout:o.getBindGroupLayout(2),entries:c.map((l,f)=>({binding:f,resource:l}))})}this.dispatch(e,[t.rows,t.answers,t.count,i.columns],r,[this.lit])}};var xn=1<<17,ch=["transport","emission","environment"],xr=class n{static label="WebGPU";static async open(e){let t=new n,r=await Wo();Object.assign(t,{canvas:e,device:r,parts:[],lost:!1,bandPixels:xn}),r.lost.then(({reason:s,message:o})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${o||s})`)}),r.addEventListener("uncapturederror",({error:s})=>{t.error??=s}),t.context=e.getContext("webgpu");let i=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:r,format:i,alphaMode:"opaque",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new _r(r),t.compiled=t._compile(i),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,r=await lr(t,yt.show),[i,s,o]=["uniform","storage","read-only-storage"],c=ke(t,{0:s,1:i});this.rayLayout=[ke(t,{0:i,4:o,5:o}),c,ke(t,{0:o,1:o,2:o,3:o,4:o})],this.queueLayout=[ke(t,{0:i,2:s}),c,ke(t,{0:s,1:s,2:s})],this.lookLayout=[...this.queueLayout.slice(0,2),ke(t,{0:s,1:s})];let[l,f,h,m,g,_]=await Promise.all([...["begin","gather","scatter"].map(x=>this.pipelines.get(yt.queue,x,this.queueLayout)),...["remember","smooth_edges"].map(x=>this.pipelines.get(yt.look,x,this.lookLayout)),t.createRenderPipelineAsync({layout:"auto",vertex:{module:r,entryPoint:"corner"},fragment:{module:r,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{begin:l,gather:f,scatter:h,remember:m,smooth:g},shown:_}),this._makeBand()}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.frameRecord=te(e,le("Frame",{}),t),this.viewRecord=te(e,Xe("View"),t),this.showRecord=te(e,Xe("Show"),t),this.band=te(e,Xe("Pixel")*xn),this.queue={rows:te(e,Xe("RnaRow")*xn),answers:te(e,32*xn),count:te(e,4*(xn+4))},this._bind()}async setAsset(e,t){let{device:r,pipelines:i}=this;this._deleteAsset();let s=(g,_)=>te(r,g,void 0,`the asset's ${_}`);this.geometry=[s(e.nodes,"hierarchy"),s(e.primitives,"geometry"),s(e.points,"geometry"),s(lh(e.extent),"geometry"),s(e.normals,"geometry")],this.lightsAt=e.table.length/4,this.table=te(r,4*e.table.length+Xe("Light")),r.queue.writeBuffer(this.table,0,e.table),this.arrays=e,this._storeImages(),await this.compiled,this.raySources=vr({hasSegments:e.strands>0,hasTextures:e.hasTextures});let{hit:o,light:c}=this.raySources,l=t.every(({environment:g})=>g);this.lobeLight=l?await wr.make(this,e):null;let[f,h,...m]=await Promise.all([i.get(o,"trace_pixels",this.rayLayout),i.get(c,"light_pixels",this.rayLayout),...t.map(g=>this._makePart(g))]);Object.assign(this,{parts:m,hasLobes:l}),this.kernels={hit:f,light:h,...this.queueKernels},this._makeSums()}async _makePart(e){let{device:t,pipelines:r}=this,i=g=>[0,1,2].map(_=>te(t,pr(g,_),void 0,"a plane of features")),s=i(e.planes),{environment:o}=e,c=this.lobeLight&&o.planes!==e.planes?i(o.planes):null,l=(g,_)=>Zt.make(t,r,e,g,_,s),[f,h,m]=await Promise.all([l(e.transport,e.inputs),e.emission&&l(e.emission,e.emission.inputs),this.lobeLight&&yr.make(t,r,e,c??s,this.lobeLight)]);return{planes:[...s,...c??[]],transport:f,emission:h,environment:m}}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment(e){this.environment=e,this._storeImages(),this._bind()}_storeImages(){if(!this.geometry)return;let{images:e}=this.arrays,t=this.environment?.floats??new Float32Array(0);this.images?.destroy(),this.images=te(this.device,4*(e.length+t.length),void 0,"the environment"),this.device.queue.writeBuffer(this.images,0,e),this.device.queue.writeBuffer(this.images,4*e.length,t)}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let r=e*t;this.target={width:e,height:t},!(this.sums&&r<=this.capacity&&r*8>=this.capacity)&&(this.capacity=r,this._makeSums())}_makeSums(){if(!this.capacity)return;for(let r of[this.sums,this.firstLook,this.seen])r?.destroy();let e=r=>te(this.device,16*r,void 0,"the picture"),t=this.hasLobes?this.capacity:1;Object.assign(this,{sums:e(this.capacity),firstLook:e(t),seen:e(t)}),this._bind()}_bind(){if(!this.geometry||!this.sums||!this.band||!this.kernels)return;let{device:e,rayLayout:t,queueLayout:r,queue:i}=this,s=Me(e,t[1],{0:this.band,1:this.viewRecord}),o=Me(e,r[2],[i.rows,i.answers,i.count]),c=Me(e,r[0],{0:this.frameRecord,2:this.sums});this.groups={rays:[Me(e,t[0],{0:this.frameRecord,4:this.table,5:this.images}),s,Me(e,t[2],this.geometry)],queue:[c,s,o],look:[c,s,Me(e,this.lookLayout[2],[this.seen,this.firstLook])],show:_n(e,this.shown,0,[this.showRecord,this.sums,this.firstLook])}}trace(e,t,r,i){let{width:s}=this.target;this.span={first:r*s,pixels:(i-r)*s,jitter:e.jitter??1,shift:e.shift??[0,0]},this._writeFrame(e,t),this._writeView({}),this._run(o=>fe(o,this.kernels.hit,this.groups.rays,this.span.pixels))}light(e,{isFirst:t,countsCoverage:r}){this._writeLight(e),this.view={...e,isFirst:t,countsCoverage:r},this._writeView(this.view),this._run(i=>{fe(i,this.kernels.light,this.groups.rays,this.span.pixels),fe(i,this.kernels.begin,this.groups.queue,this.span.pixels)}),e.kind==="mirror"&&this.lobeLight.set(e),this._decode(e.kind==="mirror"?"environment":"transport")}emission(){this._decode("emission")}remember(){this._run(e=>fe(e,this.kernels.remember,this.groups.look,this.span.pixels))}smoothEdges(e,t){this._writeView({shares:e,isFirst:t}),this._run(r=>fe(r,this.kernels.smooth,this.groups.look,this.span.pixels))}show({rounds:e,firstLook:t,exposure:r,backdrop:i,filmic:s,spread:o}){let{width:c,height:l}=this.target,{canvas:f,device:h}=this;h.queue.writeBuffer(this.showRecord,0,le("Show",{size:[f.width,f.height],picture:[c,l],backdrop:i,rounds:e,exposure:r,filmic:Number(s),spread:o,first_look:t}));let m=h.createCommandEncoder(),g=this.context.getCurrentTexture().createView(),_=m.beginRenderPass({colorAttachments:[{view:g,loadOp:"clear",storeOp:"store"}]});_.setPipeline(this.shown),_.setBindGroup(0,this.groups.show),_.draw(3),_.end(),h.queue.submit([m.finish()])}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await wn(this.device,this.sums,16*e*t))}_decode(e){for(let[t,r]of this.parts.entries()){let i=r[e];i&&(this._writeView({...this.view,part:t+1,form:ch.indexOf(e)}),this.device.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(s=>{fe(s,this.kernels.gather,this.groups.queue,this.span.pixels),i.run(s,this.queue,this.span.pixels),fe(s,this.kernels.scatter,this.groups.queue,this.span.pixels)}))}}_run(e){let t=this.device.createCommandEncoder(),r=t.beginComputePass();e(r),r.end(),this.device.queue.submit([t.finish()])}_writeFrame({position:e,corner:t,stepX:r,stepY:i},s){let{lightsAt:o,arrays:c,span:l,target:f}=this;this.device.queue.writeBuffer(this.frameRecord,0,le("Frame",{camera:e,corner:t,step_x:r,step_y:i,width:f.width,paths:l.pixels,sample:s,branches:1,depth:1,rays:se.CAMERA_RAY,flags:c.transmits?se.TRANSMITS:0,textures:c.texturesAt,lights:o}))}_writeView({kind:e="sun",direction:t=[0,0,0],colour:r=[0,0,0],ground:i,isFirst:s=!1,countsCoverage:o=!1,part:c=0,form:l=0,shares:f=1}){let{first:h,jitter:m,shift:g=[0,0]}=this.span,{width:_,height:x}=this.target,R=i&&{ground:i.height,ground_colour:i.colour,ground_size:i.size,middle:[i.x,i.z]};this.device.queue.writeBuffer(this.viewRecord,0,le("View",{first:h,jitter:m,kind:cn[e],is_first:Number(s),direction:t,counts_coverage:Number(o),colour:r,part:c,form:l,shift:g,pixels:_*x,shares:f,...R}))}_writeLight({angle:e,colour:t}){if(e===void 0)return;let{width:r,height:i,total:s,places:o}=this.environment,c={turn_cosine:Math.cos(e),turn_sine:Math.sin(e)},l=ds("image",{colour:t,...c,total:s,rows:i,columns:r});this.device.queue.writeBuffer(this.table,16*this.lightsAt,le("Light",{kind:se.IMAGE,group:se.NONE,numbers:l,places:o.map(f=>f+this.arrays.images.length)}))}_deleteAsset(){for(let e of[...this.geometry??[],this.table,this.images])e?.destroy();this.lobeLight?.delete();for(let{planes:e,...t}of this.parts){e.forEach(r=>r.destroy());for(let r of Object.values(t))r?.delete()}this.parts=[],this.geometry=this.images=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}},lh=n=>le("RnaInstance",{to_object:[1,0,0,0,0,1,0,0,0,0,1,0],rotation:[1,0,0,0,0,1,0,0,0,0,1,0],scale:1,root:1,rays:se.CAMERA_RAY,extent:n});var uh={webgpu:xr,webgl2:dr};async function La(n,e){let t=[];for(let[r,i]of Object.entries(uh))if(!(e&&e!==r))try{let s=n();return{engine:await i.open(s),canvas:s,reasons:t}}catch(s){t.push(s.message)}throw new H(`this browser shows the poster alone: ${t.join("; ")||`no engine ${e}`}`)}var Vt=.4*Math.PI/180,Yt=5*Math.PI/180;function Fa(n,e,t=()=>!0){let r=new Map,i=null;n.addEventListener("pointerdown",o=>{t(o)&&(r.set(o.pointerId,{x:o.clientX,y:o.clientY}),fh(n,o.pointerId),n.classList.add("dragging"),r.size===2?i="two":r.size===1&&(i=o.button===2?"pan":o.button!==0?null:o.altKey||o.shiftKey?"light":"orbit"))}),n.addEventListener("pointermove",o=>{let c=r.get(o.pointerId);if(!c)return;let l={x:o.clientX,y:o.clientY},f=l.x-c.x,h=l.y-c.y;i==="two"&&hh(r,o.pointerId,c,l,e),r.set(o.pointerId,l),!(!f&&!h)&&(i==="orbit"&&e.orbit(-f*Vt,h*Vt,!0),i==="light"&&e.light(f*Vt,-h*Vt,!0),i==="pan"&&e.pan(-f/n.clientHeight,h/n.clientHeight,!0))});for(let o of["pointerup","pointercancel"])n.addEventListener(o,c=>{r.delete(c.pointerId)&&(r.size||(i=null,n.classList.remove("dragging"),e.settle()))});n.addEventListener("contextmenu",o=>t(o)&&o.preventDefault()),n.addEventListener("dblclick",o=>t(o)&&e.reset());let s=0;n.addEventListener("wheel",o=>{if(!t(o))return;o.preventDefault();let c=o.deltaMode===0?o.deltaY:o.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,c))*.0012),!0),clearTimeout(s),s=setTimeout(()=>e.settle(),200)},{passive:!1}),n.addEventListener("keydown",o=>t(o)&&ph(o,e))}function fh(n,e){try{n.setPointerCapture(e)}catch{}}function hh(n,e,t,r,i){let s=[...n].find(([c])=>c!==e)?.[1];if(!s)return;let o=c=>Math.hypot(c.x-s.x,c.y-s.y)||1;i.zoom(o(t)/o(r),!0),i.light(.5*(r.x-t.x)*Vt,-.5*(r.y-t.y)*Vt,!0)}function ph(n,e){if(n.ctrlKey||n.metaKey)return;let t=n.altKey||n.shiftKey?e.light:e.orbit,r={ArrowLeft:()=>t(-Yt,0),ArrowRight:()=>t(Yt,0),ArrowUp:()=>t(0,Yt),ArrowDown:()=>t(0,-Yt),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),"[":()=>e.light(-Yt,0),"]":()=>e.light(Yt,0),Home:()=>e.reset()};Object.hasOwn(r,n.key)&&(n.preventDefault(),r[n.key]())}function Pa(n,e){let{cameraControls:t,disableZoom:r,wheelZoom:i}=n.settings;if(!t||e.type!=="wheel")return t;let s=n.place.getRootNode().activeElement===n.canvas;return!r&&(i==="always"||s||e.ctrlKey||e.metaKey)}function za(n){let e=(t,r)=>(...i)=>{n.settings[r]||(t(...i),n.isTouched=!0,n.viewer.restart(i.at(-1)===!0),n.tell("camera",{byUser:!0}))};return{orbit:e((t,r)=>n.orbit.turn(t,r)),pan:e((t,r)=>n.orbit.pan(t,r),"disablePan"),zoom:e(t=>n.orbit.zoom(t),"disableZoom"),light:(t,r,i)=>{if(n.settings.disableLight)return;let s=Bn(n.lighting.rotation+t*180/Math.PI),o=is(n.lighting.sunHeight+r*180/Math.PI,-10,90);n.setLight({rotation:s,sunHeight:o},{moving:i===!0,byUser:!0})},settle:()=>n.viewer.moving&&n.viewer.restart(),reset:()=>n.reset()}}var Ca=[[1,3],[-3,1],[3,-1],[-1,-3]].map(n=>n.map(e=>e/8)),mh={kind:"sun",direction:[0,1,0],colour:[0,0,0]},br=class extends EventTarget{constructor(e,t,r){super(),Object.assign(this,{engine:e,canvas:t,orbit:r}),Object.assign(this,{lights:[],firstLights:null,ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,ready:!1,stopped:!1,moving:!1,resting:!1,backdrop:[0,0,0],stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1){this.moving=e,Object.assign(this.stats,{rounds:0,scale:0}),this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}rest(e){this.resting=e,e||this.rouse?.()}stop(){return this.stopped=!0,this.rest(!1),this.pause(),this.wake?.(),this.running}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await new Promise(t=>this.addEventListener("shown",t,{once:!0}))}show(){if(!this.shown)return;let{rounds:e,firstLook:t}=this.shown,r=this.denoise&&e<12&&!t;this.engine.show({rounds:e,firstLook:t,exposure:2**this.exposure,backdrop:this.backdrop,filmic:this.view==="filmic",spread:r?.4/Math.sqrt(e):0})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){for(let t of this._scales()){let r=t===1&&!this.moving?this.rounds:+!this.firstLights;if(!await this._stage(e,t,r)||this.moving)return}}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,(this.firstLights??this.lights).length),t=1;for(;t<16&&e*this.msPerPixel/t**2>110;)t*=2;let r=[t];for(;t>1;)r.push(t=t>4?t/4:1);return r}async _stage(e,t,r){let{engine:i,canvas:s}=this,o=Math.ceil(s.width/t),c=Math.ceil(s.height/t);this.shown=null,i.resize(o,c);let l={...this.orbit.camera(o,c),jitter:this.jitter},{firstLights:f}=this;if(f){let h=performance.now();if(!await this._look(e,{...l,jitter:0}))return!1;this._present(0,t,1),this._measure(performance.now()-h,o*c,f.length)}else if(!this.hasShown){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(1,t,0)}for(let h=0;h<r;h++){let m=performance.now();if(!await this._round(e,l,h,this.lights))return!1;let g=performance.now()-m;this._present(h+1,t,f?dh(h+1):0),this._measure(g,o*c,this.lights.length),t===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*g:g)}return!0}_round(e,t,r,i){return this._bands(e,i.length,(s,o)=>this._band(t,r,i,s,o))}async _look(e,t){let{engine:r,firstLights:i}=this;return await this._bands(e,i.length,(o,c)=>{this._band(t,0,i,o,c),r.remember()})?this._bands(e,1,(o,c)=>Ca.forEach((l,f)=>{r.trace({...t,shift:l},0,o,c),r.smoothEdges(Ca.length,f===0)})):!1}async _bands(e,t,r){let{engine:i}=this,{width:s,height:o}=i.target,c=this.msPerPixel*s*Math.max(1,t),l=Math.max(1,Math.min(o,Math.floor(120/c),Math.floor(i.bandPixels/s)));for(let f=0;f<o;f+=l)if(this.resting&&await new Promise(h=>{this.rouse=h}),r(f,Math.min(o,f+l)),await i.done(),e!==this.generation||this.stopped||i.lost)return!1;return!0}_band(e,t,r,i,s){let{engine:o}=this;o.trace(e,t,i,s),(r.length?r:[mh]).forEach((l,f)=>o.light({...l,ground:this.ground},{isFirst:t===0&&f===0,countsCoverage:f===0})),o.emits&&o.emission()}_present(e,t,r){this.shown={rounds:e,firstLook:r},this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:e,scale:t}),this.dispatchEvent(new Event("shown"))}_measure(e,t,r){let i=e/(t*Math.max(1,r));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,i):.5*(this.msPerPixel+i)}},dh=n=>Math.max(0,1-n/64)/(1+n/8);var gh=22e5,vh=4,_h=6e4,Ar=class extends EventTarget{constructor(e,t,r){super(),Object.assign(this,{place:e,notices:t,settings:r,losses:0,lives:0,isResting:!1}),this.look={exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1},new ResizeObserver(()=>this.resize()).observe(e)}begin(){let{samples:e,jitter:t}=this.settings;return Object.assign(this.look,e&&{rounds:e},t!==null&&{jitter:t}),this.replace(this.settings.api)}end(){this.lives+=1,this.begun=Promise.resolve(!1),this.viewer?.stop(),this.engine?.close(),Object.assign(this,{viewer:null,engine:null})}replace(e,t){this.end(),Object.assign(this,{api:e,since:performance.now()});let r=this._begin(e,t).then(()=>r===this.begun?!!this.engine:this.begun,i=>r!==this.begun?this.begun:this.canFallBack?this.replace("webgl2",bn(i)):(this.end(),this.failed(i,"engine"),!1));return this.begun=r}async _begin(e,t){let r=this.lives,{engine:i,canvas:s,reasons:o}=await La(()=>document.createElement("canvas"),e);if(r!==this.lives)return i.close();Object.assign(this,{engine:i,canvas:s}),this.place.replaceChildren(s),i.onlost=c=>this._lost(i,c),this.viewer=Object.assign(new br(i,s,this.orbit),this.look,{resting:this.isResting}),this.viewer.addEventListener("shown",()=>this.pictured()),this.viewer.addEventListener("failed",({error:c})=>this._pictureFailed(i,c)),performance.mark("engine"),Fa(s,za(this),c=>Pa(this,c)),this.tell("engine",{label:i.constructor.label,reasons:[...t?[t]:[],...o]}),this.resize(),await this.restore(i)}rest(e){this.isResting=e,this.viewer?.rest(e)}resize(){if(!this.viewer)return;let{clientWidth:e,clientHeight:t}=this.place,r=this.settings.pixelRatio??Math.min(devicePixelRatio,2),i=Math.min(r,Math.sqrt(gh/Math.max(1,e*t))),s=Math.max(1,Math.round(e*i)),o=Math.max(1,Math.round(t*i));this.canvas.width===s&&this.canvas.height===o||(Object.assign(this.canvas,{width:s,height:o}),this.resized(),this.viewer.restart())}get wgsl(){return{compose:gr,sharedFiles:lt,rayKernels:vr}}reader(){return this.viewer.pause(),new ur(this.engine)}screenshot(e="image/png",t=void 0){return this.viewer.show(),new Promise(r=>this.canvas.toBlob(r,e,t))}async _lost(e,t){if(e!==this.engine)return;if(this.losses=performance.now()-this.since>_h?1:this.losses+1,this.losses>=vh)return this.end(),this.failed(new H(`${t}, ${this.losses} times`),"engine");this.notices.say(`${t}; starting again`,!0,"engine");let r=this.losses>1?this.settings.api??"webgl2":this.api;await this.replace(r,this.losses>1&&t)&&this.notices.say(null,!1,"engine")}async _pictureFailed(e,t){if(e===this.engine){if(!this.canFallBack)return this.failed(t,"asset");await this.replace("webgl2",bn(t))}}get canFallBack(){return this.engine?.constructor.label==="WebGPU"&&!this.settings.api}tell(e,t){this.dispatchEvent(Object.assign(new Event(e),t))}failed(e,t){Ua(e)||console.error(e),this.notices.say(bn(e),!1,t),this.failures=(this.failures??0)+1,this.tell("failed",{error:e,about:t})}},Ua=n=>n instanceof tn||n instanceof H,bn=n=>Ua(n)?n.message:`this did not work: ${n.message??n}`;var Fe=[64,128],Ha=[64,128],wh=512,yh=4,Da=8,xh=Math.cos(15*Math.PI/180),bh=200,xt=Fe[0]*Fe[1];function Ba(n){let e=Ah(n),t=Rh(e),{flux:r,sums:i,directions:s}=Eh(e.rgb,t),{excess:o,share:c}=kh(r),l=Th(o),f=new Uint8Array(xt);for(let g of l)for(let _ of g)f[_]=1;let{radiance:h,up:m}=Oh(e.rgb,t,g=>f[g]?1-c[g]:1);return{lights:l.map(g=>Ih(g,o,_=>i[_]*c[Math.floor(_/3)],s)),up:m,rest:Ta(h,Ha)}}function Ah({rgb:n,width:e,height:t}){let r=Math.ceil(wh/e);if(r<=1)return{rgb:n,width:e,height:t};let i=r*e,s=r*t,o=new Float32Array(3*i*s);for(let c=0;c<s;c++){let l=(c+.5)/r-.5,f=Math.floor(l),h=l-f,m=[Math.max(f,0),Math.min(f+1,t-1)];for(let g=0;g<i;g++){let _=(g+.5)/r-.5,x=Math.floor(_),R=_-x,F=[(x+e)%e,(x+1)%e];for(let W=0;W<3;W++){let $=(qe,je)=>n[3*(m[qe]*e+F[je])+W],V=$(0,0)+R*($(0,1)-$(0,0)),ne=$(1,0)+R*($(1,1)-$(1,0));o[3*(c*i+g)+W]=V+h*(ne-V)}}}return{rgb:o,width:i,height:s}}function Rh({width:n,height:e}){let t=new Float64Array(e),r=new Int32Array(e);for(let i=0;i<e;i++){let s=Math.PI*(i+.5)/e;t[i]=2*Math.PI/n*(Math.cos(Math.PI*i/e)-Math.cos(Math.PI*(i+1)/e)),r[i]=Math.min(Fe[0]-1,Math.floor((1-Math.cos(s))/2*Fe[0]))}return{width:n,height:e,solid:t,rows:r}}var Ga=({rows:n,width:e},t,r)=>n[t]*Fe[1]+Math.floor(r/e*Fe[1]);function Eh(n,e){let t=new Float64Array(3*xt),r=new Float64Array(xt),i=new Float64Array(3*xt);for(let o=0,c=0;o<e.height;o++){let l=Math.PI*(o+.5)/e.height,f=e.solid[o],h=Math.sin(l),m=Math.cos(l);for(let g=0;g<e.width;g++,c+=3){let _=Ga(e,o,g),x=2*Math.PI*(g+.5)/e.width-Math.PI;r[_]+=f;for(let F=0;F<3;F++)t[3*_+F]+=n[c+F]*f;let R=Pe(n,c/3)*f;i[3*_]+=R*h*Math.sin(x),i[3*_+1]+=R*m,i[3*_+2]-=R*h*Math.cos(x)}}return{flux:t.map((o,c)=>o/r[Math.floor(c/3)]*(4*Math.PI/xt)),sums:t,directions:i}}var Pe=(n,e)=>(n[3*e]+n[3*e+1]+n[3*e+2])/3;function kh(n){let e=yh*n.reduce((r,i)=>r+i,0)/n.length,t=Float64Array.from({length:xt},(r,i)=>Math.max(0,1-e/Math.max(Pe(n,i),1e-30)));return{share:t,excess:n.map((r,i)=>r*t[Math.floor(i/3)])}}function An(n){let e=1-2*(Math.floor(n/Fe[1])+.5)/Fe[0],t=Math.sqrt(1-e*e),r=2*Math.PI*(n%Fe[1]+.5)/Fe[1]-Math.PI;return[t*Math.sin(r),e,-t*Math.cos(r)]}var $i=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2];function Gi(n,e){let t=[0,0,0],r=0;for(let s of n){let o=Pe(e,s);r+=o,An(s).forEach((c,l)=>{t[l]+=o*c})}let i=Math.hypot(...t)||1;return{flux:r,size:i,direction:t.map(s=>s/i)}}function Th(n){let e=[];for(let i=0;i<xt;i++)Pe(n,i)>0&&e.push(i);e.sort((i,s)=>Pe(n,s)-Pe(n,i));let t=[],r=i=>e.filter(s=>$i(An(s),i)>xh);for(;e.length&&t.length<Da;){let s=e.slice(0,bh).map(c=>Gi(r(An(c)),n)).reduce((c,l)=>l.flux>c.flux?l:c),o=new Set(r(s.direction));t.push([...o]),e=e.filter(c=>!o.has(c))}for(;t.length&&t.length<Da&&Sh(t,n););return t}function Sh(n,e){let t=m=>{let{flux:g,size:_}=Gi(m,e);return g-_},r=n.reduce((m,g)=>t(g)>t(m)?g:m),{direction:i}=Gi(r,e),s=Nh(r,e,i),o=r.map(m=>$i(An(m),s)),c=0,l=0;r.forEach((m,g)=>{c+=Pe(e,m)*o[g],l+=Pe(e,m)});let[f,h]=[!0,!1].map(m=>r.filter((g,_)=>o[_]*l>c===m));return!f.length||!h.length?!1:(n.splice(n.indexOf(r),1,f,h),!0)}function Nh(n,e,t){let r=[[0,0,0],[0,0,0],[0,0,0]];for(let s of n){let o=An(s).map((l,f)=>l-t[f]),c=Pe(e,s);for(let l=0;l<3;l++)for(let f=0;f<3;f++)r[l][f]+=c*o[l]*o[f]}let i=[.6,.5,.62];for(let s=0;s<60;s++){let o=r.map(l=>$i(l,i)),c=Math.hypot(...o);if(!c)break;i=o.map(l=>l/c)}return i}function Ih(n,e,t,r){let i=[0,1,2].map(c=>n.reduce((l,f)=>l+t(3*f+c),0)),s=[0,0,0];for(let c of n){let l=r.subarray(3*c,3*c+3),f=Pe(e,c)/Math.hypot(...l);l.forEach((h,m)=>{s[m]+=f*h})}let o=Math.hypot(...s);return{direction:s.map(c=>c/o),colour:i}}function Oh(n,e,t){let[r,i]=Ha,s=new Float64Array(3*r*i),o=new Float64Array(r*i),c=[0,0,0];for(let l=0,f=0;l<e.height;l++){let h=Math.max(0,Math.cos(Math.PI*(l+.5)/e.height)),m=e.solid[l];for(let g=0;g<e.width;g++,f+=3){let _=Math.floor(l/e.height*r)*i+Math.floor(g/e.width*i),x=m*t(Ga(e,l,g));o[_]+=m;for(let R=0;R<3;R++)s[3*_+R]+=x*n[f+R],c[R]+=x*h*n[f+R]}}return{radiance:s.map((l,f)=>l/o[Math.floor(f/3)]),up:c}}var Mh={studio:["Studio",Ts],white:["White from all sides",()=>Jn([1,1,1])]},Lh=[1.06,1,.9],Rr=Math.PI/180,Er=class{constructor(){this.images=new Map(Object.entries(Mh).map(([e,[t,r]])=>[e,{label:t,make:r}])),this.choice="studio",this.turntable=0,this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:[],imageTurn:0})}add(e,t){let r=`image-${this.images.size}`;return this.images.set(r,{label:e,make:()=>t}),r}tables(){let e=this.images.get(this.choice);return e.tables??=ks(e.make()),e.tables}firstLights(){if(!(this.strength>0))return null;let e=this.images.get(this.choice),t=this._turn(),{lights:r,rest:i,up:s}=e.first??=Ba(e.make()),o=l=>l.map(f=>f*this.strength),c=r.map(({direction:l,colour:f})=>({kind:"sun",direction:$a(l,t),colour:o(f)}));return[...this._suns(),...c,{kind:"mirror",colour:o(s),radiance:o([1,1,1]),turn:t,rest:i}]}lights(){let e=this._suns(),t=[0,0,0];for(let{direction:r,colour:i}of e)i.forEach((s,o)=>{t[o]+=s*Math.max(0,r[1])});if(this.strength>0){let r=[this.strength,this.strength,this.strength],i=this._turn();e.push({kind:"environment",colour:r,angle:i},{kind:"aroundPoint",colour:r,angle:i}),this.tables().up.forEach((s,o)=>{t[o]+=s*this.strength})}return{lights:e,irradiance:t}}_turn(){return(this.rotation+this.turntable+this.imageTurn)*Rr}_suns(){let e=(this.rotation+this.turntable)*Rr;return(this.suns??[this._sun()]).filter(({irradiance:t})=>t.some(r=>r>0)).map(({direction:t,irradiance:r})=>({kind:"sun",direction:$a(t,e),colour:r}))}_sun(){let e=this.sunHeight*Rr,t=this.sunAzimuth*Rr;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:Lh.map(r=>r*this.sun)}}};function $a([n,e,t],r){let i=Math.cos(r),s=Math.sin(r),o=Math.hypot(n,e,t);return[(i*n+s*t)/o,e/o,(i*t-s*n)/o]}var qa=(n,e)=>n.reduce((t,r,i)=>t+r*e[i],0),Fh=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],Ph=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function zh(n){let e=Fh.map(t=>{let r=1.461926*qa(t,n);return(r*(r+.0245786)-90537e-9)/(r*(.983729*r+.432951)+.238081)});return Ph.map(t=>qa(t,e))}function ja(n){let e=[...n];for(let t=0;t<60;t++){let r=zh(e);e=e.map((i,s)=>i*Math.min(2,Math.max(.5,n[s]/Math.max(r[s],1e-6))))}return e}var kr=class extends Ar{constructor(e,t,r){super(e,t,r),Object.assign(this,{orbit:new Gn,lighting:new Er,labels:{},ground:!1,scene:null,isTouched:!1}),Object.assign(this,{opened:null,shown:null,loading:null,lit:Promise.resolve(),placing:Promise.resolve()})}close(){this.loading?.abort(),this.end()}async open(e){this.loading?.abort();let t=this.loading=new AbortController,{signal:r}=t;try{this.notices.say(null,!1,"asset"),this.tell("loading");let i=(c,l)=>r.aborted||this.tell("progress",{got:c,all:l}),s=e instanceof Blob?new kt(e,e.name):await Dn.open(e,i,r,this.labels[nn(e)]),o=await Gt.open(s);r.throwIfAborted(),await this._offerPoster(o),await this._show(o,this.settings.tier,!0,r)}catch(i){r.aborted||this.failed(i,"asset")}finally{this.loading===t&&(this.loading=null,this.tell("ended"))}}async switchTier(e){try{this.notices.say(null,!1,"asset"),await this._show(this.opened,e,!1)}catch(t){this.failed(t,"asset")}finally{this.tell("ended")}}async openScene(e){try{let t=JSON.parse(new TextDecoder().decode(await qi(e))),{radiance:r,image:i}=t.environment??{},s=o=>new URL(Ws(o),new URL(e,document.baseURI)).href;if(t.asset&&(t.asset=s(t.asset)),r&&(t.environment.key=this.lighting.add("The scene's",Jn(r))),i){let o=this.labels[i]??i;t.environment.key=this.lighting.add(o,li(await qi(s(i)),i))}return this.scene=t,this.reset(),t}catch(t){return this.failed(t,"scene"),null}}openImage(e,t){return this.lit=this._openImage(e,t)}async _openImage(e,t){let r=this.askedImage={};try{this.notices.say(null,!1,"light");let i=e instanceof Blob?await e.arrayBuffer():await qi(e);if(r!==this.askedImage)return;this.setLight({choice:this.lighting.add(this.labels[t]??t,li(i,t))})}catch(i){r===this.askedImage&&this.failed(i,"light")}}chooseImage(e){this.askedImage=null,this.setLight({choice:e})}setLight(e,{moving:t=!1,byUser:r=!1}={}){Object.assign(this.lighting,e),this.tell("set"),this.tell("light",{byUser:r}),this.changed(t)}changed(e=!1){if(!this.viewer)return;let{lights:t,irradiance:r}=this.lighting.lights();t.some(({kind:i})=>i==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.backdrop=Go(this.place),this.viewer.lights=t,this.viewer.firstLights=this.engine.hasLobes?this.lighting.firstLights():null,this.viewer.ground=this._ground(r),this.viewer.restart(e)}reset(){let{ground:e,exposure:t,view:r}=this.scene??{},{settings:i}=this;this.placeCamera(),this.placeLights(),this.ground=i.ground??e??this.ground,this.setExposure(i.exposure??t??this.look.exposure),this.setView(i.viewTransform??r??this.look.view)}placeCamera(){let{position:e,look_at:t,vertical_fov_deg:r}=this.scene?.camera??{},{settings:i}=this,s=[e?cs(e,t,r):{},i.cameraOrbit??{},{target:i.cameraTarget,fov:i.fieldOfView}];this.isTouched=!1;let{width:o,height:c}=this.canvas??{width:1,height:1};this.orbit.place(s,this.box,o/c,i.autoRotate),this.tell("camera",{byUser:!1}),this.viewer?.restart()}placeLights(){let{suns:e,environment:t}=this.scene??{},{sun:r,lightRotation:i,environmentIntensity:s}=this.settings,{lighting:o}=this;if(o.reset(),e&&(o.suns=e),t){let{key:c,strength:l=1,rotation_deg:f=0}=t,h=!this.settings.environment&&c||o.choice;Object.assign(o,{choice:h,strength:l,imageTurn:f})}r&&Object.assign(o,r,{suns:null}),this.setLight({rotation:Bn(i??0),strength:s??o.strength})}turnTable(e,t){this.orbit.turntable=-e,this.lighting.turntable=-e*180/Math.PI,this.changed(t)}setExposure(e,t=!0){this._setLook({exposure:e},t&&this.ground)}setView(e){this._setLook({view:e},this.ground)}setDenoise(e){this._setLook({denoise:e})}setGround(e){this.ground=e,this.changed()}_setLook(e,t=!1){Object.assign(this.look,e),Object.assign(this.viewer??{},e),this.tell("set"),t&&this.changed(),this.viewer?.show()}async _show(e,t,r,i){let s=await e.load(t,{wantsLobes:this.settings.firstLook!=="off"});e.forget(),performance.mark("package"),await this.lit,await this.begun&&(this.placing=this.placing.catch(()=>{}).then(()=>this._place(e,s,r,i)),await this.placing)}async _place(e,t,r,i){if(i?.throwIfAborted(),!this.viewer||!r&&this.opened!==e)return;r&&(this.viewer.hasShown=!1),this.viewer.pause();let s=r?Kn(t.parts):this.arrays;if(performance.mark("hierarchy"),!await this._upload(s,t))return;performance.mark("asset"),Object.assign(this,{opened:e,shown:t,arrays:s,box:s.box,isNew:r}),r&&this.scene?this.reset():r&&this.placeCamera();let{warnings:o}=e.manifest;o.length&&this.notices.say(o.join("; "),!0,"asset"),this.tell("package",{opened:e,shown:t}),this.viewer.stats.ms=0,this.changed(),this.viewer.start()}async _upload(e,{parts:t}){for(;await this.begun&&this.engine;){let{engine:r}=this;try{if(await r.setAsset(e,t),r===this.engine)return!0}catch(i){if(r!==this.engine)continue;if(!this.canFallBack)throw i;this.shown=null,this.replace("webgl2",bn(i))}}return!1}async restore(e){this.uploaded=null,this.shown&&(this.viewer.hasShown=!0,await e.setAsset(this.arrays,this.shown.parts),this.changed(),this.viewer?.start())}resized(){this.shown&&!this.isTouched&&this.placeCamera()}pictured(){this.tell("shown"),this.isNew&&(this.isNew=!1,this.tell("load"))}async _offerPoster(e){try{this.tell("poster",{blob:await e.posterImage()})}catch{}}_ground(e){if(!this.ground||!this.box)return null;let{view:t,exposure:r}=this.look,{backdrop:i}=this.viewer,s=t==="filmic"?ja(i):i,{min:o,max:c}=this.box,l=Math.hypot(...c.map((f,h)=>f-o[h]));return{height:o[1]-1e-4*l,x:(o[0]+c[0])/2,z:(o[2]+c[2])/2,size:2*l,colour:s.map((f,h)=>e[h]>0?f/e[h]/2**r:0)}}};async function qi(n){let e=await fetch(n).catch(()=>null);if(!e?.ok)throw new H(`cannot load ${n}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var Tr=class{constructor(e){Object.assign(this,{stage:e,angle:0,isOn:!1,isTurning:!1,delay:3e3,speed:30}),e.addEventListener("shown",()=>this._next());for(let t of["load","camera","light"])e.addEventListener(t,()=>this.wait())}wait(){clearTimeout(this.timer);let e=this.isTurning;this.isTurning=!1,this.isOn?this.timer=setTimeout(()=>this._start(),this.delay):e&&this.stage.viewer?.restart()}switch(e){this.isOn=e,this.wait()}set(e){this.angle=e,this.stage.turnTable(e,this.isTurning)}_start(){Object.assign(this,{isTurning:!0,last:performance.now()}),this._next()}_next(){!this.isTurning||this.isAsked||(this.isAsked=!0,requestAnimationFrame(e=>{if(this.isAsked=!1,!this.isTurning)return;let t=Math.min(.25,Math.max(0,e-this.last)/1e3);this.last=e,this.set(this.angle+t*this.speed*Math.PI/180)}))}};var Ch=["studio","white"],Uh="50% 0px",Dh=500,Sr=class extends HTMLElement{static observedAttributes=Object.keys(on);constructor(){super();let e=fs(this),t=r=>e.getElementById(r);this.parts={view:t("view"),poster:t("poster"),image:e.querySelector("img"),loading:t("loading"),bar:t("bar"),bytes:t("bytes"),status:t("status")},this.settings=Object.fromEntries(Object.keys(on).map(r=>[Wn(r),null])),this.notices=new Hn(t("notice")),this.stage=new kr(this.parts.view,this.notices,this.settings),this.turntable=new Tr(this.stage),this.stillness=matchMedia("(prefers-reduced-motion: reduce)"),Object.assign(this,{loaded:!1,observer:null,isNear:!1,isDismissed:!1,isBegun:!1,asked:null}),this._listen()}connectedCallback(){this.stage.labels=JSON.parse(this.dataset.labels??"{}"),this.observer=new IntersectionObserver(e=>this._seen(e.at(-1).isIntersecting),{rootMargin:Uh}),this.observer.observe(this),this.stillness.addEventListener("change",this.onstillness=()=>this._turn()),this._turn(),this._begin()}disconnectedCallback(){this.observer.disconnect(),this.stillness.removeEventListener("change",this.onstillness),queueMicrotask(()=>{this.isConnected||!this.isBegun||(this.stage.loading&&(this.asked=null),this.isBegun=!1,this.turntable.switch(!1),this.stage.close())})}attributeChangedCallback(e,t,r){if(t===r)return;let i=Wn(e);try{this.settings[i]=r===null?null:on[e](r),this.notices.say(null,!0,e)}catch(s){this.settings[i]=null,this.notices.say(`${e}: ${s.message}`,!0,e)}this._apply(e)}get availableTiers(){return this.stage.opened?.manifest.tiers.map(({name:e})=>e)??[]}get turntableRotation(){return this.turntable.angle}resetTurntableRotation(e=0){this.turntable.set(e)}resetView(){this.stage.reset()}showPoster(){this.isDismissed=!1,this.parts.poster.hidden=!1}dismissPoster(){this.isDismissed=!0,this._begin(),this.loaded&&this._hidePoster()}async toBlob({mimeType:e="image/png",qualityArgument:t,converged:r=!1}={}){let{stage:i}=this;return!i.viewer||!this.loaded?null:(r&&await i.viewer.converged(),i.screenshot(e,t))}_seen(e){this.isNear=e,this.stage.rest(!e),this._begin()}_apply(e){let{stage:t,settings:r}=this;e==="src"&&this._begin(),e==="poster"&&this._showImage(r.poster),e==="scene"&&this.isBegun&&this._openScene(),e==="environment"&&this.isBegun&&this._light(),e==="tier"&&t.opened&&r.tier&&t.switchTier(r.tier),["camera-orbit","camera-target","field-of-view"].includes(e)&&t.placeCamera(),["sun","light-rotation","environment-intensity"].includes(e)&&t.placeLights(),e==="ground"&&t.setGround(r.ground??t.scene?.ground??!1),e==="exposure"&&t.setExposure(r.exposure??t.scene?.exposure??0),e==="view-transform"&&t.setView(r.viewTransform??t.scene?.view??"srgb"),e==="pixel-ratio"&&t.resize(),["loading","reveal"].includes(e)&&this._begin(),(e.startsWith("auto-rotate")||e==="rotation-per-second")&&this._turn(),this._describe()}_begin(){let{stage:e,settings:t}=this,r=t.reveal!=="manual"||this.isDismissed;if(this.parts.image.loading=t.loading==="eager"?"eager":"lazy",!(!this.isConnected||!this.observer||!(t.loading==="eager"||this.isNear&&r))){if(!this.isBegun&&(this.isBegun=!0,e.begin(),this._turn(),t.environment&&!this.isLit&&this._light(),t.scene))return void this._openScene();t.src!==this.asked&&this._open()}}_open(){this.asked=this.settings.src,this.asked!==null&&(this.loaded=!1,this.stage.open(this.asked))}async _openScene(){let e=this.askedScene=this.settings.scene;if(e===null)return;let t=await this.stage.openScene(e);e===this.askedScene&&(this.settings.src?this._begin():t?.asset&&this.stage.open(t.asset))}_light(){let{environment:e}=this.settings;this.isLit=!0,e!==null&&!Ch.includes(e)?this.stage.openImage(e,nn(e)):this.stage.chooseImage(e??"studio")}_turn(){let{autoRotate:e,autoRotateDelay:t,rotationPerSecond:r}=this.settings;Object.assign(this.turntable,{delay:t??3e3,speed:r??30}),this.turntable.switch(!!e&&this.isBegun&&!this.stillness.matches)}_listen(){let{stage:e,parts:t}=this,r=(i,s)=>e.addEventListener(i,s);r("engine",()=>this._describe()),r("progress",({got:i,all:s})=>this._showProgress(i,s)),r("poster",({blob:i})=>this.settings.poster||this._showImage(i&&URL.createObjectURL(i))),r("package",()=>this._describe()),r("load",()=>{this.loaded=!0,(this.settings.reveal!=="manual"||this.isDismissed)&&this._hidePoster(),t.status.textContent=`${this._name()} is shown`,this._fire("progress",{totalProgress:1}),this._fire("load",{url:this.asked})}),r("ended",()=>{t.loading.hidden=!0}),r("failed",({error:i,about:s})=>{s==="engine"&&(t.poster.hidden=!1),this._fire("error",{type:s,message:i.message,code:i.code??null,sourceError:i})}),r("camera",({byUser:i})=>{this._fire("camera-change",{...an(e.orbit),source:i?"user-interaction":"none"}),i&&this._speak()}),r("light",({byUser:i})=>this._fire("light-change",{...Zn(e.lighting),source:i?"user-interaction":"none"}))}_speak(){clearTimeout(this.speaking),this.speaking=setTimeout(()=>{this.parts.status.textContent=ps(this.stage.orbit)},Dh)}_showProgress(e,t){let{loading:r,bar:i,bytes:s}=this.parts;r.hidden=!1,t?Object.assign(i,{max:Math.max(t,e),value:e}):i.removeAttribute("value"),s.textContent=t?`${pt(e)} of ${pt(Math.max(t,e))}`:pt(e),this._fire("progress",{totalProgress:t?Math.min(.99,e/t):0})}_showImage(e){let{image:t,poster:r}=this.parts;t.src.startsWith("blob:")&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=e:t.removeAttribute("src"),e&&(r.hidden=!1)}_hidePoster(){let{poster:e}=this.parts;e.hidden||(e.hidden=!0,this._fire("poster-dismissed"))}_name(){return this.settings.alt??this.stage.opened?.manifest.name??"A relightable asset"}_describe(){let{canvas:e}=this.stage,{cameraControls:t,touchAction:r}=this.settings;if(this.parts.image.alt=this._name(),!e)return;e.style.touchAction=t?r??"pan-y":"auto";let i=t?{role:"application",tabindex:0,"aria-describedby":"keys"}:{role:"img"};e.setAttribute("aria-label",this._name());for(let s of["role","tabindex","aria-describedby"])s in i?e.setAttribute(s,i[s]):e.removeAttribute(s)}_fire(e,t=null){this.dispatchEvent(new CustomEvent(e,{detail:t}))}},Hh={cameraOrbit:({stage:n})=>an(n.orbit).cameraOrbit,cameraTarget:({stage:n})=>an(n.orbit).cameraTarget,fieldOfView:({stage:n})=>an(n.orbit).fieldOfView,sun:({stage:n})=>Zn(n.lighting).sun,lightRotation:({stage:n})=>Zn(n.lighting).lightRotation,environmentIntensity:({stage:n})=>n.lighting.strength,exposure:({stage:n})=>n.look.exposure,viewTransform:({stage:n})=>n.look.view,tier:({stage:n,settings:e})=>n.shown?.name??e.tier};for(let[n,e]of Object.entries(on)){let t=Wn(n),r=e===Ve;Object.defineProperty(Sr.prototype,t,{get(){return Hh[t]?.(this)??(r?this.settings[t]===!0:this.settings[t])},set(i){r?this.toggleAttribute(n,!!i):i==null?this.removeAttribute(n):this.setAttribute(n,i)},enumerable:!0,configurable:!0})}customElements.get("rna-viewer")||customElements.define("rna-viewer",Sr);})();
/*! Bundled license information:

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
