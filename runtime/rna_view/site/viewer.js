(()=>{var uu=Object.defineProperty;var wa=(s,e)=>{for(var t in e)uu(s,t,{get:e[t],enumerable:!0})};var fi=class extends Error{constructor(e,t,n){super(`${t?t+": ":""}${n} [${e}]`),this.code=e,this.where=t}};function w(s,e,t){throw new fi(s,e,t)}var ee=class extends Error{};var bs=65536,fu=2**30,An=class{constructor(e,t){this.blob=e,this.name=t,this.size=e.size,this.ranged=!1,this.fetched=e.size}async read(e,t){return new Uint8Array(await this.blob.slice(e,t).arrayBuffer())}},tr=class s{static async open(e,t=()=>{},n,i=Ss(e)){let r=new s;Object.assign(r,{url:e,progress:t,signal:n,fetched:0,name:i});let o=await r._ask({Range:`bytes=0-${bs-1}`}),a=/\/(\d+)$/.exec(o.headers.get("Content-Range")??"");r.ranged=o.status===206&&a!==null;let l=Number(o.headers.get("Content-Length"))||0;r.expected=r.ranged?bs:l;let c=r.ranged?bs:fu;return l>c&&await r._tooLong(o,c),r.head=await r._collect(o,c),r.size=r.ranged?Number(a[1]):r.head.length,r}async read(e,t){if(t<=this.head.length)return this.head.subarray(e,t);if(!this.ranged)return this.head.subarray(e,Math.min(t,this.size));let n=await this._ask({Range:`bytes=${e}-${t-1}`});if(n.status!==206)throw new ee(`${this.name}: the server forgot about ranges`);let i=await this._collect(n,t-e);if(i.length<t-e)throw new ee(`${this.name}: the server sent ${i.length} bytes of ${t-e}`);return i}async _ask(e){let t;try{t=await fetch(this.url,{headers:e,signal:this.signal})}catch(n){if(n.name==="AbortError")throw n;let i=new URL(this.url,location.href).protocol==="file:";throw new ee(i?"a page opened from a file cannot load packages: serve the folder (rna-view, any web server), or drop the .rna file here":`cannot load ${this.url}: no answer, or the server does not allow other sites (CORS)`)}if(!t.ok&&t.status!==416)throw new ee(`cannot load ${this.url}: HTTP ${t.status}`);return t}async _collect(e,t){if(e.status===416||!e.body)return new Uint8Array;let n=[],i=0,r=e.body.getReader();for(;;){let{done:l,value:c}=await r.read();if(l)break;i+=c.length,i>t&&await this._tooLong(r,t),n.push(c),this.fetched+=c.length,this.progress(this.fetched,this.expected)}let o=new Uint8Array(i),a=0;for(let l of n)o.set(l,a),a+=l.length;return o}async _tooLong(e,t){throw await(e.body??e).cancel().catch(()=>{}),new ee(this.ranged?`${this.name}: the server sent more than the ${t} bytes that were asked for`:`${this.name}: more than ${t} bytes from a server without range requests: use rna-view, or a server that has them`)}};function Ss(s){let e=new URL(s,location.href).pathname.split("/").pop();try{return decodeURIComponent(e)||s}catch{return e}}var xe=s=>document.getElementById(s);function ke(s,e,t){xe(s).addEventListener(e,({target:n})=>t(n))}var Ms=new Map;function at(s,e=!1,t="page"){s?Ms.set(t,{text:s,calm:e}):Ms.delete(t);let n=xe("notice"),i=[...Ms.values()];n.hidden=!i.length,n.replaceChildren(...i.map(({text:r})=>Object.assign(document.createElement("span"),{textContent:r}))),n.classList.toggle("calm",i.every(r=>r.calm))}var ba=(s,e,t)=>Math.min(Math.max(s,e),t),Sa=s=>((s+180)%360+360)%360-180;function nr(s,e){let t=Math.abs(s).toFixed(e);return Number(t)===0?t:(s<0?"\u2212":"+")+t}function En(s,e,t){xe(s).value=e,xe(`${s}-value`).textContent=t}function Vt(s){return s<1e6?`${Math.round(s/1e3)} kB`:`${(s/1e6).toFixed(s<1e7?2:1)} MB`}function As(s){return s<10?`${s.toFixed(1)} ms`:s<1e3?`${Math.round(s)} ms`:`${(s/1e3).toFixed(1)} s`}var za=1;var ka=3;var Us=0,Fs=1,Bs=2,zs=3,ks=4,Gs=5,Hs=6,Vs=7,Ga=0,Ha=1,Va=2;var so=1,oo=2,ao=3,lo=4,co=5,ho=6,uo=7;var fo=300;var Wa=302;var Ws=1e3,un=1001,Xs=1002,qs=1003;var Yt=1006;var po=1008;var Xa=1009;var jt=1015,mn=1016;var xt=1023;var Bn=1028;var gn=1030;var vi=2300,pr=2301,ur=2302,$s=2303,Ys=2400,Zs=2401,Ks=2402;var mo="",tt="srgb",ut="srgb-linear",Js="linear",fr="srgb";var qa=35044;var _i=2e3,js=2001;function du(s){for(let e=s.length-1;e>=0;--e)if(s[e]>=65535)return!0;return!1}function pu(s){return ArrayBuffer.isView(s)&&!(s instanceof DataView)}function Qs(s){return document.createElementNS("http://www.w3.org/1999/xhtml",s)}var Ma={},mr=null;function $a(s){let e=s[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=s[1];t&&t.isStackTrace?s[0]+=" "+t.getLocation():s[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return s}function Se(...s){s=$a(s);let e="THREE."+s.shift();if(mr)mr("warn",e,...s);else{let t=s[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...s)}}function ye(...s){s=$a(s);let e="THREE."+s.shift();if(mr)mr("error",e,...s);else{let t=s[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...s)}}function dr(...s){let e=s.join(" ");e in Ma||(Ma[e]=!0,Se(...s))}var mu={[Us]:Us,[Bs]:Hs,[ks]:ks,[zs]:Gs,[Fs]:Fs,[Hs]:Bs,[Vs]:Vs,[Gs]:zs},fn=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let i=n[e];if(i!==void 0){let r=i.indexOf(t);r!==-1&&i.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let i=n.slice(0);for(let r=0,o=i.length;r<o;r++)i[r].call(this,e);e.target=null}}},Le=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var F_=Math.PI/180,gu=180/Math.PI;function Lr(){let s=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Le[s&255]+Le[s>>8&255]+Le[s>>16&255]+Le[s>>24&255]+"-"+Le[e&255]+Le[e>>8&255]+"-"+Le[e>>16&15|64]+Le[e>>24&255]+"-"+Le[t&63|128]+Le[t>>8&255]+"-"+Le[t>>16&255]+Le[t>>24&255]+Le[n&255]+Le[n>>8&255]+Le[n>>16&255]+Le[n>>24&255]).toLowerCase()}function ce(s,e,t){return Math.max(e,Math.min(t,s))}function _u(s,e){return(s%e+e)%e}function Es(s,e,t){return(1-t)*s+t*e}function go(s){switch(s.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vu(s,e){if(e.constructor===Float32Array)return s;let t=go(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(s/t,-1)}function xu(s,e){if(e.constructor===Float32Array)return s;let t=go(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(s*t)}var Fe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,i=e.elements;return this.x=i[0]*t+i[3]*n+i[6],this.y=i[1]*t+i[4]*n+i[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ce(this.x,e.x,t.x),this.y=ce(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ce(this.x,e,t),this.y=ce(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ce(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),i=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*i+e.x,this.y=r*i+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Dt=class{constructor(e=0,t=0,n=0,i=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=i}static slerpFlat(e,t,n,i,r,o,a){let l=n[i+0],c=n[i+1],u=n[i+2],f=n[i+3],d=r[o+0],p=r[o+1],_=r[o+2],v=r[o+3];if(f!==v||l!==d||c!==p||u!==_){let S=l*d+c*p+u*_+f*v;S<0&&(d=-d,p=-p,_=-_,v=-v,S=-S);let M=1-a;if(S<.9995){let A=Math.acos(S),P=Math.sin(A);M=Math.sin(M*A)/P,a=Math.sin(a*A)/P,l=l*M+d*a,c=c*M+p*a,u=u*M+_*a,f=f*M+v*a}else{l=l*M+d*a,c=c*M+p*a,u=u*M+_*a,f=f*M+v*a;let A=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=A,c*=A,u*=A,f*=A}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,n,i,r,o){let a=n[i],l=n[i+1],c=n[i+2],u=n[i+3],f=r[o],d=r[o+1],p=r[o+2],_=r[o+3];return e[t]=a*_+u*f+l*p-c*d,e[t+1]=l*_+u*d+c*f-a*p,e[t+2]=c*_+u*p+a*d-l*f,e[t+3]=u*_-a*f-l*d-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,i){return this._x=e,this._y=t,this._z=n,this._w=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,i=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(i/2),f=a(r/2),d=l(n/2),p=l(i/2),_=l(r/2);switch(o){case"XYZ":this._x=d*u*f+c*p*_,this._y=c*p*f-d*u*_,this._z=c*u*_+d*p*f,this._w=c*u*f-d*p*_;break;case"YXZ":this._x=d*u*f+c*p*_,this._y=c*p*f-d*u*_,this._z=c*u*_-d*p*f,this._w=c*u*f+d*p*_;break;case"ZXY":this._x=d*u*f-c*p*_,this._y=c*p*f+d*u*_,this._z=c*u*_+d*p*f,this._w=c*u*f-d*p*_;break;case"ZYX":this._x=d*u*f-c*p*_,this._y=c*p*f+d*u*_,this._z=c*u*_-d*p*f,this._w=c*u*f+d*p*_;break;case"YZX":this._x=d*u*f+c*p*_,this._y=c*p*f+d*u*_,this._z=c*u*_-d*p*f,this._w=c*u*f-d*p*_;break;case"XZY":this._x=d*u*f-c*p*_,this._y=c*p*f-d*u*_,this._z=c*u*_+d*p*f,this._w=c*u*f+d*p*_;break;default:Se("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,i=Math.sin(n);return this._x=e.x*i,this._y=e.y*i,this._z=e.z*i,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],i=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],d=n+a+f;if(d>0){let p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-i)*p}else if(n>a&&n>f){let p=2*Math.sqrt(1+n-a-f);this._w=(u-l)/p,this._x=.25*p,this._y=(i+o)/p,this._z=(r+c)/p}else if(a>f){let p=2*Math.sqrt(1+a-n-f);this._w=(r-c)/p,this._x=(i+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+f-n-a);this._w=(o-i)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ce(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let i=Math.min(1,t/n);return this.slerp(e,i),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,i=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+i*c-r*l,this._y=i*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-i*a,this._w=o*u-n*a-i*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,i=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,i=-i,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+i*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+i*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),i=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(i*Math.sin(e),i*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Aa.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Aa.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,i=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*i,this.y=r[1]*t+r[4]*n+r[7]*i,this.z=r[2]*t+r[5]*n+r[8]*i,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,i=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*i+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*i+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*i+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*i+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,i=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*i-a*n),u=2*(a*t-r*i),f=2*(r*n-o*t);return this.x=t+l*c+o*f-a*u,this.y=n+l*u+a*c-r*f,this.z=i+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,i=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*i,this.y=r[1]*t+r[5]*n+r[9]*i,this.z=r[2]*t+r[6]*n+r[10]*i,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ce(this.x,e.x,t.x),this.y=ce(this.y,e.y,t.y),this.z=ce(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ce(this.x,e,t),this.y=ce(this.y,e,t),this.z=ce(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,i=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=i*l-r*a,this.y=r*o-n*l,this.z=n*a-i*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Ts.copy(this).projectOnVector(e),this.sub(Ts)}reflect(e){return this.sub(Ts.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ce(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,i=this.z-e.z;return t*t+n*n+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let i=Math.sin(t)*e;return this.x=i*Math.sin(n),this.y=Math.cos(t)*e,this.z=i*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),i=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=i,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ts=new z,Aa=new Dt,se=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,i,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,i,r,o,a,l,c)}set(e,t,n,i,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=i,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,i=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],f=n[7],d=n[2],p=n[5],_=n[8],v=i[0],S=i[3],M=i[6],A=i[1],P=i[4],L=i[7],D=i[2],Y=i[5],G=i[8];return r[0]=o*v+a*A+l*D,r[3]=o*S+a*P+l*Y,r[6]=o*M+a*L+l*G,r[1]=c*v+u*A+f*D,r[4]=c*S+u*P+f*Y,r[7]=c*M+u*L+f*G,r[2]=d*v+p*A+_*D,r[5]=d*S+p*P+_*Y,r[8]=d*M+p*L+_*G,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],i=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+i*r*c-i*o*l}invert(){let e=this.elements,t=e[0],n=e[1],i=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,d=a*l-u*r,p=c*r-o*l,_=t*f+n*d+i*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/_;return e[0]=f*v,e[1]=(i*c-u*n)*v,e[2]=(a*n-i*o)*v,e[3]=d*v,e[4]=(u*t-i*l)*v,e[5]=(i*r-a*t)*v,e[6]=p*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,i,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-i*c,i*l,-i*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return dr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Rs.makeScale(e,t)),this}rotate(e){return dr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Rs.makeRotation(-e)),this}translate(e,t){return dr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Rs.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let i=0;i<9;i++)if(t[i]!==n[i])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Rs=new se,Ea=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ta=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function yu(){let s={enabled:!0,workingColorSpace:ut,spaces:{},convert:function(i,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===fr&&(i.r=Lt(i.r),i.g=Lt(i.g),i.b=Lt(i.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(i.applyMatrix3(this.spaces[r].toXYZ),i.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===fr&&(i.r=Un(i.r),i.g=Un(i.g),i.b=Un(i.b))),i},workingToColorSpace:function(i,r){return this.convert(i,this.workingColorSpace,r)},colorSpaceToWorking:function(i,r){return this.convert(i,r,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===mo?Js:this.spaces[i].transfer},getToneMappingMode:function(i){return this.spaces[i].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(i,r=this.workingColorSpace){return i.fromArray(this.spaces[r].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,r,o){return i.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return s.define({[ut]:{primaries:e,whitePoint:n,transfer:Js,toXYZ:Ea,fromXYZ:Ta,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:tt},outputColorSpaceConfig:{drawingBufferColorSpace:tt}},[tt]:{primaries:e,whitePoint:n,transfer:fr,toXYZ:Ea,fromXYZ:Ta,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:tt}}}),s}var et=yu();function Lt(s){return s<.04045?s*.0773993808:Math.pow(s*.9478672986+.0521327014,2.4)}function Un(s){return s<.0031308?s*12.92:1.055*Math.pow(s,.41666)-.055}var Tn,gr=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Tn===void 0&&(Tn=Qs("canvas")),Tn.width=e.width,Tn.height=e.height;let i=Tn.getContext("2d");e instanceof ImageData?i.putImageData(e,0,0):i.drawImage(e,0,0,e.width,e.height),n=Tn}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Qs("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let i=n.getImageData(0,0,e.width,e.height),r=i.data;for(let o=0;o<r.length;o++)r[o]=Lt(r[o]/255)*255;return n.putImageData(i,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Lt(t[n]/255)*255):t[n]=Lt(t[n]);return{data:t,width:e.width,height:e.height}}else return Se("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},wu=0,_r=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:wu++}),this.uuid=Lr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},i=this.data;if(i!==null){let r;if(Array.isArray(i)){r=[];for(let o=0,a=i.length;o<a;o++)i[o].isDataTexture?r.push(Cs(i[o].image)):r.push(Cs(i[o]))}else r=Cs(i);n.url=r}return t||(e.images[this.uuid]=n),n}};function Cs(s){return typeof HTMLImageElement<"u"&&s instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&s instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&s instanceof ImageBitmap?gr.getDataURL(s):s.data?{data:Array.from(s.data),width:s.width,height:s.height,type:s.data.constructor.name}:(Se("Texture: Unable to serialize Texture."),{})}var bu=0,Is=new z,dn=class s extends fn{constructor(e=s.DEFAULT_IMAGE,t=s.DEFAULT_MAPPING,n=un,i=un,r=Yt,o=po,a=xt,l=Xa,c=s.DEFAULT_ANISOTROPY,u=mo){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:bu++}),this.uuid=Lr(),this.name="",this.source=new _r(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=i,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Fe(0,0),this.repeat=new Fe(1,1),this.center=new Fe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Is).x}get height(){return this.source.getSize(Is).y}get depth(){return this.source.getSize(Is).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Se(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let i=this[t];if(i===void 0){Se(`Texture.setValues(): property '${t}' does not exist.`);continue}i&&n&&i.isVector2&&n.isVector2||i&&n&&i.isVector3&&n.isVector3||i&&n&&i.isMatrix3&&n.isMatrix3?i.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==fo)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ws:e.x=e.x-Math.floor(e.x);break;case un:e.x=e.x<0?0:1;break;case Xs:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ws:e.y=e.y-Math.floor(e.y);break;case un:e.y=e.y<0?0:1;break;case Xs:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};dn.DEFAULT_IMAGE=null;dn.DEFAULT_MAPPING=fo;dn.DEFAULT_ANISOTROPY=1;var eo=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,i=1){this.x=e,this.y=t,this.z=n,this.w=i}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,i){return this.x=e,this.y=t,this.z=n,this.w=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,i=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*i+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*i+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*i+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*i+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,i,r,l=e.elements,c=l[0],u=l[4],f=l[8],d=l[1],p=l[5],_=l[9],v=l[2],S=l[6],M=l[10];if(Math.abs(u-d)<.01&&Math.abs(f-v)<.01&&Math.abs(_-S)<.01){if(Math.abs(u+d)<.1&&Math.abs(f+v)<.1&&Math.abs(_+S)<.1&&Math.abs(c+p+M-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let P=(c+1)/2,L=(p+1)/2,D=(M+1)/2,Y=(u+d)/4,G=(f+v)/4,Q=(_+S)/4;return P>L&&P>D?P<.01?(n=0,i=.707106781,r=.707106781):(n=Math.sqrt(P),i=Y/n,r=G/n):L>D?L<.01?(n=.707106781,i=0,r=.707106781):(i=Math.sqrt(L),n=Y/i,r=Q/i):D<.01?(n=.707106781,i=.707106781,r=0):(r=Math.sqrt(D),n=G/r,i=Q/r),this.set(n,i,r,t),this}let A=Math.sqrt((S-_)*(S-_)+(f-v)*(f-v)+(d-u)*(d-u));return Math.abs(A)<.001&&(A=1),this.x=(S-_)/A,this.y=(f-v)/A,this.z=(d-u)/A,this.w=Math.acos((c+p+M-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ce(this.x,e.x,t.x),this.y=ce(this.y,e.y,t.y),this.z=ce(this.z,e.z,t.z),this.w=ce(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ce(this.x,e,t),this.y=ce(this.y,e,t),this.z=ce(this.z,e,t),this.w=ce(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};var nt=class s{static{this.prototype.isMatrix4=!0}constructor(e,t,n,i,r,o,a,l,c,u,f,d,p,_,v,S){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,i,r,o,a,l,c,u,f,d,p,_,v,S)}set(e,t,n,i,r,o,a,l,c,u,f,d,p,_,v,S){let M=this.elements;return M[0]=e,M[4]=t,M[8]=n,M[12]=i,M[1]=r,M[5]=o,M[9]=a,M[13]=l,M[2]=c,M[6]=u,M[10]=f,M[14]=d,M[3]=p,M[7]=_,M[11]=v,M[15]=S,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new s().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,i=1/Rn.setFromMatrixColumn(e,0).length(),r=1/Rn.setFromMatrixColumn(e,1).length(),o=1/Rn.setFromMatrixColumn(e,2).length();return t[0]=n[0]*i,t[1]=n[1]*i,t[2]=n[2]*i,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,i=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(i),c=Math.sin(i),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let d=o*u,p=o*f,_=a*u,v=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=p+_*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=_+p*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,p=l*f,_=c*u,v=c*f;t[0]=d+v*a,t[4]=_*a-p,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=p*a-_,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,p=l*f,_=c*u,v=c*f;t[0]=d-v*a,t[4]=-o*f,t[8]=_+p*a,t[1]=p+_*a,t[5]=o*u,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,p=o*f,_=a*u,v=a*f;t[0]=l*u,t[4]=_*c-p,t[8]=d*c+v,t[1]=l*f,t[5]=v*c+d,t[9]=p*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,p=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=v-d*f,t[8]=_*f+p,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*f+_,t[10]=d-v*f}else if(e.order==="XZY"){let d=o*l,p=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=d*f+v,t[5]=o*u,t[9]=p*f-_,t[2]=_*f-p,t[6]=a*u,t[10]=v*f+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Su,e,Mu)}lookAt(e,t,n){let i=this.elements;return Xe.subVectors(e,t),Xe.lengthSq()===0&&(Xe.z=1),Xe.normalize(),Wt.crossVectors(n,Xe),Wt.lengthSq()===0&&(Math.abs(n.z)===1?Xe.x+=1e-4:Xe.z+=1e-4,Xe.normalize(),Wt.crossVectors(n,Xe)),Wt.normalize(),ir.crossVectors(Xe,Wt),i[0]=Wt.x,i[4]=ir.x,i[8]=Xe.x,i[1]=Wt.y,i[5]=ir.y,i[9]=Xe.y,i[2]=Wt.z,i[6]=ir.z,i[10]=Xe.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,i=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],f=n[5],d=n[9],p=n[13],_=n[2],v=n[6],S=n[10],M=n[14],A=n[3],P=n[7],L=n[11],D=n[15],Y=i[0],G=i[4],Q=i[8],k=i[12],Z=i[1],X=i[5],V=i[9],oe=i[13],ne=i[2],te=i[6],pe=i[10],Ue=i[14],Ke=i[3],Ee=i[7],Et=i[11],kt=i[15];return r[0]=o*Y+a*Z+l*ne+c*Ke,r[4]=o*G+a*X+l*te+c*Ee,r[8]=o*Q+a*V+l*pe+c*Et,r[12]=o*k+a*oe+l*Ue+c*kt,r[1]=u*Y+f*Z+d*ne+p*Ke,r[5]=u*G+f*X+d*te+p*Ee,r[9]=u*Q+f*V+d*pe+p*Et,r[13]=u*k+f*oe+d*Ue+p*kt,r[2]=_*Y+v*Z+S*ne+M*Ke,r[6]=_*G+v*X+S*te+M*Ee,r[10]=_*Q+v*V+S*pe+M*Et,r[14]=_*k+v*oe+S*Ue+M*kt,r[3]=A*Y+P*Z+L*ne+D*Ke,r[7]=A*G+P*X+L*te+D*Ee,r[11]=A*Q+P*V+L*pe+D*Et,r[15]=A*k+P*oe+L*Ue+D*kt,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],i=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],d=e[10],p=e[14],_=e[3],v=e[7],S=e[11],M=e[15],A=l*p-c*d,P=a*p-c*f,L=a*d-l*f,D=o*p-c*u,Y=o*d-l*u,G=o*f-a*u;return t*(v*A-S*P+M*L)-n*(_*A-S*D+M*Y)+i*(_*P-v*D+M*G)-r*(_*L-v*Y+S*G)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],i=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+i*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let i=this.elements;return e.isVector3?(i[12]=e.x,i[13]=e.y,i[14]=e.z):(i[12]=e,i[13]=t,i[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],i=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],d=e[10],p=e[11],_=e[12],v=e[13],S=e[14],M=e[15],A=t*a-n*o,P=t*l-i*o,L=t*c-r*o,D=n*l-i*a,Y=n*c-r*a,G=i*c-r*l,Q=u*v-f*_,k=u*S-d*_,Z=u*M-p*_,X=f*S-d*v,V=f*M-p*v,oe=d*M-p*S,ne=A*oe-P*V+L*X+D*Z-Y*k+G*Q;if(ne===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let te=1/ne;return e[0]=(a*oe-l*V+c*X)*te,e[1]=(i*V-n*oe-r*X)*te,e[2]=(v*G-S*Y+M*D)*te,e[3]=(d*Y-f*G-p*D)*te,e[4]=(l*Z-o*oe-c*k)*te,e[5]=(t*oe-i*Z+r*k)*te,e[6]=(S*L-_*G-M*P)*te,e[7]=(u*G-d*L+p*P)*te,e[8]=(o*V-a*Z+c*Q)*te,e[9]=(n*Z-t*V-r*Q)*te,e[10]=(_*Y-v*L+M*A)*te,e[11]=(f*L-u*Y-p*A)*te,e[12]=(a*k-o*X-l*Q)*te,e[13]=(t*X-n*k+i*Q)*te,e[14]=(v*P-_*D-S*A)*te,e[15]=(u*D-f*P+d*A)*te,this}scale(e){let t=this.elements,n=e.x,i=e.y,r=e.z;return t[0]*=n,t[4]*=i,t[8]*=r,t[1]*=n,t[5]*=i,t[9]*=r,t[2]*=n,t[6]*=i,t[10]*=r,t[3]*=n,t[7]*=i,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],i=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,i))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),i=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-i*l,c*l+i*a,0,c*a+i*l,u*a+n,u*l-i*o,0,c*l-i*a,u*l+i*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,i,r,o){return this.set(1,n,r,0,e,1,o,0,t,i,1,0,0,0,0,1),this}compose(e,t,n){let i=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,d=r*c,p=r*u,_=r*f,v=o*u,S=o*f,M=a*f,A=l*c,P=l*u,L=l*f,D=n.x,Y=n.y,G=n.z;return i[0]=(1-(v+M))*D,i[1]=(p+L)*D,i[2]=(_-P)*D,i[3]=0,i[4]=(p-L)*Y,i[5]=(1-(d+M))*Y,i[6]=(S+A)*Y,i[7]=0,i[8]=(_+P)*G,i[9]=(S-A)*G,i[10]=(1-(d+v))*G,i[11]=0,i[12]=e.x,i[13]=e.y,i[14]=e.z,i[15]=1,this}decompose(e,t,n){let i=this.elements;e.x=i[12],e.y=i[13],e.z=i[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Rn.set(i[0],i[1],i[2]).length(),a=Rn.set(i[4],i[5],i[6]).length(),l=Rn.set(i[8],i[9],i[10]).length();r<0&&(o=-o),lt.copy(this);let c=1/o,u=1/a,f=1/l;return lt.elements[0]*=c,lt.elements[1]*=c,lt.elements[2]*=c,lt.elements[4]*=u,lt.elements[5]*=u,lt.elements[6]*=u,lt.elements[8]*=f,lt.elements[9]*=f,lt.elements[10]*=f,t.setFromRotationMatrix(lt),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,i,r,o,a=_i,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(n-i),d=(t+e)/(t-e),p=(n+i)/(n-i),_,v;if(l)_=r/(o-r),v=o*r/(o-r);else if(a===_i)_=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===js)_=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,i,r,o,a=_i,l=!1){let c=this.elements,u=2/(t-e),f=2/(n-i),d=-(t+e)/(t-e),p=-(n+i)/(n-i),_,v;if(l)_=1/(o-r),v=o/(o-r);else if(a===_i)_=-2/(o-r),v=-(o+r)/(o-r);else if(a===js)_=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let i=0;i<16;i++)if(t[i]!==n[i])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Rn=new z,lt=new nt,Su=new z(0,0,0),Mu=new z(1,1,1),Wt=new z,ir=new z,Xe=new z,Ra=new nt,Ca=new Dt,xi=class s{constructor(e=0,t=0,n=0,i=s.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=i}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,i=this._order){return this._x=e,this._y=t,this._z=n,this._order=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let i=e.elements,r=i[0],o=i[4],a=i[8],l=i[1],c=i[5],u=i[9],f=i[2],d=i[6],p=i[10];switch(t){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ce(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Se("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Ra.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Ra,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Ca.setFromEuler(this),this.setFromQuaternion(Ca,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};xi.DEFAULT_ORDER="XYZ";var vr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Au=0,Ia=new z,Cn=new Dt,Ct=new nt,rr=new z,di=new z,Eu=new z,Tu=new Dt,Pa=new z(1,0,0),Na=new z(0,1,0),La=new z(0,0,1),Da={type:"added"},Ru={type:"removed"},In={type:"childadded",child:null},Ps={type:"childremoved",child:null},pn=class s extends fn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Au++}),this.uuid=Lr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=s.DEFAULT_UP.clone();let e=new z,t=new xi,n=new Dt,i=new z(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new nt},normalMatrix:{value:new se}}),this.matrix=new nt,this.matrixWorld=new nt,this.matrixAutoUpdate=s.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=s.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new vr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Cn.setFromAxisAngle(e,t),this.quaternion.multiply(Cn),this}rotateOnWorldAxis(e,t){return Cn.setFromAxisAngle(e,t),this.quaternion.premultiply(Cn),this}rotateX(e){return this.rotateOnAxis(Pa,e)}rotateY(e){return this.rotateOnAxis(Na,e)}rotateZ(e){return this.rotateOnAxis(La,e)}translateOnAxis(e,t){return Ia.copy(e).applyQuaternion(this.quaternion),this.position.add(Ia.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Pa,e)}translateY(e){return this.translateOnAxis(Na,e)}translateZ(e){return this.translateOnAxis(La,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ct.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?rr.copy(e):rr.set(e,t,n);let i=this.parent;this.updateWorldMatrix(!0,!1),di.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ct.lookAt(di,rr,this.up):Ct.lookAt(rr,di,this.up),this.quaternion.setFromRotationMatrix(Ct),i&&(Ct.extractRotation(i.matrixWorld),Cn.setFromRotationMatrix(Ct),this.quaternion.premultiply(Cn.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ye("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Da),In.child=e,this.dispatchEvent(In),In.child=null):ye("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ru),Ps.child=e,this.dispatchEvent(Ps),Ps.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ct.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ct.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ct),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Da),In.child=e,this.dispatchEvent(In),In.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,i=this.children.length;n<i;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let i=this.children;for(let r=0,o=i.length;r<o;r++)i[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(di,e,Eu),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(di,Tu,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,i=t.length;n<i;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,i=t.length;n<i;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,i=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*i,r[13]+=n-r[1]*t-r[5]*n-r[9]*i,r[14]+=i-r[2]*t-r[6]*n-r[10]*i}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,i=t.length;n<i;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let i={};i.uuid=this.uuid,i.type=this.type,i.name=this.name,i.castShadow=this.castShadow,i.receiveShadow=this.receiveShadow,i.visible=this.visible,i.frustumCulled=this.frustumCulled,i.renderOrder=this.renderOrder,i.static=this.static,i.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(i.userData=this.userData),i.layers=this.layers.mask,i.matrix=this.matrix.toArray(),i.up=this.up.toArray(),this.pivot!==null&&(i.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(i.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(i.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(i.type="InstancedMesh",i.count=this.count,i.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(i.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(i.type="BatchedMesh",i.perObjectFrustumCulled=this.perObjectFrustumCulled,i.sortObjects=this.sortObjects,i.drawRanges=this._drawRanges,i.reservedRanges=this._reservedRanges,i.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),i.instanceInfo=this._instanceInfo.map(a=>({...a})),i.availableInstanceIds=this._availableInstanceIds.slice(),i.availableGeometryIds=this._availableGeometryIds.slice(),i.nextIndexStart=this._nextIndexStart,i.nextVertexStart=this._nextVertexStart,i.geometryCount=this._geometryCount,i.maxInstanceCount=this._maxInstanceCount,i.maxVertexCount=this._maxVertexCount,i.maxIndexCount=this._maxIndexCount,i.geometryInitialized=this._geometryInitialized,i.matricesTexture=this._matricesTexture.toJSON(e),i.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(i.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(i.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(i.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?i.background=this.background.toJSON():this.background.isTexture&&(i.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(i.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){i.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(i.bindMode=this.bindMode,i.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),i.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));i.material=a}else i.material=r(e.materials,this.material);if(this.children.length>0){i.children=[];for(let a=0;a<this.children.length;a++)i.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){i.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];i.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),d=o(e.skeletons),p=o(e.animations),_=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),f.length>0&&(n.shapes=f),d.length>0&&(n.skeletons=d),p.length>0&&(n.animations=p),_.length>0&&(n.nodes=_)}return n.object=i,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let i=e.children[n];this.add(i.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};pn.DEFAULT_UP=new z(0,1,0);pn.DEFAULT_MATRIX_AUTO_UPDATE=!0;pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ya={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xt={h:0,s:0,l:0},sr={h:0,s:0,l:0};function Ns(s,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?s+(e-s)*6*t:t<1/2?e:t<2/3?s+(e-s)*6*(2/3-t):s}var Ie=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let i=e;i&&i.isColor?this.copy(i):typeof i=="number"?this.setHex(i):typeof i=="string"&&this.setStyle(i)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=tt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,et.colorSpaceToWorking(this,t),this}setRGB(e,t,n,i=et.workingColorSpace){return this.r=e,this.g=t,this.b=n,et.colorSpaceToWorking(this,i),this}setHSL(e,t,n,i=et.workingColorSpace){if(e=_u(e,1),t=ce(t,0,1),n=ce(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Ns(o,r,e+1/3),this.g=Ns(o,r,e),this.b=Ns(o,r,e-1/3)}return et.colorSpaceToWorking(this,i),this}setStyle(e,t=tt){function n(r){r!==void 0&&parseFloat(r)<1&&Se("Color: Alpha component of "+e+" will be ignored.")}let i;if(i=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=i[1],a=i[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Se("Color: Unknown color model "+e)}}else if(i=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=i[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Se("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=tt){let n=Ya[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Se("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Lt(e.r),this.g=Lt(e.g),this.b=Lt(e.b),this}copyLinearToSRGB(e){return this.r=Un(e.r),this.g=Un(e.g),this.b=Un(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=tt){return et.workingToColorSpace(De.copy(this),e),Math.round(ce(De.r*255,0,255))*65536+Math.round(ce(De.g*255,0,255))*256+Math.round(ce(De.b*255,0,255))}getHexString(e=tt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=et.workingColorSpace){et.workingToColorSpace(De.copy(this),t);let n=De.r,i=De.g,r=De.b,o=Math.max(n,i,r),a=Math.min(n,i,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case n:l=(i-r)/f+(i<r?6:0);break;case i:l=(r-n)/f+2;break;case r:l=(n-i)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=et.workingColorSpace){return et.workingToColorSpace(De.copy(this),t),e.r=De.r,e.g=De.g,e.b=De.b,e}getStyle(e=tt){et.workingToColorSpace(De.copy(this),e);let t=De.r,n=De.g,i=De.b;return e!==tt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${i.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(i*255)})`}offsetHSL(e,t,n){return this.getHSL(Xt),this.setHSL(Xt.h+e,Xt.s+t,Xt.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Xt),e.getHSL(sr);let n=Es(Xt.h,sr.h,t),i=Es(Xt.s,sr.s,t),r=Es(Xt.l,sr.l,t);return this.setHSL(n,i,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,i=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*i,this.g=r[1]*t+r[4]*n+r[7]*i,this.b=r[2]*t+r[5]*n+r[8]*i,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},De=new Ie;Ie.NAMES=Ya;var Me=class{constructor(e=new z(1/0,1/0,1/0),t=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ct.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ct.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ct.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ct):ct.fromBufferAttribute(r,o),ct.applyMatrix4(e.matrixWorld),this.expandByPoint(ct);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),or.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),or.copy(n.boundingBox)),or.applyMatrix4(e.matrixWorld),this.union(or)}let i=e.children;for(let r=0,o=i.length;r<o;r++)this.expandByObject(i[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ct),ct.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(pi),ar.subVectors(this.max,pi),Pn.subVectors(e.a,pi),Nn.subVectors(e.b,pi),Ln.subVectors(e.c,pi),qt.subVectors(Nn,Pn),$t.subVectors(Ln,Nn),cn.subVectors(Pn,Ln);let t=[0,-qt.z,qt.y,0,-$t.z,$t.y,0,-cn.z,cn.y,qt.z,0,-qt.x,$t.z,0,-$t.x,cn.z,0,-cn.x,-qt.y,qt.x,0,-$t.y,$t.x,0,-cn.y,cn.x,0];return!Ls(t,Pn,Nn,Ln,ar)||(t=[1,0,0,0,1,0,0,0,1],!Ls(t,Pn,Nn,Ln,ar))?!1:(lr.crossVectors(qt,$t),t=[lr.x,lr.y,lr.z],Ls(t,Pn,Nn,Ln,ar))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ct).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ct).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(It[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),It[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),It[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),It[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),It[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),It[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),It[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),It[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(It),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},It=[new z,new z,new z,new z,new z,new z,new z,new z],ct=new z,or=new Me,Pn=new z,Nn=new z,Ln=new z,qt=new z,$t=new z,cn=new z,pi=new z,ar=new z,lr=new z,hn=new z;function Ls(s,e,t,n,i){for(let r=0,o=s.length-3;r<=o;r+=3){hn.fromArray(s,r);let a=i.x*Math.abs(hn.x)+i.y*Math.abs(hn.y)+i.z*Math.abs(hn.z),l=e.dot(hn),c=t.dot(hn),u=n.dot(hn);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Nt=Cu();function Cu(){let s=new ArrayBuffer(4),e=new Float32Array(s),t=new Uint32Array(s),n=new Uint32Array(512),i=new Uint32Array(512);for(let l=0;l<256;++l){let c=l-127;c<-27?(n[l]=0,n[l|256]=32768,i[l]=24,i[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,i[l]=-c-1,i[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,i[l]=13,i[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,i[l]=24,i[l|256]=24):(n[l]=31744,n[l|256]=64512,i[l]=13,i[l|256]=13)}let r=new Uint32Array(2048),o=new Uint32Array(64),a=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,u=0;for(;(c&8388608)===0;)c<<=1,u-=8388608;c&=-8388609,u+=947912704,r[l]=c|u}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(a[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:i,mantissaTable:r,exponentTable:o,offsetTable:a}}function Iu(s){Math.abs(s)>65504&&Se("DataUtils.toHalfFloat(): Value out of range."),s=ce(s,-65504,65504),Nt.floatView[0]=s;let e=Nt.uint32View[0],t=e>>23&511;return Nt.baseTable[t]+((e&8388607)>>Nt.shiftTable[t])}function Pu(s){let e=s>>10;return Nt.uint32View[0]=Nt.mantissaTable[Nt.offsetTable[e]+(s&1023)]+Nt.exponentTable[e],Nt.floatView[0]}var F=class{static toHalfFloat(e){return Iu(e)}static fromHalfFloat(e){return Pu(e)}},be=new z,cr=new Fe,Nu=0,ht=class extends fn{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Nu++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=qa,this.updateRanges=[],this.gpuType=jt,this.version=0,this._normalizationScale=e!==void 0?go(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let i=0,r=this.itemSize;i<r;i++)this.array[e+i]=t.array[n+i];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)cr.fromBufferAttribute(this,t),cr.applyMatrix3(e),this.setXY(t,cr.x,cr.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)be.fromBufferAttribute(this,t),be.applyMatrix3(e),this.setXYZ(t,be.x,be.y,be.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)be.fromBufferAttribute(this,t),be.applyMatrix4(e),this.setXYZ(t,be.x,be.y,be.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)be.fromBufferAttribute(this,t),be.applyNormalMatrix(e),this.setXYZ(t,be.x,be.y,be.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)be.fromBufferAttribute(this,t),be.transformDirection(e),this.setXYZ(t,be.x,be.y,be.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=i,this}setXYZW(e,t,n,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=i,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):vu(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):xu(e,this.array)}};var xr=class extends ht{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var yr=class extends ht{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var wr=class extends ht{constructor(e,t,n){super(new Float32Array(e),t,n)}},Lu=new Me,mi=new z,Ds=new z,br=class{constructor(e=new z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Lu.setFromPoints(e).getCenter(n);let i=0;for(let r=0,o=e.length;r<o;r++)i=Math.max(i,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(i),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;mi.subVectors(e,this.center);let t=mi.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),i=(n-this.radius)*.5;this.center.addScaledVector(mi,i/n),this.radius+=i}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ds.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(mi.copy(e.center).add(Ds)),this.expandByPoint(mi.copy(e.center).sub(Ds))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Du=0,Qe=new nt,Os=new pn,Dn=new z,qe=new Me,gi=new Me,Ce=new z,yi=class s extends fn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Du++}),this.uuid=Lr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(du(e)?yr:xr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new se().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let i=this.attributes.tangent;return i!==void 0&&(i.transformDirection(e),i.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Qe.makeRotationFromQuaternion(e),this.applyMatrix4(Qe),this}rotateX(e){return Qe.makeRotationX(e),this.applyMatrix4(Qe),this}rotateY(e){return Qe.makeRotationY(e),this.applyMatrix4(Qe),this}rotateZ(e){return Qe.makeRotationZ(e),this.applyMatrix4(Qe),this}translate(e,t,n){return Qe.makeTranslation(e,t,n),this.applyMatrix4(Qe),this}scale(e,t,n){return Qe.makeScale(e,t,n),this.applyMatrix4(Qe),this}lookAt(e){return Os.lookAt(e),Os.updateMatrix(),this.applyMatrix4(Os.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Dn).negate(),this.translate(Dn.x,Dn.y,Dn.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let i=0,r=e.length;i<r;i++){let o=e[i];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new wr(n,3))}else{let n=Math.min(e.length,t.count);for(let i=0;i<n;i++){let r=e[i];t.setXYZ(i,r.x,r.y,r.z||0)}e.length>t.count&&Se("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Me);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ye("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,i=t.length;n<i;n++){let r=t[n];qe.setFromBufferAttribute(r),this.morphTargetsRelative?(Ce.addVectors(this.boundingBox.min,qe.min),this.boundingBox.expandByPoint(Ce),Ce.addVectors(this.boundingBox.max,qe.max),this.boundingBox.expandByPoint(Ce)):(this.boundingBox.expandByPoint(qe.min),this.boundingBox.expandByPoint(qe.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ye('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new br);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ye("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(e){let n=this.boundingSphere.center;if(qe.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];gi.setFromBufferAttribute(a),this.morphTargetsRelative?(Ce.addVectors(qe.min,gi.min),qe.expandByPoint(Ce),Ce.addVectors(qe.max,gi.max),qe.expandByPoint(Ce)):(qe.expandByPoint(gi.min),qe.expandByPoint(gi.max))}qe.getCenter(n);let i=0;for(let r=0,o=e.count;r<o;r++)Ce.fromBufferAttribute(e,r),i=Math.max(i,n.distanceToSquared(Ce));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Ce.fromBufferAttribute(a,c),l&&(Dn.fromBufferAttribute(e,c),Ce.add(Dn)),i=Math.max(i,n.distanceToSquared(Ce))}this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&ye('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ye("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,i=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new ht(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new z,l[k]=new z;let u=new z,f=new z,d=new z,p=new Fe,_=new Fe,v=new Fe,S=new z,M=new z;function A(k,Z,X){c[k]=c[Z]=c[X]=1,u.fromBufferAttribute(n,k),f.fromBufferAttribute(n,Z),d.fromBufferAttribute(n,X),p.fromBufferAttribute(r,k),_.fromBufferAttribute(r,Z),v.fromBufferAttribute(r,X),f.sub(u),d.sub(u),_.sub(p),v.sub(p);let V=1/(_.x*v.y-v.x*_.y);isFinite(V)&&(S.copy(f).multiplyScalar(v.y).addScaledVector(d,-_.y).multiplyScalar(V),M.copy(d).multiplyScalar(_.x).addScaledVector(f,-v.x).multiplyScalar(V),a[k].add(S),a[Z].add(S),a[X].add(S),l[k].add(M),l[Z].add(M),l[X].add(M))}let P=this.groups;P.length===0&&(P=[{start:0,count:e.count}]);for(let k=0,Z=P.length;k<Z;++k){let X=P[k],V=X.start,oe=X.count;for(let ne=V,te=V+oe;ne<te;ne+=3)A(e.getX(ne+0),e.getX(ne+1),e.getX(ne+2))}let L=new z,D=new z,Y=new z,G=new z;function Q(k){Y.fromBufferAttribute(i,k),G.copy(Y);let Z=a[k];L.copy(Z),L.sub(Y.multiplyScalar(Y.dot(Z))).normalize(),D.crossVectors(G,Z);let V=D.dot(l[k])<0?-1:1;o.setXYZW(k,L.x,L.y,L.z,V)}for(let k=0,Z=n.count;k<Z;++k)c[k]&&Q(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new ht(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,p=n.count;d<p;d++)n.setXYZ(d,0,0,0);let i=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,f=new z;if(e)for(let d=0,p=e.count;d<p;d+=3){let _=e.getX(d+0),v=e.getX(d+1),S=e.getX(d+2);i.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,S),u.subVectors(o,r),f.subVectors(i,r),u.cross(f),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,S),a.add(u),l.add(u),c.add(u),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(S,c.x,c.y,c.z)}else for(let d=0,p=t.count;d<p;d+=3)i.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),f.subVectors(i,r),u.cross(f),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ce.fromBufferAttribute(e,t),Ce.normalize(),e.setXYZ(t,Ce.x,Ce.y,Ce.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,d=new c.constructor(l.length*u),p=0,_=0;for(let v=0,S=l.length;v<S;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*u;for(let M=0;M<u;M++)d[_++]=c[p++]}return new ht(d,u,f)}if(this.index===null)return Se("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new s,n=this.index.array,i=this.attributes;for(let a in i){let l=i[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let d=c[u],p=e(d,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let i={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,d=c.length;f<d;f++){let p=c[f];u.push(p.toJSON(e.data))}u.length>0&&(i[l]=u,r=!0)}r&&(e.data.morphAttributes=i,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let i=e.attributes;for(let c in i){let u=i[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let d=0,p=f.length;d<p;d++)u.push(f[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var wi=class extends dn{constructor(e=null,t=1,n=1,i,r,o,a,l,c=qs,u=qs,f,d){super(null,o,a,l,c,u,i,r,f,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};function Za(s){let e={};for(let t in s){e[t]={};for(let n in s[t]){let i=s[t][n];if(Oa(i))i.isRenderTargetTexture?(Se("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=i.clone();else if(Array.isArray(i))if(Oa(i[0])){let r=[];for(let o=0,a=i.length;o<a;o++)r[o]=i[o].clone();e[t][n]=r}else e[t][n]=i.slice();else e[t][n]=i}}return e}function Be(s){let e={};for(let t=0;t<s.length;t++){let n=Za(s[t]);for(let i in n)e[i]=n[i]}return e}function Oa(s){return s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)}function On(s,e){return!s||s.constructor===e?s:typeof e.BYTES_PER_ELEMENT=="number"?new e(s):Array.prototype.slice.call(s)}function hr(s){return s!==void 0&&s.inTangents!==void 0&&s.outTangents!==void 0}var Zt=class{constructor(e,t,n,i){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=i!==void 0?i:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,i=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<i)){for(let a=n+2;;){if(i===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=i,i=t[++n],e<i)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(i=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(i=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,i)}return this.interpolate_(n,r,e,i)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,i=this.valueSize,r=e*i;for(let o=0;o!==i;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Sr=class extends Zt{constructor(e,t,n,i){super(e,t,n,i),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ys,endingEnd:Ys}}intervalChanged_(e,t,n){let i=this.parameterPositions,r=e-2,o=e+1,a=i[r],l=i[o];if(a===void 0)switch(this.getSettings_().endingStart){case Zs:r=e,a=2*t-n;break;case Ks:r=i.length-2,a=t+i[r]-i[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Zs:o=e,l=2*n-t;break;case Ks:o=1,l=n+i[1]-i[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,d=this._weightPrev,p=this._weightNext,_=(n-t)/(i-t),v=_*_,S=v*_,M=-d*S+2*d*v-d*_,A=(1+d)*S+(-1.5-2*d)*v+(-.5+d)*_+1,P=(-1-p)*S+(1.5+p)*v+.5*_,L=p*S-p*v;for(let D=0;D!==a;++D)r[D]=M*o[u+D]+A*o[c+D]+P*o[l+D]+L*o[f+D];return r}},Mr=class extends Zt{constructor(e,t,n,i){super(e,t,n,i)}interpolate_(e,t,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(i-t),f=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*f+o[l+d]*u;return r}},Ar=class extends Zt{constructor(e,t,n,i){super(e,t,n,i)}interpolate_(e){return this.copySampleValue_(e-1)}},Er=class extends Zt{interpolate_(e,t,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let _=(n-t)/(i-t),v=1-_;for(let S=0;S!==a;++S)r[S]=o[c+S]*v+o[l+S]*_;return r}let d=a*2,p=e-1;for(let _=0;_!==a;++_){let v=o[c+_],S=o[l+_],M=p*d+_*2,A=f[M],P=f[M+1],L=e*d+_*2,D=u[L],Y=u[L+1],G=Uu(n,t,A,D,i);r[_]=Ka(G,v,P,Y,S)}return r}};function Ka(s,e,t,n,i){let r=1-s;return r*r*r*e+3*r*r*s*t+3*r*s*s*n+s*s*s*i}function Ou(s,e,t,n,i){let r=1-s;return 3*r*r*(t-e)+6*r*s*(n-t)+3*s*s*(i-n)}function Uu(s,e,t,n,i){let r=(s-e)/(i-e);for(let o=0;o<8;o++){let a=Ka(r,e,t,n,i)-s;if(Math.abs(a)<1e-10)break;let l=Ou(r,e,t,n,i);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var $e=class{constructor(e,t,n,i){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=On(t,this.TimeBufferType),this.values=On(n,this.ValueBufferType),this.setInterpolation(i||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:On(e.times,Array),values:On(e.values,Array)};let i=e.getInterpolation();i!==e.DefaultInterpolation&&(n.interpolation=i),hr(e.settings)&&(n.settings={inTangents:On(e.settings.inTangents,Array),outTangents:On(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ar(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Mr(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Sr(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Er(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case vi:t=this.InterpolantFactoryMethodDiscrete;break;case pr:t=this.InterpolantFactoryMethodLinear;break;case ur:t=this.InterpolantFactoryMethodSmooth;break;case $s:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Se("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return vi;case this.InterpolantFactoryMethodLinear:return pr;case this.InterpolantFactoryMethodSmooth:return ur;case this.InterpolantFactoryMethodBezier:return $s}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,i=t.length;n!==i;++n)t[n]+=e;hr(this.settings)&&(Ua(this.settings.inTangents,e),Ua(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,i=t.length;n!==i;++n)t[n]*=e;hr(this.settings)&&(Fa(this.settings.inTangents,e),Fa(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,i=n.length,r=0,o=i-1;for(;r!==i&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==i){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ye("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,i=this.values,r=n.length;r===0&&(ye("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ye("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){ye("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(i!==void 0&&pu(i))for(let a=0,l=i.length;a!==l;++a){let c=i[a];if(isNaN(c)){ye("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),i=this.getInterpolation()===ur,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(i)l=!0;else{let f=a*n,d=f-n,p=f+n;for(let _=0;_!==n;++_){let v=t[f+_];if(v!==t[d+_]||v!==t[p+_]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*n,d=o*n;for(let p=0;p!==n;++p)t[d+p]=t[f+p]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,i=new n(this.name,e,t);return i.createInterpolant=this.createInterpolant,hr(this.settings)&&(i.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),i}};function Ua(s,e){for(let t=0,n=s.length;t!==n;t+=2)s[t]+=e}function Fa(s,e){for(let t=0,n=s.length;t!==n;t+=2)s[t]*=e}$e.prototype.ValueTypeName="";$e.prototype.TimeBufferType=Float32Array;$e.prototype.ValueBufferType=Float32Array;$e.prototype.DefaultInterpolation=pr;var Kt=class extends $e{constructor(e,t,n){super(e,t,n)}};Kt.prototype.ValueTypeName="bool";Kt.prototype.ValueBufferType=Array;Kt.prototype.DefaultInterpolation=vi;Kt.prototype.InterpolantFactoryMethodLinear=void 0;Kt.prototype.InterpolantFactoryMethodSmooth=void 0;var Tr=class extends $e{constructor(e,t,n,i){super(e,t,n,i)}};Tr.prototype.ValueTypeName="color";var Rr=class extends $e{constructor(e,t,n,i){super(e,t,n,i)}};Rr.prototype.ValueTypeName="number";var Cr=class extends Zt{constructor(e,t,n,i){super(e,t,n,i)}interpolate_(e,t,n,i){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(i-t),c=e*a;for(let u=c+a;c!==u;c+=4)Dt.slerpFlat(r,0,o,c-a,o,c,l);return r}},bi=class extends $e{constructor(e,t,n,i){super(e,t,n,i)}InterpolantFactoryMethodLinear(e){return new Cr(this.times,this.values,this.getValueSize(),e)}};bi.prototype.ValueTypeName="quaternion";bi.prototype.InterpolantFactoryMethodSmooth=void 0;var Jt=class extends $e{constructor(e,t,n){super(e,t,n)}};Jt.prototype.ValueTypeName="string";Jt.prototype.ValueBufferType=Array;Jt.prototype.DefaultInterpolation=vi;Jt.prototype.InterpolantFactoryMethodLinear=void 0;Jt.prototype.InterpolantFactoryMethodSmooth=void 0;var Ir=class extends $e{constructor(e,t,n,i){super(e,t,n,i)}};Ir.prototype.ValueTypeName="vector";var to={enabled:!1,files:{},add:function(s,e){this.enabled!==!1&&(Ba(s)||(this.files[s]=e))},get:function(s){if(this.enabled!==!1&&!Ba(s))return this.files[s]},remove:function(s){delete this.files[s]},clear:function(){this.files={}}};function Ba(s){try{let e=s.slice(s.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Pr=class{constructor(e,t,n){let i=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&i.onStart!==void 0&&i.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,i.onProgress!==void 0&&i.onProgress(u,o,a),o===a&&(r=!1,i.onLoad!==void 0&&i.onLoad())},this.itemError=function(u){i.onError!==void 0&&i.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,d=c.length;f<d;f+=2){let p=c[f],_=c[f+1];if(p.global&&(p.lastIndex=0),p.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ja=new Pr,Fn=class{constructor(e){this.manager=e!==void 0?e:Ja,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(i,r){n.load(e,i,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Fn.DEFAULT_MATERIAL_NAME="__DEFAULT";var Pt={},no=class extends Error{constructor(e,t){super(e),this.response=t}},Nr=class extends Fn{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,i){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=to.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Pt[e]!==void 0){Pt[e].push({onLoad:t,onProgress:n,onError:i});return}Pt[e]=[],Pt[e].push({onLoad:t,onProgress:n,onError:i});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&Se("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Pt[e],f=c.body.getReader(),d=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),p=d?parseInt(d):0,_=p!==0,v=0,S=new ReadableStream({start(M){A();function A(){f.read().then(({done:P,value:L})=>{if(P)M.close();else{v+=L.byteLength;let D=new ProgressEvent("progress",{lengthComputable:_,loaded:v,total:p});for(let Y=0,G=u.length;Y<G;Y++){let Q=u[Y];Q.onProgress&&Q.onProgress(D)}M.enqueue(L),A()}},P=>{M.error(P)})}}});return new Response(S)}else throw new no(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let f=/charset="?([^;"\s]*)"?/i.exec(a),d=f&&f[1]?f[1].toLowerCase():void 0,p=new TextDecoder(d);return c.arrayBuffer().then(_=>p.decode(_))}}}).then(c=>{to.add(`file:${e}`,c);let u=Pt[e];delete Pt[e];for(let f=0,d=u.length;f<d;f++){let p=u[f];p.onLoad&&p.onLoad(c)}}).catch(c=>{let u=Pt[e];if(u===void 0)throw this.manager.itemError(e),c;delete Pt[e];for(let f=0,d=u.length;f<d;f++){let p=u[f];p.onError&&p.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Si=class extends Fn{constructor(e){super(e)}load(e,t,n,i){let r=this,o=new wi,a=new Nr(this.manager);return a.setPriority(this.priority),a.setCache(this.cache),a.setResponseType("arraybuffer"),a.setRequestHeader(this.requestHeader),a.setPath(this.path),a.setWithCredentials(r.withCredentials),a.load(e,function(l){let c;try{c=r.parse(l)}catch(u){i!==void 0?i(u):ye(u);return}r._applyTexData(o,c),t&&t(o,c)},n,i),o}createDataTexture(e){let t=new wi;return this._applyTexData(t,this.parse(e)),t}_applyTexData(e,t){t.image!==void 0?e.image=t.image:t.data!==void 0&&(e.image.width=t.width,e.image.height=t.height,e.image.data=t.data),e.wrapS=t.wrapS!==void 0?t.wrapS:un,e.wrapT=t.wrapT!==void 0?t.wrapT:un,e.magFilter=t.magFilter!==void 0?t.magFilter:Yt,e.minFilter=t.minFilter!==void 0?t.minFilter:Yt,e.anisotropy=t.anisotropy!==void 0?t.anisotropy:1,t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.mipmaps!==void 0&&(e.mipmaps=t.mipmaps,e.minFilter=po),t.mipmapCount===1&&(e.minFilter=Yt),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),e.needsUpdate=!0}};var _o="\\[\\]\\.:\\/",Fu=new RegExp("["+_o+"]","g"),vo="[^"+_o+"]",Bu="[^"+_o.replace("\\.","")+"]",zu=/((?:WC+[\/:])*)/.source.replace("WC",vo),ku=/(WCOD+)?/.source.replace("WCOD",Bu),Gu=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",vo),Hu=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",vo),Vu=new RegExp("^"+zu+ku+Gu+Hu+"$"),Wu=["material","materials","bones","map"],io=class{constructor(e,t,n){let i=n||ve.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,i)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,i=this._bindings[n];i!==void 0&&i.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let i=this._targetGroup.nCachedObjects_,r=n.length;i!==r;++i)n[i].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},ve=class s{constructor(e,t,n){this.path=t,this.parsedPath=n||s.parseTrackName(t),this.node=s.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new s.Composite(e,t,n):new s(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Fu,"")}static parseTrackName(e){let t=Vu.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},i=n.nodeName&&n.nodeName.lastIndexOf(".");if(i!==void 0&&i!==-1){let r=n.nodeName.substring(i+1);Wu.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,i),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},i=n(e.children);if(i)return i}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)e[t++]=n[i]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let i=0,r=n.length;i!==r;++i)n[i]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,i=t.propertyName,r=t.propertyIndex;if(e||(e=s.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Se("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ye("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ye("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ye("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ye("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ye("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ye("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ye("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[i];if(o===void 0){let c=t.nodeName;ye("PropertyBinding: Trying to update property for track: "+c+"."+i+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(i==="morphTargetInfluences"){if(!e.geometry){ye("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ye("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=i;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ve.Composite=io;ve.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ve.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ve.prototype.GetterByBindingType=[ve.prototype._getValue_direct,ve.prototype._getValue_array,ve.prototype._getValue_arrayElement,ve.prototype._getValue_toArray];ve.prototype.SetterByBindingTypeAndVersioning=[[ve.prototype._setValue_direct,ve.prototype._setValue_direct_setNeedsUpdate,ve.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_array,ve.prototype._setValue_array_setNeedsUpdate,ve.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_arrayElement,ve.prototype._setValue_arrayElement_setNeedsUpdate,ve.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ve.prototype._setValue_fromArray,ve.prototype._setValue_fromArray_setNeedsUpdate,ve.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var B_=new Float32Array(1);var ro=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,i){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,i)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,i){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=i,this}};typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Se("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");var Xu=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,qu=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,$u=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Yu=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Zu=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ku=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ju=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ju=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Qu=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,ef=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,tf=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,nf=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,rf=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,sf=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,of=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,af=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,lf=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,cf=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,hf=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,uf=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ff=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,df=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,pf=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,mf=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,gf=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,_f=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,vf=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xf=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,yf=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,wf="gl_FragColor = linearToOutputTexel( gl_FragColor );",bf=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Sf=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Mf=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Af=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Ef=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Tf=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Rf=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Cf=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,If=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Pf=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Nf=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Lf=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Df=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Of=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Uf=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Ff=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Bf=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,zf=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,kf=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Gf=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Hf=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Vf=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Wf=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Xf=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,qf=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,$f=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Yf=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Zf=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Kf=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Jf=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,jf=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Qf=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,ed=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,td=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,nd=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,id=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,rd=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,sd=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,od=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ad=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ld=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cd=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,hd=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,ud=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fd=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dd=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,pd=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,md=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,gd=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_d=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,vd=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xd=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,yd=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,wd=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,bd=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Sd=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Md=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Ad=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Ed=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Td=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Rd=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Cd=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Id=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Pd=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Nd=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Ld=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Dd=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Od=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ud=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Fd=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Bd=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,zd=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,kd=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Gd=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Hd=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Vd=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Wd=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Xd=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,qd=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$d=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Yd=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Zd=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Kd=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Jd=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,jd=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Qd=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ep=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,tp=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,np=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ip=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,rp=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,sp=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,op=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ap=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lp=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cp=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,hp=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,up=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,fp=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,dp=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pp=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mp=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,gp=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_p=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vp=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xp=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,yp=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,wp=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,bp=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Sp=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Mp=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,he={alphahash_fragment:Xu,alphahash_pars_fragment:qu,alphamap_fragment:$u,alphamap_pars_fragment:Yu,alphatest_fragment:Zu,alphatest_pars_fragment:Ku,aomap_fragment:Ju,aomap_pars_fragment:ju,batching_pars_vertex:Qu,batching_vertex:ef,begin_vertex:tf,beginnormal_vertex:nf,bsdfs:rf,iridescence_fragment:sf,bumpmap_pars_fragment:of,clipping_planes_fragment:af,clipping_planes_pars_fragment:lf,clipping_planes_pars_vertex:cf,clipping_planes_vertex:hf,color_fragment:uf,color_pars_fragment:ff,color_pars_vertex:df,color_vertex:pf,common:mf,defaultnormal_vertex:gf,displacementmap_pars_vertex:_f,displacementmap_vertex:vf,emissivemap_fragment:xf,emissivemap_pars_fragment:yf,colorspace_fragment:wf,colorspace_pars_fragment:bf,envmap_fragment:Sf,envmap_common_pars_fragment:Mf,envmap_pars_fragment:Af,envmap_pars_vertex:Ef,envmap_physical_pars_fragment:Ff,envmap_vertex:Tf,fog_vertex:Rf,fog_pars_vertex:Cf,fog_fragment:If,fog_pars_fragment:Pf,gradientmap_pars_fragment:Nf,lightmap_pars_fragment:Lf,lights_lambert_fragment:Df,lights_lambert_pars_fragment:Of,lights_pars_begin:Uf,lights_toon_fragment:Bf,lights_toon_pars_fragment:zf,lights_phong_fragment:kf,lights_phong_pars_fragment:Gf,lights_physical_fragment:Hf,lights_physical_pars_fragment:Vf,lights_fragment_begin:Wf,lights_fragment_maps:Xf,lights_fragment_end:qf,lightprobes_pars_fragment:$f,logdepthbuf_fragment:Yf,logdepthbuf_pars_fragment:Zf,logdepthbuf_pars_vertex:Kf,logdepthbuf_vertex:Jf,map_fragment:jf,map_pars_fragment:Qf,map_particle_fragment:ed,map_particle_pars_fragment:td,metalnessmap_fragment:nd,metalnessmap_pars_fragment:id,morphinstance_vertex:rd,morphcolor_vertex:sd,morphnormal_vertex:od,morphtarget_pars_vertex:ad,morphtarget_vertex:ld,normal_fragment_begin:cd,normal_fragment_maps:hd,normal_pars_fragment:ud,normal_pars_vertex:fd,normal_vertex:dd,normalmap_pars_fragment:pd,clearcoat_normal_fragment_begin:md,clearcoat_normal_fragment_maps:gd,clearcoat_pars_fragment:_d,iridescence_pars_fragment:vd,opaque_fragment:xd,packing:yd,premultiplied_alpha_fragment:wd,project_vertex:bd,dithering_fragment:Sd,dithering_pars_fragment:Md,roughnessmap_fragment:Ad,roughnessmap_pars_fragment:Ed,shadowmap_pars_fragment:Td,shadowmap_pars_vertex:Rd,shadowmap_vertex:Cd,shadowmask_pars_fragment:Id,skinbase_vertex:Pd,skinning_pars_vertex:Nd,skinning_vertex:Ld,skinnormal_vertex:Dd,specularmap_fragment:Od,specularmap_pars_fragment:Ud,tonemapping_fragment:Fd,tonemapping_pars_fragment:Bd,transmission_fragment:zd,transmission_pars_fragment:kd,uv_pars_fragment:Gd,uv_pars_vertex:Hd,uv_vertex:Vd,worldpos_vertex:Wd,background_vert:Xd,background_frag:qd,backgroundCube_vert:$d,backgroundCube_frag:Yd,cube_vert:Zd,cube_frag:Kd,depth_vert:Jd,depth_frag:jd,distance_vert:Qd,distance_frag:ep,equirect_vert:tp,equirect_frag:np,linedashed_vert:ip,linedashed_frag:rp,meshbasic_vert:sp,meshbasic_frag:op,meshlambert_vert:ap,meshlambert_frag:lp,meshmatcap_vert:cp,meshmatcap_frag:hp,meshnormal_vert:up,meshnormal_frag:fp,meshphong_vert:dp,meshphong_frag:pp,meshphysical_vert:mp,meshphysical_frag:gp,meshtoon_vert:_p,meshtoon_frag:vp,points_vert:xp,points_frag:yp,shadow_vert:wp,shadow_frag:bp,sprite_vert:Sp,sprite_frag:Mp},W={common:{diffuse:{value:new Ie(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Fe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ie(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ie(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new Ie(16777215)},opacity:{value:1},center:{value:new Fe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},ja={basic:{uniforms:Be([W.common,W.specularmap,W.envmap,W.aomap,W.lightmap,W.fog]),vertexShader:he.meshbasic_vert,fragmentShader:he.meshbasic_frag},lambert:{uniforms:Be([W.common,W.specularmap,W.envmap,W.aomap,W.lightmap,W.emissivemap,W.bumpmap,W.normalmap,W.displacementmap,W.fog,W.lights,{emissive:{value:new Ie(0)},envMapIntensity:{value:1}}]),vertexShader:he.meshlambert_vert,fragmentShader:he.meshlambert_frag},phong:{uniforms:Be([W.common,W.specularmap,W.envmap,W.aomap,W.lightmap,W.emissivemap,W.bumpmap,W.normalmap,W.displacementmap,W.fog,W.lights,{emissive:{value:new Ie(0)},specular:{value:new Ie(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:he.meshphong_vert,fragmentShader:he.meshphong_frag},standard:{uniforms:Be([W.common,W.envmap,W.aomap,W.lightmap,W.emissivemap,W.bumpmap,W.normalmap,W.displacementmap,W.roughnessmap,W.metalnessmap,W.fog,W.lights,{emissive:{value:new Ie(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:he.meshphysical_vert,fragmentShader:he.meshphysical_frag},toon:{uniforms:Be([W.common,W.aomap,W.lightmap,W.emissivemap,W.bumpmap,W.normalmap,W.displacementmap,W.gradientmap,W.fog,W.lights,{emissive:{value:new Ie(0)}}]),vertexShader:he.meshtoon_vert,fragmentShader:he.meshtoon_frag},matcap:{uniforms:Be([W.common,W.bumpmap,W.normalmap,W.displacementmap,W.fog,{matcap:{value:null}}]),vertexShader:he.meshmatcap_vert,fragmentShader:he.meshmatcap_frag},points:{uniforms:Be([W.points,W.fog]),vertexShader:he.points_vert,fragmentShader:he.points_frag},dashed:{uniforms:Be([W.common,W.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:he.linedashed_vert,fragmentShader:he.linedashed_frag},depth:{uniforms:Be([W.common,W.displacementmap]),vertexShader:he.depth_vert,fragmentShader:he.depth_frag},normal:{uniforms:Be([W.common,W.bumpmap,W.normalmap,W.displacementmap,{opacity:{value:1}}]),vertexShader:he.meshnormal_vert,fragmentShader:he.meshnormal_frag},sprite:{uniforms:Be([W.sprite,W.fog]),vertexShader:he.sprite_vert,fragmentShader:he.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:he.background_vert,fragmentShader:he.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:he.backgroundCube_vert,fragmentShader:he.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:he.cube_vert,fragmentShader:he.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:he.equirect_vert,fragmentShader:he.equirect_frag},distance:{uniforms:Be([W.common,W.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:he.distance_vert,fragmentShader:he.distance_frag},shadow:{uniforms:Be([W.lights,W.fog,{color:{value:new Ie(0)},opacity:{value:1}}]),vertexShader:he.shadow_vert,fragmentShader:he.shadow_frag}};ja.physical={uniforms:Be([ja.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Fe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new Ie(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Fe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new Ie(0)},specularColor:{value:new Ie(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Fe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:he.meshphysical_vert,fragmentShader:he.meshphysical_frag};var Ap=new se;Ap.set(-1,0,0,0,1,0,0,0,1);var o1={[so]:"LINEAR_TONE_MAPPING",[oo]:"REINHARD_TONE_MAPPING",[ao]:"CINEON_TONE_MAPPING",[lo]:"ACES_FILMIC_TONE_MAPPING",[ho]:"AGX_TONE_MAPPING",[uo]:"NEUTRAL_TONE_MAPPING",[co]:"CUSTOM_TONE_MAPPING"};var a1=new Float32Array(16),l1=new Float32Array(9),c1=new Float32Array(4);var h1={[so]:"Linear",[oo]:"Reinhard",[ao]:"Cineon",[lo]:"ACESFilmic",[ho]:"AgX",[uo]:"Neutral",[co]:"Custom"};var u1={[za]:"SHADOWMAP_TYPE_PCF",[ka]:"SHADOWMAP_TYPE_VSM"};var f1={[Wa]:"ENVMAP_MODE_REFRACTION"};var d1={[Ga]:"ENVMAP_BLENDING_MULTIPLY",[Ha]:"ENVMAP_BLENDING_MIX",[Va]:"ENVMAP_BLENDING_ADD"};var Ep=new se;Ep.set(-1,0,0,0,1,0,0,0,1);var p1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);var Dr=Math.pow(2,-24),xo=Symbol("SKIP_GENERATION"),Or={strategy:0,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[xo]:!1};function Te(s,e,t){return t.min.x=e[s],t.min.y=e[s+1],t.min.z=e[s+2],t.max.x=e[s+3],t.max.y=e[s+4],t.max.z=e[s+5],t}function Mi(s){let e=-1,t=-1/0;for(let n=0;n<3;n++){let i=s[n+3]-s[n];i>t&&(t=i,e=n)}return e}function yo(s,e,t){for(let n=0;n<3;n++){let i=e[s+2*n],r=e[s+2*n+1],o=i-r,a=i+r;o<t[n]&&(t[n]=o),a>t[n+3]&&(t[n+3]=a)}}function Ur(s){let e=s[3]-s[0],t=s[4]-s[1],n=s[5]-s[2];return 2*(e*t+t*n+n*e)}function Oe(s,e){return e[s+15]===65535}function He(s,e){return e[s+6]}function it(s,e){return e[s+14]}function Ye(s){return s+8}function Ze(s,e){let t=e[s+6];return s+t*8}function Qa(s,e){return e[s+7]}function Fr(s,e,t,n,i){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0,f=1/0,d=1/0,p=1/0,_=-1/0,v=-1/0,S=-1/0,M=s.offset||0;for(let A=(e-M)*6,P=(e+t-M)*6;A<P;A+=6){let L=s[A+0],D=s[A+1],Y=L-D,G=L+D;Y<r&&(r=Y),G>l&&(l=G),L<f&&(f=L),L>_&&(_=L);let Q=s[A+2],k=s[A+3],Z=Q-k,X=Q+k;Z<o&&(o=Z),X>c&&(c=X),Q<d&&(d=Q),Q>v&&(v=Q);let V=s[A+4],oe=s[A+5],ne=V-oe,te=V+oe;ne<a&&(a=ne),te>u&&(u=te),V<p&&(p=V),V>S&&(S=V)}n[0]=r,n[1]=o,n[2]=a,n[3]=l,n[4]=c,n[5]=u,i[0]=f,i[1]=d,i[2]=p,i[3]=_,i[4]=v,i[5]=S}var wt=8,bo=8,wo=new Int32Array(wt),yt=new Float32Array(wt*6),zn=new Float32Array(wt*6),ft=new Float32Array(6),Br=new Float32Array(6),Qt=new Int32Array(bo),tl=new Float32Array(bo*6);function Cp(s,e,t,n){for(let i=0;i<3;i++){let r=e[s+2*i],o=e[s+2*i+1],a=r-o,l=r+o;a<t[n+i]&&(t[n+i]=a),l>t[n+i+3]&&(t[n+i+3]=l)}}function nl(s,e){let t=s[e+3]-s[e],n=s[e+4]-s[e+1],i=s[e+5]-s[e+2];return 2*(t*n+n*i+i*t)}function sl(s,e,t,n,i,r){let o=-1,a=0;if(r===0)o=Mi(e),o!==-1&&(a=(e[o]+e[o+3])/2);else if(r===1)o=Mi(s),o!==-1&&(a=Ip(t,n,i,o));else if(r===2){let l=Ur(s),c=1.25*i,u=t.offset||0,f=(n-u)*6,d=(n+i-u)*6;for(let p=0;p<3;p++){let _=e[p],M=(e[p+3]-_)/wt;if(i<bo){for(let A=0;A<i;A++){let P=f+A*6,L=t[P+2*p],D=A;for(;D>0&&t[Qt[D-1]+2*p]>L;)Qt[D]=Qt[D-1],D--;Qt[D]=P}for(let A=0;A<3;A++)ft[A]=1/0,ft[A+3]=-1/0,Br[A]=1/0,Br[A+3]=-1/0;for(let A=i-1;A>=0;A--)yo(Qt[A],t,Br),tl.set(Br,A*6);for(let A=0;A<i-1;A++){yo(Qt[A],t,ft);let P=t[Qt[A+1]+2*p];if(t[Qt[A]+2*p]===P)continue;let L=A+1,D=i-L,Y=Ur(ft)/l,G=nl(tl,L*6)/l,Q=1+1.25*(Y*L+G*D);Q<c&&(o=p,c=Q,a=P)}}else{for(let L=0;L<wt;L++){wo[L]=0;for(let D=0;D<3;D++)yt[L*6+D]=1/0,yt[L*6+D+3]=-1/0}for(let L=f;L<d;L+=6){let G=~~((t[L+2*p]-_)/M);G>=wt&&(G=wt-1),wo[G]++,Cp(L,t,yt,G*6)}let A=(wt-1)*6;for(let L=0;L<6;L++)zn[A+L]=yt[A+L];for(let L=wt-2;L>=0;L--){let D=L*6,Y=D+6;for(let G=0;G<3;G++)zn[D+G]=Math.min(yt[D+G],zn[Y+G]),zn[D+G+3]=Math.max(yt[D+G+3],zn[Y+G+3])}let P=0;for(let L=0;L<wt-1;L++){let D=L*6,Y=wo[L];if(Y!==0)for(let X=0;X<3;X++)P===0?(ft[X]=yt[D+X],ft[X+3]=yt[D+X+3]):(ft[X]=Math.min(ft[X],yt[D+X]),ft[X+3]=Math.max(ft[X+3],yt[D+X+3]));P+=Y;let G=0,Q=0;P!==0&&(G=Ur(ft)/l);let k=i-P;k!==0&&(Q=nl(zn,D+6)/l);let Z=1+1.25*(G*P+Q*k);Z<c&&(o=p,c=Z,a=_+M+L*M)}}}}else console.warn(`BVH: Invalid build strategy value ${r} used.`);return{axis:o,pos:a}}function Ip(s,e,t,n){let i=0,r=s.offset;for(let o=e,a=e+t;o<a;o++)i+=s[(o-r)*6+n*2];return i/t}function ol(s,e,t,n,i,r){let o=n,a=n+i-1,l=r.pos,c=r.axis*2,u=t.offset||0;for(;;){for(;o<=a&&t[(o-u)*6+c]<l;)o++;for(;o<=a&&t[(a-u)*6+c]>=l;)a--;if(o<a){for(let f=0;f<e;f++){let d=s[o*e+f];s[o*e+f]=s[a*e+f],s[a*e+f]=d}for(let f=0;f<6;f++){let d=o-u,p=a-u,_=t[d*6+f];t[d*6+f]=t[p*6+f],t[p*6+f]=_}o++,a--}else return o}}var Pp=Math.pow(2,32),kn=new Float32Array(6),zr=new Float32Array(6);function Np(s,e,t,n,i,r){let{maxDepth:o,verbose:a,targetLeafSize:l,_strictLeafSize:c=1/0,strategy:u,onProgress:f,useSharedArrayBuffer:d=!1}=i,p=s.primitiveBuffer,_=s.primitiveBufferStride,v=d?SharedArrayBuffer:ArrayBuffer,S=new v(32*Math.max(1,2*Math.ceil(n)-1)),M=new Float32Array(S),A=new Uint32Array(S),P=new Uint16Array(S),L=0,D=!1;return Fr(e,t,n,kn,zr),Q(t,n,0),S.slice(0,L*32);function Y(k){f&&f((k-r.offset)/r.count)}function G(k,Z,X){let V=k*2;A[k+6]=Z,P[V+14]=X,P[V+15]=65535,Y(Z+X)}function Q(k,Z,X){let V=L++,oe=V*8;M.set(kn,oe),!D&&X>=o&&(D=!0,a&&console.warn(`BVH: Max depth of ${o} reached when generating BVH. Consider increasing maxDepth.`));let ne=Z>c;if(Z<=l&&!ne||X>=o){G(oe,k,Z);return}let te=sl(kn,zr,e,k,Z,u),pe=te.axis===-1?-1:ol(p,_,e,k,Z,te);if(te.axis===-1||pe===k||pe===k+Z){if(!ne){G(oe,k,Z);return}te.axis=Math.max(0,Mi(kn)),pe=k+Math.max(1,Math.floor(Z/2))}A[oe+7]=te.axis;let Ue=pe-k;Fr(e,k,Ue,kn,zr),Q(k,Ue,X+1);let Ke=L-V;if(Ke>Pp)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");A[oe+6]=Ke;let Ee=Z-Ue;Fr(e,pe,Ee,kn,zr),Q(pe,Ee,X+1)}}function al(s,e){let t=s.getRootRanges(e.range),n=t[0],i=t[t.length-1],r={offset:n.offset,count:i.offset+i.count-n.offset},o=new Float32Array(6*r.count);o.offset=r.offset,s.computePrimitiveBounds(r.offset,r.count,o),s._roots=t.map(a=>Np(s,o,a.offset,a.count,e,r))}var Gn=class{constructor(e){this._getNewPrimitive=e,this._primitives=[]}getPrimitive(){let e=this._primitives;return e.length===0?this._getNewPrimitive():e.pop()}releasePrimitive(e){this._primitives.push(e)}};var So=class{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;let e=[],t=null;this.setBuffer=n=>{t&&e.push(t),t=n,this.float32Array=new Float32Array(n),this.uint16Array=new Uint16Array(n),this.uint32Array=new Uint32Array(n)},this.clearBuffer=()=>{t=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,e.length!==0&&this.setBuffer(e.pop())}}},Ot=new So;var en,Vn,Hn=[],kr=new Gn(()=>new Me);function ll(s,e,t,n,i,r){en=kr.getPrimitive(),Vn=kr.getPrimitive(),Hn.push(en,Vn),Ot.setBuffer(s._roots[e]);let o=Mo(0,s.geometry,t,n,i,r);Ot.clearBuffer(),kr.releasePrimitive(en),kr.releasePrimitive(Vn),Hn.pop(),Hn.pop();let a=Hn.length;return a>0&&(Vn=Hn[a-1],en=Hn[a-2]),o}function Mo(s,e,t,n,i=null,r=0,o=0){let{float32Array:a,uint16Array:l,uint32Array:c}=Ot,u=s*2;if(Oe(u,l)){let d=He(s,c),p=it(u,l);return Te(s,a,en),n(d,p,!1,o,r+s/8,en)}else{let Z=function(V){let{uint16Array:oe,uint32Array:ne}=Ot,te=V*2;for(;!Oe(te,oe);)V=Ye(V),te=V*2;return He(V,ne)},X=function(V){let{uint16Array:oe,uint32Array:ne}=Ot,te=V*2;for(;!Oe(te,oe);)V=Ze(V,ne),te=V*2;return He(V,ne)+it(te,oe)},d=Ye(s),p=Ze(s,c),_=d,v=p,S,M,A,P;if(i&&(A=en,P=Vn,Te(_,a,A),Te(v,a,P),S=i(A),M=i(P),M<S)){_=p,v=d;let V=S;S=M,M=V,A=P}A||(A=en,Te(_,a,A));let L=Oe(_*2,l),D=t(A,L,S,o+1,r+_/8),Y;if(D===2){let V=Z(_),ne=X(_)-V;Y=n(V,ne,!0,o+1,r+_/8,A)}else Y=D&&Mo(_,e,t,n,i,r,o+1);if(Y)return!0;P=Vn,Te(v,a,P);let G=Oe(v*2,l),Q=t(P,G,M,o+1,r+v/8),k;if(Q===2){let V=Z(v),ne=X(v)-V;k=n(V,ne,!0,o+1,r+v/8,P)}else k=Q&&Mo(v,e,t,n,i,r,o+1);return!!k}}var Ai=new Ot.constructor,Gr=new Ot.constructor,tn=new Gn(()=>new Me),Wn=new Me,Xn=new Me,Ao=new Me,Eo=new Me,To=!1;function cl(s,e,t,n){if(To)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");To=!0;let i=s._roots,r=e._roots,o,a=0,l=0,c=new nt().copy(t).invert();for(let u=0,f=i.length;u<f;u++){Ai.setBuffer(i[u]),l=0;let d=tn.getPrimitive();Te(0,Ai.float32Array,d),d.applyMatrix4(c);for(let p=0,_=r.length;p<_&&(Gr.setBuffer(r[p]),o=dt(0,0,t,c,n,a,l,0,0,d),Gr.clearBuffer(),l+=r[p].byteLength/32,!o);p++);if(tn.releasePrimitive(d),Ai.clearBuffer(),a+=i[u].byteLength/32,o)break}return To=!1,o}function dt(s,e,t,n,i,r=0,o=0,a=0,l=0,c=null,u=!1){let f,d;u?(f=Gr,d=Ai):(f=Ai,d=Gr);let p=f.float32Array,_=f.uint32Array,v=f.uint16Array,S=d.float32Array,M=d.uint32Array,A=d.uint16Array,P=s*2,L=e*2,D=Oe(P,v),Y=Oe(L,A),G=!1;if(Y&&D)u?G=i(He(e,M),it(e*2,A),He(s,_),it(s*2,v),l,o+e/8,a,r+s/8):G=i(He(s,_),it(s*2,v),He(e,M),it(e*2,A),a,r+s/8,l,o+e/8);else if(Y){let Q=tn.getPrimitive();Te(e,S,Q),Q.applyMatrix4(t);let k=Ye(s),Z=Ze(s,_);Te(k,p,Wn),Te(Z,p,Xn);let X=Q.intersectsBox(Wn),V=Q.intersectsBox(Xn);G=X&&dt(e,k,n,t,i,o,r,l,a+1,Q,!u)||V&&dt(e,Z,n,t,i,o,r,l,a+1,Q,!u),tn.releasePrimitive(Q)}else{let Q=Ye(e),k=Ze(e,M);Te(Q,S,Ao),Te(k,S,Eo);let Z=c.intersectsBox(Ao),X=c.intersectsBox(Eo);if(Z&&X)G=dt(s,Q,t,n,i,r,o,a,l+1,c,u)||dt(s,k,t,n,i,r,o,a,l+1,c,u);else if(Z)if(D)G=dt(s,Q,t,n,i,r,o,a,l+1,c,u);else{let V=tn.getPrimitive();V.copy(Ao).applyMatrix4(t);let oe=Ye(s),ne=Ze(s,_);Te(oe,p,Wn),Te(ne,p,Xn);let te=V.intersectsBox(Wn),pe=V.intersectsBox(Xn);G=te&&dt(Q,oe,n,t,i,o,r,l,a+1,V,!u)||pe&&dt(Q,ne,n,t,i,o,r,l,a+1,V,!u),tn.releasePrimitive(V)}else if(X)if(D)G=dt(s,k,t,n,i,r,o,a,l+1,c,u);else{let V=tn.getPrimitive();V.copy(Eo).applyMatrix4(t);let oe=Ye(s),ne=Ze(s,_);Te(oe,p,Wn),Te(ne,p,Xn);let te=V.intersectsBox(Wn),pe=V.intersectsBox(Xn);G=te&&dt(k,oe,n,t,i,o,r,l,a+1,V,!u)||pe&&dt(k,ne,n,t,i,o,r,l,a+1,V,!u),tn.releasePrimitive(V)}}return G}var Hr=new class{constructor(){let s=null,e=null,t=null,n=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(r,o)=>{if(n)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=o,this.buffer=s=r._roots[o],this.uint16Array=t=new Uint16Array(s),this.uint32Array=e=new Uint32Array(s)},this.reset=()=>{this.root=null,this.buffer=s=null,this.uint16Array=t=null,this.uint32Array=e=null},this.getRangeStart=r=>{let o=r*2;for(;!Oe(o,t);)r=Ye(r),o=r*2;return He(r,e)},this.getRangeEnd=r=>{let o=r*2;for(;!Oe(o,t);)r=Ze(r,e),o=r*2;return He(r,e)+it(o,t)};let i=(r,o,a)=>{let l=o*2,c=Oe(l,t);if(!r(a,c,o)&&!c){let f=Ye(o),d=Ze(o,e);i(r,f,a+1),i(r,d,a+1)}};this.traverseBuffer=r=>{if(n)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");n=!0;try{i(r,0,0)}finally{n=!1}},this.traverse=r=>{this.traverseBuffer((o,a,l)=>{if(a){let c=l*2,u=e[l+6],f=t[c+14];return r(o,a,new Float32Array(s,l*4,6),u,f)}else{let c=Qa(l,e);return r(o,a,new Float32Array(s,l*4,6),c)}})}}};var hl=new Me,qn=new Float32Array(6),Vr=class{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(e){e={...Or,...e},"maxLeafSize"in e&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),e={...e,targetLeafSize:e.maxLeafSize}),al(this,e)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(e,t,n,i){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0;for(let f=e,d=e+t;f<d;f++){this.writePrimitiveBounds(f,qn,0);let[p,_,v,S,M,A]=qn;p<r&&(r=p),S>l&&(l=S),_<o&&(o=_),M>c&&(c=M),v<a&&(a=v),A>u&&(u=A)}return n[i+0]=r,n[i+1]=o,n[i+2]=a,n[i+3]=l,n[i+4]=c,n[i+5]=u,n}computePrimitiveBounds(e,t,n){let i=n.offset||0;for(let r=e,o=e+t;r<o;r++){this.writePrimitiveBounds(r,qn,0);let[a,l,c,u,f,d]=qn,p=(a+u)/2,_=(l+f)/2,v=(c+d)/2,S=(u-a)/2,M=(f-l)/2,A=(d-c)/2,P=(r-i)*6;n[P+0]=p,n[P+1]=S+(Math.abs(p)+S)*Dr,n[P+2]=_,n[P+3]=M+(Math.abs(_)+M)*Dr,n[P+4]=v,n[P+5]=A+(Math.abs(v)+A)*Dr}return n}shiftPrimitiveOffsets(e){let t=this._indirectBuffer;if(t)for(let n=0,i=t.length;n<i;n++)t[n]+=e;else{let n=this._roots;for(let i=0;i<n.length;i++){let r=n[i],o=new Uint32Array(r),a=new Uint16Array(r),l=r.byteLength/32;for(let c=0;c<l;c++){let u=8*c,f=2*u;Oe(f,a)&&(o[u+6]+=e)}}}}traverse(e,t=0){Hr.setBVH(this,t),Hr.traverse(e),Hr.reset()}refit(){let e=this._roots;for(let t=0,n=e.length;t<n;t++){let i=e[t],r=new Uint32Array(i),o=new Uint16Array(i),a=new Float32Array(i),l=i.byteLength/32;for(let c=l-1;c>=0;c--){let u=c*8,f=u*2;if(Oe(f,o)){let p=He(u,r),_=it(f,o);this.writePrimitiveRangeBounds(p,_,qn,0),a.set(qn,u)}else{let p=Ye(u),_=Ze(u,r);for(let v=0;v<3;v++){let S=a[p+v],M=a[p+v+3],A=a[_+v],P=a[_+v+3];a[u+v]=S<A?S:A,a[u+v+3]=M>P?M:P}}}}}getBoundingBox(e){return e.makeEmpty(),this._roots.forEach(n=>{Te(0,new Float32Array(n),hl),e.union(hl)}),e}shapecast(e){let{boundsTraverseOrder:t,intersectsBounds:n,intersectsRange:i,intersectsPrimitive:r,scratchPrimitive:o,iterate:a}=e;if(i&&r){let f=i;i=(d,p,_,v,S)=>f(d,p,_,v,S)?!0:a(d,p,this,r,_,v,o)}else i||(r?i=(f,d,p,_)=>a(f,d,this,r,p,_,o):i=(f,d,p)=>p);let l=!1,c=0,u=this._roots;for(let f=0,d=u.length;f<d;f++){let p=u[f];if(l=ll(this,f,n,i,t,c),l)break;c+=p.byteLength/32}return l}bvhcast(e,t,n){let{intersectsRanges:i}=n;return cl(this,e,t,i)}};function ul(){return typeof SharedArrayBuffer<"u"}function fl(s){return s.index?s.index.count:s.attributes.position.count}function Op(s,e=ArrayBuffer){return s>65535?new Uint32Array(new e(4*s)):new Uint16Array(new e(2*s))}function dl(s,e){if(!s.index){let t=s.attributes.position.count,n=e.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,i=Op(t,n);s.setIndex(new ht(i,1));for(let r=0;r<t;r++)i[r]=r}}function Up(s,e,t){let n=fl(s)/t,i=e||s.drawRange,r=i.start/t,o=(i.start+i.count)/t,a=Math.max(0,r),l=Math.min(n,o)-a;return{offset:Math.floor(a),count:Math.floor(l)}}function Fp(s,e){return s.groups.map(t=>({offset:t.start/e,count:t.count/e}))}function Ro(s,e,t){let n=Up(s,e,t),i=Fp(s,t);if(!i.length)return[n];let r=[],o=n.offset,a=n.offset+n.count,l=fl(s)/t,c=[];for(let d of i){let{offset:p,count:_}=d,v=p,S=isFinite(_)?_:l-p,M=p+S;v<a&&M>o&&(c.push({pos:Math.max(o,v),isStart:!0}),c.push({pos:Math.min(a,M),isStart:!1}))}c.sort((d,p)=>d.pos!==p.pos?d.pos-p.pos:d.type==="end"?-1:1);let u=0,f=null;for(let d of c){let p=d.pos;u!==0&&p!==f&&r.push({offset:f,count:p-f}),u+=d.isStart?1:-1,f=p}return r}function Bp(s,e){let t=s[s.length-1],n=t.offset+t.count>2**16,i=s.reduce((c,u)=>c+u.count,0),r=n?4:2,o=e?new SharedArrayBuffer(i*r):new ArrayBuffer(i*r),a=n?new Uint32Array(o):new Uint16Array(o),l=0;for(let c=0;c<s.length;c++){let{offset:u,count:f}=s[c];for(let d=0;d<f;d++)a[l+d]=u+d;l+=f}return a}var Wr=class extends Vr{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(e){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(e){}constructor(e,t={}){if(e.isBufferGeometry){if(e.index&&e.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(t.useSharedArrayBuffer&&!ul())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=e,this.resolvePrimitiveIndex=t.indirect?n=>this._indirectBuffer[n]:n=>n,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,t={...Or,...t},t[xo]||this.init(t)}init(e){let{geometry:t,primitiveStride:n}=this;if(e.indirect){let i=Ro(t,e.range,n),r=Bp(i,e.useSharedArrayBuffer);this._indirectBuffer=r}else dl(t,e);super.init(e),!t.boundingBox&&e.setBoundingBox&&(t.boundingBox=this.getBoundingBox(new Me))}getRootRanges(e){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:Ro(this.geometry,e,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}};var zp=1e5,kp=48,Co=class s extends Wr{constructor(e){let t=new yi;t.setIndex({count:e.length/6,array:null}),s.boxes=e;let n=e.length/6;super(t,{indirect:!0,strategy:n>zp?0:2,maxDepth:kp-2,targetLeafSize:4,setBoundingBox:!1,verbose:!1,range:{start:0,count:n}}),s.boxes=null}get primitiveStride(){return 1}writePrimitiveBounds(e,t,n){let i=s.boxes,r=6*this._indirectBuffer[e];for(let o=0;o<6;o++)t[n+o]=i[r+o];return t}};function pl(s){let e=new Co(s);return{nodes:new Uint32Array(e._roots[0]),order:Uint32Array.from(e._indirectBuffer)}}var Gp=2147483648,Hp=1,Vp=2;function Xr(s){let e=s.map(Wp),t=u=>e.reduce((f,d)=>f+d[u],0),n={primitives:new Uint32Array(4*t("primitives")),places:new Float32Array(4*t("vertices")),normals:new Float32Array(4*t("corners")),boxes:new Float32Array(6*t("primitives")),records:[],texels:[],parts:[],largest:0,strands:0},i={primitive:0,vertex:0},r=[...s.keys()].sort((u,f)=>(s[u].kind==="fiber")-(s[f].kind==="fiber"));for(let u of r){let f=s[u];n.parts[u]={first:i.primitive,count:e[u].primitives,fiber:f.kind==="fiber"},f.kind==="fiber"?Yp(n,f.curves,i):Xp(n,f,i),i={primitive:i.primitive+e[u].primitives,vertex:i.vertex+e[u].vertices}}let{nodes:o,order:a}=pl(n.boxes),l=new Uint32Array(n.primitives.length);a.forEach((u,f)=>l.set(n.primitives.subarray(4*u,4*u+4),4*f));let c=new Uint32Array(a.length);return a.forEach((u,f)=>{c[u]=f}),{...n,boxes:null,primitives:l,nodes:o,where:c,texels:$p(n.texels),records:Uint32Array.from(n.records.flat()),recordCount:n.records.length,epsilon:n.largest*2**-18,box:Zp(o)}}function Wp({kind:s,mesh:e,curves:t}){if(s==="surface"){let i=e.positions.length/3;return{primitives:e.indices.length/3,vertices:i,corners:i}}let n=t.radii.length;return{primitives:n-(t.offsets.length-1),vertices:n,corners:0}}function Xp(s,{mesh:e,transmittance:t,normalMaps:n},{primitive:i,vertex:r}){let{positions:o,normals:a,uvs:l,indices:c}=e,{places:u,boxes:f,primitives:d}=s;for(let p=0;p<o.length/3;p++){let _=4*(r+p);for(let v=0;v<3;v++)u[_+v]=o[3*p+v],s.normals[_+v]=a[3*p+v],s.largest=Math.max(s.largest,Math.abs(o[3*p+v]));u[_+3]=l?l[2*p]:0,s.normals[_+3]=l?l[2*p+1]:0}for(let p=0;p<c.length/3;p++){let _=[0,1,2].map(v=>c[3*p+v]);d.set([..._.map(v=>v+r),i+p],4*(i+p));for(let v=0;v<3;v++){let S=_.map(M=>o[3*M+v]);f[6*(i+p)+v]=Math.min(...S),f[6*(i+p)+3+v]=Math.max(...S)}}for(let p of t)ml(s,p,i,0);for(let p of n)ml(s,p,i,1)}var gl=new Float32Array(1),qp=new Uint32Array(gl.buffer);function Io(s){return gl[0]=s,qp[0]}function ml(s,{triangles:[e,t],texture:n,cutoff:i,ior:r},o,a){let l=s.texels.reduce((c,u)=>c+u.length,0);s.texels.push(n.values),s.records.push([a,o+e,o+e+t,l,n.width,n.height,n.channels,Io(i??-1),Io(r?.[0]??0),Io(r?.[1]??0),0,0])}function $p(s){let e=new Uint8Array(s.reduce((n,i)=>n+i.length,0)),t=0;for(let n of s)e.set(n,t),t+=n.length;return e}function Yp(s,{points:e,radii:t,offsets:n},{primitive:i,vertex:r}){let{places:o,boxes:a,primitives:l}=s;for(let u=0;u<t.length;u++){let[f,d,p]=e.subarray(3*u,3*u+3);o.set([f,d,p,t[u]],4*(r+u)),s.largest=Math.max(s.largest,Math.max(Math.abs(f),Math.abs(d),Math.abs(p))+t[u])}let c=i;for(let u=0;u+1<n.length;u++,s.strands++)for(let f=n[u];f+1<n[u+1];f++,c++){let d=(f>n[u]&&Hp)|(f+2<n[u+1]&&Vp);l.set([r+f,d,s.strands,(c|Gp)>>>0],4*c);for(let p=0;p<3;p++){let _=e[3*f+p],v=e[3*f+3+p],S=t[f]*1.0005,M=t[f+1]*1.0005;a[6*c+p]=Math.min(_-S,v-M),a[6*c+3+p]=Math.max(_+S,v+M)}}}function Zp(s){let e=new Float32Array(s.buffer,0,6);return{min:[...e.subarray(0,3)],max:[...e.subarray(3,6)]}}var Ut=[{name:"features",width:null,kinds:["surface","fiber"],light:!1},{name:"position",width:3,kinds:["surface","fiber"],light:!1},{name:"normal",width:3,kinds:["surface"],light:!1},{name:"tangent",width:3,kinds:["fiber"],light:!1},{name:"h",width:1,kinds:["fiber"],light:!1},{name:"wo",width:3,kinds:["surface","fiber"],light:!1},{name:"wi",width:3,kinds:["surface","fiber"],light:!0},{name:"half_vector",width:5,kinds:["surface"],light:!0},{name:"highlight",width:1,kinds:["surface"],light:!0},{name:"learned_normal",width:2,kinds:["surface"],light:!0},{name:"fiber_angles",width:6,kinds:["fiber"],light:!0},{name:"fiber_lobes",width:3,kinds:["fiber"],light:!0}];var vn=s=>Ut.find(e=>e.name===s),qr=(s,e)=>vn(s).width??e;var nn=22,xn=46,Ei=30,_l=64,vl=256,Jp=/^[A-Za-z0-9_-][A-Za-z0-9._-]*(\/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$/,$n="manifest.json",xl=2**20,Ri=s=>new DataView(s.buffer,s.byteOffset,s.byteLength);async function wl(s){let{size:e}=s;e===0&&w("FILE_EMPTY",s.name,"the file has no bytes"),e>2**32-2&&w("FILE_TOO_LARGE",s.name,`${e} bytes`);let{count:t,start:n}=await jp(s),i=await s.read(n,e-nn),r=em(i,t,n,s.name);return nm(r,n,s.name),new Map(r.map(o=>[o.name,o]))}async function jp(s){let{size:e,name:t}=s,n=Ri(await s.read(0,Math.min(4,e))),r=e>=4&&n.getUint32(0,!0)===67324752?"ZIP_TRUNCATED":"ZIP_NOT_ZIP";e<nn&&w(r,t,"shorter than the end record of a ZIP archive");let o=Ri(await s.read(e-nn,e)),a=e===nn&&o.getUint32(0,!0)===101010256;o.getUint32(0,!0)!==101010256&&await Qp(s,r);let l=d=>o.getUint16(d,!0);[4,6,8,10].some(d=>l(d)===65535)&&w("ZIP_ZIP64",t,"a ZIP64 archive"),(l(4)||l(6))&&w("ZIP_ZIP64",t,"an archive of several disks");let c=l(10),u=o.getUint32(12,!0),f=o.getUint32(16,!0);return c>vl&&w("ZIP_TOO_MANY",t,`${c} entries; at most ${vl}`),(l(8)!==c||l(20)!==0||f+u!==e-nn)&&w("ZIP_DIRECTORY",t,"the end record does not fit the central directory"),(a||c===0)&&w("ZIP_ORDER",t,`${$n} is not the first entry`),{count:c,start:f}}async function Qp(s,e){let t=await s.read(Math.max(0,s.size-nn-65535),s.size),n=Ri(t);for(let i=t.length-nn;i>=0;i--)n.getUint32(i,!0)===101010256&&i+nn+n.getUint16(i+20,!0)===t.length&&w("ZIP_DIRECTORY",s.name,"the archive has a comment");w(e,s.name,"the file does not end with the end record of a ZIP archive")}function em(s,e,t,n){let i=Ri(s),r=[],o=new Set,a=0;for(let l=0;l<e;l++){(a+xn>s.length||i.getUint32(a,!0)!==33639248)&&w("ZIP_DIRECTORY",n,`the central directory has no header ${l}`);let c=i.getUint16(a+28,!0);(a+xn+c>s.length||i.getUint32(a+30,!0))&&w("ZIP_DIRECTORY",n,`header ${l} of the central directory is malformed`);let u=s.subarray(a+xn,a+xn+c),f=String.fromCharCode(...u);tm(i,a,f,n),(!Jp.test(f)||f.includes(`
`)||c>200)&&w("ZIP_NAME",n,`an entry is called ${JSON.stringify(f.slice(0,80))}`);let d=f.toLowerCase();o.has(d)&&w("ZIP_DUPLICATE",f,"the name is there twice"),o.add(d),r.push({name:f,size:i.getUint32(a+24,!0),crc:i.getUint32(a+16,!0),header:i.getUint32(a+42,!0),central:s.subarray(a,a+xn+c)}),a+=xn+c}a!==s.length&&w("ZIP_DIRECTORY",n,"bytes behind the last central header");for(let{name:l,header:c,size:u}of r)c+Ei+l.length+u>t&&w("ZIP_TRUNCATED",l,`${u} bytes reach past the entries`);return r}function tm(s,e,t,n){let i=l=>s.getUint16(e+l,!0),r=l=>s.getUint32(e+l,!0),o=JSON.stringify(t.slice(0,80));(r(42)===4294967295||r(20)===4294967295||r(24)===4294967295)&&w("ZIP_ZIP64",n,`${o} needs ZIP64`),i(34)&&w("ZIP_ZIP64",n,`${o} is on another disk`),i(8)&1&&w("ZIP_ENCRYPTED",n,`${o} is encrypted`),([[4,20],[6,20],[8,0],[12,0],[14,33],[36,0]].some(([l,c])=>i(l)!==c)||r(38))&&w("ZIP_HEADER",n,`${o}: a version, flag, time or attribute is not the fixed one`),i(10)&&w("ZIP_COMPRESSED",n,`${o} is compressed`),r(20)!==r(24)&&w("ZIP_SIZE",n,`${o} has two sizes`)}function nm(s,e,t){let n=[...s].sort((o,a)=>o.header-a.header),i=0;n.forEach((o,a)=>{o.end=a+1<n.length?n[a+1].header:e,o.extra=o.end-o.header-Ei-o.name.length-o.size,o.extra<0&&w("ZIP_OVERLAP",o.name,"shares bytes with the next entry"),o.header!==i&&w("ZIP_GAP",t,`bytes ${i} to ${o.header} are no entry's`),i=o.end});let r=n[0];r.name!==$n&&w("ZIP_ORDER",t,`${$n} is not the first entry`),r.size>xl&&w("MANIFEST_TOO_LARGE",$n,`${r.size} bytes; at most ${xl}`)}function bl(s,e){let t=Ri(e),{name:n}=s,i=s.name.length;e.length<s.end-s.header&&w("ZIP_TRUNCATED",n,"the file ends within it"),t.getUint32(0,!0)===67324752&&t.getUint16(26,!0)===i&&yl(e.subarray(4,26),s.central.subarray(6,28))&&yl(e.subarray(Ei,Ei+i),s.central.subarray(xn))||w("ZIP_LOCAL_HEADER",n,"local and central header differ");let o=t.getUint16(28,!0),a=Ei+i;im(e.subarray(a,a+o),o,n),(s.header+a+o)%_l&&w("ZIP_ALIGNMENT",n,`data at byte ${s.header+a+o}, no multiple of ${_l}`),o!==s.extra&&w(o>s.extra?"ZIP_OVERLAP":"ZIP_GAP",n,"its data does not end where the next entry starts");let l=e.subarray(a+o,a+o+s.size);return rm(l)!==s.crc&&w("ZIP_CRC",n,"the bytes do not have the CRC-32 of the header"),l}function im(s,e,t){if(e===0)return;e>=4&&s.length===e&&s[0]===82&&s[1]===78&&s[2]+256*s[3]===e-4&&s.subarray(4).every(i=>i===0)||w("ZIP_EXTRA",t,"the extra field is not zero padding")}var yl=(s,e)=>s.length===e.length&&s.every((t,n)=>t===e[n]),Ti=Array.from({length:4},()=>new Uint32Array(256));for(let s=0;s<256;s++){let e=s;for(let t=0;t<8;t++)e=e&1?e>>>1^3988292384:e>>>1;Ti[0][s]=e>>>0}for(let s=1;s<4;s++)for(let e=0;e<256;e++){let t=Ti[s-1][e];Ti[s][e]=t>>>8^Ti[0][t&255]}function rm(s){let[e,t,n,i]=Ti,r=4294967295,o=0;for(;o+4<=s.length;o+=4)r^=s[o]|s[o+1]<<8|s[o+2]<<16|s[o+3]<<24,r=i[r&255]^n[r>>>8&255]^t[r>>>16&255]^e[r>>>24];for(;o<s.length;o++)r=e[(r^s[o])&255]^r>>>8;return(r^4294967295)>>>0}var sm=64,om=/-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y,am=/[ \t\n\r]*/y,lm=/[^"\\\u0000-\u001f]*/y,Sl={'"':'"',"\\":"\\","/":"/",b:"\b",f:"\f",n:`
`,r:"\r",t:"	"};function Yn(s,e,t){let n;try{n=new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(s)}catch{w(t,e,"no UTF-8")}let i=new Po(n,e,t);i.space(),n[i.at]!=="{"&&w(t,e,"not a JSON object");let r=i.value(1);return i.space(),i.at!==n.length&&i.bad(),r}var Po=class{constructor(e,t,n){Object.assign(this,{text:e,where:t,code:n,at:0})}bad(e="malformed JSON"){w(this.code,this.where,`${e} at character ${this.at}`)}match(e){e.lastIndex=this.at;let t=e.exec(this.text);return t&&(this.at=e.lastIndex),t}space(){this.match(am)}take(e){return this.text.startsWith(e,this.at)?(this.at+=e.length,!0):!1}value(e){let t=this.text[this.at];if((t==="{"||t==="[")&&e>sm&&this.bad("nested too deep"),t==="{")return this.object(e);if(t==="[")return this.array(e);if(t==='"')return this.string();for(let[r,o]of[["true",!0],["false",!1],["null",null]])if(this.take(r))return o;/NaN|-?Infinity/y.test(this.text.slice(this.at,this.at+9))&&this.notFinite();let n=this.match(om);n||this.bad();let i=Number(n[0]);return Number.isFinite(i)||this.notFinite(),i===0?0:i}notFinite(){w("JSON_NOT_FINITE",this.where,`no finite number at character ${this.at}`)}list(e,t){if(this.at+=1,this.space(),!this.take(e)){do this.space(),t(),this.space();while(this.take(","));this.take(e)||this.bad()}}array(e){let t=[];return this.list("]",()=>t.push(this.value(e+1))),t}object(e){let t=new Map;this.list("}",()=>{this.text[this.at]!=='"'&&this.bad();let i=this.string();t.has(i)&&w("JSON_DUPLICATE_KEY",this.where,`the key "${i}" twice`),this.space(),this.take(":")||this.bad(),this.space(),t.set(i,this.value(e+1))});let n=Object.create(null);for(let[i,r]of t)n[i]=r;return n}string(){let e="";for(this.at+=1;e+=this.match(lm)[0],!this.take('"');){this.take("\\")||this.bad();let t=this.text[this.at++];if(t==="u"){let n=this.match(/[0-9a-fA-F]{4}/y);n||this.bad(),e+=String.fromCharCode(parseInt(n[0],16))}else t in Sl?e+=Sl[t]:this.bad()}return e.isWellFormed()||this.bad("half of a surrogate pair"),e}};var Ml={F32:Float32Array,F16:Uint16Array,I8:Int8Array,U8:Uint8Array,U16:Uint16Array,I16:Int16Array,U32:Uint32Array,I32:Int32Array},cm=65536;function Zn(s,e,t,n){let i=e.byteOffset+t;return i%s.BYTES_PER_ELEMENT===0?new s(e.buffer,i,n):new s(e.slice(t,t+n*s.BYTES_PER_ELEMENT).buffer)}function Kn(s,e,t){s.length<8&&w(t,e,"shorter than a header");let n=new DataView(s.buffer,s.byteOffset).getBigUint64(0,!0);(n>cm||Number(n)>s.length-8)&&w(t,e,`a header of ${n} bytes`);let i=8+Number(n);s[8]!==123&&w(t,e,"the header does not start with {");let{__metadata__:r,...o}=Yn(s.subarray(8,i),e,t);return{tensors:o,metadata:r,data:i}}var El=s=>s!==null&&typeof s=="object"&&!Array.isArray(s),Al=s=>Number.isSafeInteger(s)&&s>=0;function Jn(s){return El(s)&&typeof s.dtype=="string"&&Array.isArray(s.shape)&&s.shape.every(Al)&&Array.isArray(s.data_offsets)&&s.data_offsets.length===2&&s.data_offsets.every(Al)}var jn=s=>s===void 0||El(s);function Qn(s,{tensors:e,data:t},n,i,r){let o=0,a=n.map(l=>{let{dtype:c,shape:u,data_offsets:[f,d]}=e[l],p=u.reduce((_,v)=>_*v,1);return(f!==o||d-f!==p*Ml[c].BYTES_PER_ELEMENT||t+d>s.length)&&w(r,i,`the bytes of ${l} are not where they must be`),o=d,Zn(Ml[c],s,t+f,p)});return t+o!==s.length&&w(r,i,"bytes behind the last tensor"),a}var Tl=2**26,hm=2**25,um=2**31,fm={points:[["F32"],2],radii:[["F32"],1],offsets:[["U32"],1]},dm={scales:[["F32"],1],origins:[["F32"],2],offsets:[["U32"],1],steps:[["I16","I32"],2],radii:[["U8","U16"],1]};function Rl(s,e,t){let n=Kn(s,e,"GEOMETRY_CONTAINER"),{tensors:i}=n,r="steps"in i||"scales"in i,o=r?dm:fm,a=Object.keys(o);pm(n,o,a,e),r&&t&&w("VERSION_TOO_OLD",e,"quantised curves in a package for readers of 1.0");let l=Object.fromEntries(a.map(v=>[v,i[v].shape])),c=Qn(s,n,a,e,"GEOMETRY_RANGE"),u=Object.fromEntries(a.map((v,S)=>[v,c[S]])),f=l.offsets[0]-1,d=l.radii[0];(!(r?l.origins[0]===f&&l.steps[0]===d-f&&l.scales[0]===2:l.points[0]===d)||f<1)&&w("GEOMETRY_ARRAY",e,"tensors whose shapes do not fit each other"),mm(u.offsets,d,e);let _=r?gm(u,e):u;return _m(_,e),_}function pm(s,e,t,n){let{tensors:i}=s,r="GEOMETRY_PROFILE",o=Object.keys(i);(o.length!==t.length||t.some(l=>!o.includes(l)))&&w(r,n,`found ${o.join(", ")||"no tensors"}, expected ${t.join(", ")}`),jn(s.metadata)||w(r,n,"__metadata__ is no object");for(let[l,[c,u]]of Object.entries(e)){let f=i[l];Jn(f)&&c.includes(f.dtype)&&f.shape.length===u&&(u===1||f.shape[1]===3)||w(r,n,`${l} is not ${c.join(" or ")} of ${u} dimensions`)}((i.points??i.radii).shape[0]>Tl||i.radii.shape[0]>Tl||i.offsets.shape[0]-1>hm)&&w(r,n,"more points or strands than allowed"),s.data%64&&w(r,n,"data does not start at a multiple of 64")}function mm(s,e,t){let n=s[0]===0&&s.at(-1)===e;for(let i=1;i<s.length&&n;i++)n=s[i]>=s[i-1]+2;n||w("GEOMETRY_STRANDS",t,"the offsets do not part the points into strands")}function gm({scales:s,origins:e,offsets:t,steps:n,radii:i},r){let[o,a]=s;o>0&&Number.isFinite(o)||w("GEOMETRY_STEPS",r,"steps without length"),e.some(u=>!Number.isFinite(u))&&w("GEOMETRY_NOT_FINITE",r,"an origin is not finite"),(!(a>0&&Number.isFinite(a))||i.some(u=>u===0))&&w("GEOMETRY_RADIUS",r,"a radius that is not above 0");let l=new Float32Array(3*i.length),c=0;for(let u=0;u+1<t.length;u++){for(let f=0;f<3;f++){let d=e[3*u+f],p=0;l[3*t[u]+f]=d;for(let _=t[u]+1,v=c;_<t[u+1];_++,v++)p+=n[3*v+f],Math.abs(p)>um&&w("GEOMETRY_STEPS",r,`strand ${u} goes too far`),l[3*_+f]=d+o*p}c+=t[u+1]-t[u]-1}return{points:l,radii:Float32Array.from(i,u=>u*a),offsets:t}}function _m({points:s,radii:e,offsets:t},n){(s.some(i=>!Number.isFinite(i))||e.some(i=>!Number.isFinite(i)))&&w("GEOMETRY_NOT_FINITE",n,"a point or a radius is not finite");for(let i=0;i+1<t.length;i++)for(let r=t[i]+1;r<t[i+1];r++)s[3*r]===s[3*r-3]&&s[3*r+1]===s[3*r-2]&&s[3*r+2]===s[3*r-1]&&w("GEOMETRY_SEGMENT",n,`two equal points in strand ${i}`);e.some(i=>!(i>0))&&w("GEOMETRY_RADIUS",n,"a radius that is not above 0")}var vm={1:Float32Array,2:Uint8Array,3:Int8Array,6:Int32Array},xm=64*2**20,ym=4096,wm=2**18;function Il(s,e){s.length>xm&&w("DECODER_TOO_LARGE",e,`${s.length} bytes`);let t=l=>w("DECODER_NOT_ONNX",e,l),n=new No(t),i=n.message(s,{1:"one",7:"one",8:"many",20:"many",25:"many"});(!i[7]||!i[1])&&t("no graph, or no IR version"),(i[20].length||i[25].length)&&w("DECODER_NESTED",e,"functions or training information"),bm(i,n,e);let r=n.message(i[7],{1:"many",5:"many",11:"many",12:"many",15:"many"});r[15].length&&w("DECODER_NESTED",e,"sparse tensors"),r[1].length>ym&&w("DECODER_GRAPH",e,`${r[1].length} nodes`);let o=r[1].map(l=>Sm(n,l,e)),a=new Map;for(let l of r[5]){let c=Pl(n,l,e);a.has(c.name)&&w("DECODER_GRAPH",e,`${c.name} is there twice`),a.set(c.name,c)}return{nodes:o,constants:a,inputs:r[11].map(l=>Cl(n,l)),outputs:r[12].map(l=>Cl(n,l))}}function bm(s,e,t){let n=Number(s[1]);n>=7&&n<=10||w("DECODER_VERSION",t,`IR version ${n}`);let i=s[8].map(a=>e.message(a,{1:"one",2:"one"})),r=i.map(a=>e.text(a[1]));r.some(a=>a!==""&&a!=="ai.onnx")&&w("DECODER_DOMAIN",t,`operators of ${r.join(", ")}`);let o=Number(i[0]?.[2]??0);(i.length!==1||o<13||o>21)&&w("DECODER_VERSION",t,`operator set ${o}`)}function Sm(s,e,t){let n=s.message(e,{1:"many",2:"many",4:"one",5:"many",7:"one"}),i=s.text(n[7]);i!==""&&i!=="ai.onnx"&&w("DECODER_DOMAIN",t,`an operator of ${i}`);let r={};for(let o of n[5]){let{1:a,3:l,5:c,6:u,11:f}=s.message(o,{1:"one",3:"one",5:"one",6:"one",11:"many"});(u||f.length)&&w("DECODER_NESTED",t,"a graph within a node"),c&&Pl(s,c,t),r[s.text(a)]=l===void 0?null:Number(BigInt.asIntN(64,l))}return{operator:s.text(n[4]),inputs:n[1].map(s.text),outputs:n[2].map(s.text),attributes:r}}function Pl(s,e,t){let n=s.message(e,{1:"numbers",2:"one",8:"one",9:"one",13:"many",14:"one"});(n[13].length||n[14])&&w("DECODER_EXTERNAL",t,"data outside the file");let i=n[1].map(Number),r=Number(n[2]??0);(i.length>2||i.some(c=>c>8192)||![1,2,3,6,7,9,10].includes(r))&&w("DECODER_TENSOR",t,`a tensor of type ${r} and shape [${i}]`);let o=i.reduce((c,u)=>c*u,1),a=vm[r],l=a&&n[9]instanceof Uint8Array&&n[9].length===o*a.BYTES_PER_ELEMENT;return{name:s.text(n[8]),type:r,dims:i,values:l?Zn(a,n[9],0,o):null}}function Cl(s,e){let t=s.message(e,{1:"one",2:"one"}),n=s.message(t[2]??new Uint8Array,{1:"one"}),i=s.message(n[1]??new Uint8Array,{1:"one",2:"one"}),o=s.message(i[2]??new Uint8Array,{1:"many"})[1].map(a=>{let{1:l,2:c}=s.message(a,{1:"one",2:"one"});return c!==void 0&&s.text(c),l===void 0?null:Number(l)});return{name:s.text(t[1]),type:Number(i[1]??0),dims:o}}var No=class{constructor(e){this.wrong=e,this.fields=0,this.text=(t=new Uint8Array)=>{if(!(t instanceof Uint8Array))return e("a name that is no text");try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{return e("a name that is no UTF-8")}}}message(e,t){e instanceof Uint8Array||this.wrong("a message that is a number");let n={};for(let[i,r]of Object.entries(t))r!=="one"&&(n[i]=[]);for(let i=0;i<e.length;){++this.fields>wm&&this.wrong("too many fields");let r,o;[r,i]=this.varint(e,i),[o,i]=this.value(e,i,Number(r&7n)),this.keep(n,Number(r>>3n),o,t)}return n}keep(e,t,n,i){let r=i[t];if(r==="many")e[t].push(n);else if(r==="one")e[t]!==void 0&&this.wrong(`the field ${t} twice`),e[t]=n;else if(r==="numbers"&&n instanceof Uint8Array)for(let o=0,a;o<n.length;)[a,o]=this.varint(n,o),e[t].push(a);else r==="numbers"&&e[t].push(n)}value(e,t,n){if(n===0)return this.varint(e,t);let i={1:8,5:4}[n];return n===2&&([i,t]=this.varint(e,t),i=Number(i)),(i===void 0||t+i>e.length)&&this.wrong("a field that is cut short"),[e.subarray(t,t+i),t+i]}varint(e,t){let n=0n;for(let i=0n;i<70n&&!(t>=e.length);i+=7n){let r=e[t++];if(n|=BigInt(r&127)<<i,r<128)return[BigInt.asUintN(64,n),t]}return this.wrong("a number that is cut short")}};var Ft=1,Mm=2,Am=3,Em=6,Nl=2**24,Ll=2**16,Dl=2**24;function Ol(s,{columns:e,outputs:t,output:n,precision:i},r){let o=Il(s,r);Tm(o,e,t,n,r);let a=o.nodes.some(({operator:l})=>/^(De)?[qQ]uantizeLinear$/.test(l));return a!==(i==="int8")&&w("DECODER_PRECISION",r,`arithmetic that is not ${i}`),Cm(o,r),new Lo(o,e,t,a,r).decoder()}function Tm({inputs:s,outputs:e},t,n,i,r){let o=(a,l,c)=>a.length===1&&a[0].name===l&&a[0].type===Ft&&a[0].dims.length===2&&a[0].dims[0]===null&&a[0].dims[1]===c;o(s,"queries",t)||w("DECODER_INPUT",r,`not one input queries [N, ${t}]`),o(e,i,n)||w("DECODER_OUTPUT",r,`not one output ${i} [N, ${n}]`)}var Rm=new Set(`Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp
Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN LayerNormalization LeakyRelu Less
LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice
Softplus Softsign Split Sqrt Sub Sum Tanh ThresholdedRelu Where Xor`.split(/\s+/));function Cm({nodes:s,constants:e},t){let n=s.find(({operator:r})=>!Rm.has(r));n&&w("DECODER_OPERATOR",t,`the operator ${n.operator}`);let i=new Set(["queries",...e.keys()]);for(let r of s)(r.inputs.some(o=>o&&!i.has(o))||r.outputs.some(o=>i.has(o)))&&w("DECODER_GRAPH",t,"nodes out of order, or a value made twice"),r.outputs.forEach(o=>i.add(o))}var Lo=class{constructor({nodes:e,constants:t},n,i,r,o){Object.assign(this,{constants:t,columns:n,outputs:i,int8:r,where:o,width:n,at:0,value:"queries"});let a=({operator:u,inputs:f})=>u==="DequantizeLinear"&&t.has(f[0]);this.dequantizers=new Map(e.filter(a).map(u=>[u.outputs[0],u])),this.chain=e.filter(u=>!a(u)),this.values=this.work=0;let c=[...t.values(),...[...this.dequantizers.values()].map(({inputs:u})=>t.get(u[0]))].reduce((u,{dims:f})=>u+f.reduce((d,p)=>d*p,1),0);c>Nl&&w("DECODER_COST",o,`${c} values of constants; at most ${Nl}`),this.readers=new Map;for(let u of e.flatMap(f=>f.inputs))this.readers.set(u,(this.readers.get(u)??0)+1)}outside(e){throw new ee(`${this.where}: this viewer runs decoders of the profile (spec, 6.4) alone: ${e} [DECODER_PROFILE]`)}get operator(){return this.chain[this.at]?.operator}next(e){let t=this.chain[this.at];return(t?.operator!==e||t.inputs[0]!==this.value||t.outputs.length!==1)&&this.outside(`${t?.operator??"nothing"} where ${e} must be`),(this.readers.get(this.value)!==1||Object.keys(t.attributes).length)&&this.outside(`${e} with attributes, or a value that is read twice`),this.at+=1,this.value=t.outputs[0],t.inputs.slice(1)}spend(e,t=1){this.values+=e,this.work+=t*e,(this.values>Ll||this.work>Dl)&&w("DECODER_COST",this.where,`a query takes ${this.values} values and ${this.work} multiply-adds, or more; at most ${Ll} and ${Dl}`)}constant(e,t,n){let i=this.constants.get(e);return(!i?.values||i.type!==t||i.dims.join()!==n.join())&&this.outside(`${e??"nothing"} is not of type ${t} and shape [${n}]`),i.values}take(e,...t){let n=this.next(e);return e==="MatMul"?this.spend(this.outputs,this.width):this.spend(this.width),n.length!==t.length&&this.outside(`${e} of ${n.length+1} operands`),t.map(([i,r],o)=>this.constant(n[o],i,r))}decoder(){let e=[Ft,[]],t=[Ft,[this.columns]],[[n],[i]]=this.take("Clip",e,e),r=this.int8?this.take("Mul",t)[0]:null,o=this.int8?this.take("Add",t)[0]:null,a=this.layers(),[[l],[c]]=this.take("Clip",e,e);this.take("Exp");let[[u]]=this.take("Sub",e);(l!==0||u!==1)&&this.outside(`Clip from ${l}, Sub of ${u}`);let[f]=this.operator==="MatMul"?this.take("MatMul",[Ft,[this.width,this.outputs]]):this.take("Mul",e);(this.operator||this.dequantizers.size)&&this.outside("nodes behind the last one"),f.length===1&&this.width!==this.outputs&&w("DECODER_LOAD",this.where,`${this.width} values for ${this.outputs} outputs`);let d=f.length===1?{unit:f[0],matrix:null}:{unit:1,matrix:f};return{low:n,high:i,gain:r,offset:o,layers:a,top:c,...d,int8:this.int8,columns:this.columns,outputs:this.outputs}}layers(){let e=[];for(;;){let t=this.int8?this.quantized():null;if(e.push(this.gemm(t)),this.operator==="Clip")return e;this.int8||this.take("Relu")}}quantized(){let e=[[Ft,[]],[Mm,[]]],[[t],[n]]=this.take("QuantizeLinear",...e),[[i],[r]]=this.take("DequantizeLinear",...e);return(n||r||t!==i)&&this.outside("two scales, or a zero point"),t}gemm(e){let t=this.next("Gemm");t.length!==2&&this.outside(`Gemm of ${t.length+1} operands`);let n=d=>this.constants.get(d)?.dims.at(-1)??0,i=this.width;if(!this.int8){let d=n(t[0]);return this.spend(d,i),this.width=d,{weight:this.fitting(t[0],Ft,i,d),bias:this.constant(t[1],Ft,[d]),rows:i,columns:d}}let[r,o]=this.dequantized(t[0],1),[a,l]=this.dequantized(t[1],0),c=n(r);this.spend(c,i);let u=this.constant(o,Ft,[c]);return this.constant(l,Ft,[c]).some((d,p)=>d!==Math.fround(e*u[p]))&&this.outside("a bias with a scale of its own"),this.width=c,{weight:this.fitting(r,Am,i,c),bias:this.constant(a,Em,[c]),rows:i,columns:c,step:e,scales:u}}fitting(e,t,n,i){let r=this.constants.get(e)?.dims??[];return r.length===2&&r[0]!==n&&w("DECODER_LOAD",this.where,`weights for ${r[0]} values, of which there are ${n}`),this.constant(e,t,[n,i])}dequantized(e,t){let n=this.dequantizers.get(e);return this.dequantizers.delete(e),(n?.attributes.axis!==t||n.inputs.length!==2||this.readers.get(e)!==1)&&this.outside(`${e} is no DequantizeLinear of constants along axis ${t}`),n.inputs}};async function Ul(s,{elementSize:e,distance:t,size:n},i){let r=await Im(s,n,i),o=Math.floor(n/e),a=new Uint8Array(n);for(let l=0;l<e;l++){let c=l*o;for(let u=0;u<o;u++)a[u*e+l]=r[c+u]}if(a.set(r.subarray(o*e),o*e),t){let l={1:Uint8Array,2:Uint16Array,4:Uint32Array}[e],c=new l(a.buffer,0,o);for(let u=t;u<o;u++)c[u]+=c[u-t]}return a}async function Im(s,e,t){let n=new Uint8Array(e),i=0;try{let r=new Blob([s]).stream().pipeThrough(new DecompressionStream("deflate")).getReader();for(;;){let{done:o,value:a}=await r.read();if(o)break;if(i+a.length>e)throw r.cancel().catch(()=>{}),new RangeError(`more than ${e} bytes`);n.set(a,i),i+=a.length}}catch(r){w("DEFLATE_STREAM",t,`no whole zlib stream of ${e} bytes (${r.message})`)}return i!==e&&w("DEFLATE_STREAM",t,`inflates to ${i} bytes, expected ${e}`),n}var Fl={$schema:"https://json-schema.org/draft/2020-12/schema",title:"RNA 1.1 manifest.json",type:"object",if:{required:["parts"]},then:{$ref:"#/$defs/Manifest"},else:{$ref:"#/$defs/ShortManifest"},$defs:{Agreement:{additionalProperties:!1,description:"Largest difference between the exported decoder and the trained model.",properties:{maxAbsolute:{minimum:0,type:"number"},maxRelative:{minimum:0,type:"number"}},required:["maxAbsolute","maxRelative"],title:"Agreement",type:"object"},Bounds:{additionalProperties:!1,description:"The box the triplane spans; readers round its numbers to float32.",properties:{min:{description:"Smallest x, y, z.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"},max:{description:"Largest x, y, z; each greater than that of min.",maxItems:3,minItems:3,prefixItems:[{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"},{maximum:1e18,minimum:-1e18,type:"number"}],type:"array"}},required:["min","max"],title:"Bounds",type:"object"},Cone:{additionalProperties:!1,description:"Directions near an axis.",properties:{axis:{description:"Its middle, a unit vector.",maxItems:3,minItems:3,prefixItems:[{type:"number"},{type:"number"},{type:"number"}],type:"array"},halfAngle:{description:"From the axis to its edge, radians.",maximum:3.141592653589793,minimum:0,type:"number"}},required:["axis","halfAngle"],title:"Cone",type:"object"},Cost:{additionalProperties:!1,description:"Cost of a query.",properties:{multiplyAdds:{description:"Multiply-adds of the decoder per query.",maximum:9007199254740991,minimum:0,type:"integer"},nsPerQuery:{description:"Nanoseconds per query, everything included.",minimum:0,type:"number"},threads:{description:"Threads used in the measurement.",maximum:9007199254740991,minimum:1,type:"integer"},machine:{description:"What it was measured on.",type:"string"}},required:["multiplyAdds","nsPerQuery","threads","machine"],title:"Cost",type:"object"},Domain:{additionalProperties:!1,description:"Trained directions, object space.",properties:{wo:{description:"View directions, from the surface to the eye.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]},wi:{description:"Light directions, from the surface to the light.",oneOf:[{enum:["sphere","hemisphere"],type:"string"},{items:{$ref:"#/$defs/Cone"},maxItems:16,minItems:1,type:"array"}]}},required:["wo","wi"],title:"Domain",type:"object"},EntryRecord:{additionalProperties:!1,description:"Size and hash of one entry.",properties:{size:{description:"Bytes.",maximum:9007199254740991,minimum:0,type:"integer"},sha256:{description:"SHA-256, lower-case hex.",not:{pattern:`
`},pattern:"^[0-9a-f]{64}$",type:"string"}},required:["size","sha256"],title:"EntryRecord",type:"object"},FlipAtHeight:{additionalProperties:!1,description:"Error of an asset that is seen small.",properties:{height:{description:"Height of the validation images, pixels.",maximum:9007199254740991,minimum:1,type:"integer"},flip:{description:"Mean FLIP at that height.",minimum:0,type:"number"}},required:["height","flip"],title:"FlipAtHeight",type:"object"},JsonValue:{},Manifest:{additionalProperties:!1,description:"manifest.json. `write_package` computes `entries` and the versions; leave them out.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},parts:{description:"What the asset is made of.",items:{$ref:"#/$defs/Part"},maxItems:16,minItems:1,type:"array"},tiers:{items:{$ref:"#/$defs/Tier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","parts","tiers"],title:"Manifest",type:"object"},NormalMapRecord:{additionalProperties:!1,description:"Triangles with relief, and the map of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the map.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"}},required:["triangles","texture"],title:"NormalMapRecord",type:"object"},Part:{additionalProperties:!1,description:"One geometry with planes and decoders of its own.",properties:{name:{description:"Unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},transmittance:{default:[],description:"Holes and thin glass of a surface.",items:{$ref:"#/$defs/TransmittanceRecord"},maxItems:64,minItems:1,type:"array"},normalMaps:{default:[],description:"Relief of a surface.",items:{$ref:"#/$defs/NormalMapRecord"},maxItems:64,minItems:1,type:"array"}},required:["name","kind","bounds","geometry"],title:"Part",type:"object"},Provenance:{additionalProperties:!1,description:"Origin of the asset.",properties:{source:{description:"The original model: name, author, address.",type:"string"},tool:{description:"What made the training data, with its version.",type:"string"},capture:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Capture settings.",type:"object"},training:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Training settings.",type:"object"}},required:["source","tool"],title:"Provenance",type:"object"},ShortManifest:{additionalProperties:!1,description:"manifest.json of one part that has nothing new since 1.0.",properties:{format:{const:"rna",type:"string"},version:{description:"Version of the format it follows.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},minReaderVersion:{description:"Oldest reader that can.",not:{pattern:`
`},pattern:"^[1-9][0-9]{0,3}\\.(0|[1-9][0-9]{0,3})$",type:"string"},generator:{description:"What wrote the package, with its version.",type:"string"},name:{description:"The asset's name, for a person.",minLength:1,type:"string"},domain:{$ref:"#/$defs/Domain"},units:{$ref:"#/$defs/Units"},entries:{additionalProperties:{$ref:"#/$defs/EntryRecord"},description:"Every entry of the archive except manifest.json.",propertyNames:{maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$"},type:"object"},provenance:{$ref:"#/$defs/Provenance"},license:{description:"SPDX expression, or the terms.",minLength:1,type:"string"},extensionsUsed:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensionsRequired:{default:[],items:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},type:"array"},extensions:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Data of extensions, by name; each in extensionsUsed.",propertyNames:{maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$"},type:"object"},extras:{additionalProperties:{$ref:"#/$defs/JsonValue"},default:{},description:"Anything; readers ignore it.",type:"object"},kind:{description:"What the geometry is: a mesh, or curves.",enum:["surface","fiber"],type:"string"},bounds:{$ref:"#/$defs/Bounds"},geometry:{description:"Entry with the mesh or the curves.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},tiers:{items:{$ref:"#/$defs/ShortTier"},maxItems:16,minItems:1,type:"array"}},required:["format","version","minReaderVersion","units","entries","generator","name","domain","provenance","license","kind","bounds","geometry","tiers"],title:"ShortManifest",type:"object"},ShortTier:{additionalProperties:!1,description:"A tier of one part, planes and decoder in it.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision","name"],title:"ShortTier",type:"object"},Tier:{additionalProperties:!1,description:"One choice of speed and accuracy: planes and decoders of every part.",properties:{name:{description:"What hosts call the tier; unique in the package.",maxLength:64,not:{pattern:`
`},pattern:"^[A-Za-z0-9][A-Za-z0-9._-]*$",type:"string"},parts:{description:"One for each part, in their order.",items:{$ref:"#/$defs/TierPart"},maxItems:16,minItems:1,type:"array"},validation:{anyOf:[{$ref:"#/$defs/Validation"},{type:"null"}],default:null},cost:{anyOf:[{$ref:"#/$defs/Cost"},{type:"null"}],default:null}},required:["name","parts"],title:"Tier",type:"object"},TierEmission:{additionalProperties:!1,description:"Emission of a part: a separate decoder on features of the same planes.",properties:{decoder:{description:"Entry with the ONNX decoder of emission.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},decoderPrecision:{description:"Arithmetic of the decoder.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null}},required:["decoder","inputs","decoderPrecision"],title:"TierEmission",type:"object"},TierPart:{additionalProperties:!1,description:"Planes and decoders of one part: of transport, and optionally of emission.",properties:{planes:{description:"Entry with the triplane.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},decoder:{description:"Entry with the ONNX decoder.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},inputs:{description:"Input blocks, in the order of the columns of `queries`.",items:{enum:["features","position","normal","tangent","h","wo","wi","half_vector","highlight","learned_normal","fiber_angles","fiber_lobes"],type:"string"},minItems:1,type:"array",uniqueItems:!0},resolution:{description:"R, texels along a plane's side.",maximum:4096,minimum:1,type:"integer"},channels:{description:"C, features a texel.",maximum:64,minimum:1,type:"integer"},planePrecision:{description:"dtype of the planes.",enum:["int8","float16","float32"],type:"string"},decoderPrecision:{description:"Arithmetic of the decoder; int8 means quantised by QDQ nodes.",enum:["float32","int8"],type:"string"},agreement:{anyOf:[{$ref:"#/$defs/Agreement"},{type:"null"}],default:null},emission:{$ref:"#/$defs/TierEmission",default:null}},required:["planes","decoder","inputs","resolution","channels","planePrecision","decoderPrecision"],title:"TierPart",type:"object"},TransmittanceRecord:{additionalProperties:!1,description:"Triangles that let light through, and how much of it.",properties:{triangles:{description:"The first, and how many.",maxItems:2,minItems:2,prefixItems:[{maximum:9007199254740991,minimum:0,type:"integer"},{maximum:9007199254740991,minimum:1,type:"integer"}],type:"array"},texture:{description:"Entry with the texture.",maxLength:200,not:{pattern:`
`},pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",type:"string"},cutoff:{default:null,description:"A hole where the texture is greater than this, else none.",exclusiveMaximum:1,exclusiveMinimum:0,type:"number"},ior:{default:null,description:"Relative indices of refraction, from the front and the back.",maxItems:2,minItems:2,prefixItems:[{maximum:100,minimum:.01,type:"number"},{maximum:100,minimum:.01,type:"number"}],type:"array"}},required:["triangles","texture"],title:"TransmittanceRecord",type:"object"},Units:{additionalProperties:!1,description:"Units of the package.",properties:{length:{const:"metre",type:"string"}},required:["length"],title:"Units",type:"object"},Validation:{additionalProperties:!1,description:"Error against reference images the training never saw.",properties:{psnr:{description:"Peak signal-to-noise ratio, dB.",type:"number"},flip:{description:"Mean FLIP.",minimum:0,type:"number"},relativeMse:{description:"Mean relative squared error.",minimum:0,type:"number"},images:{description:"Number of images compared.",maximum:9007199254740991,minimum:1,type:"integer"},definition:{description:"What exactly was compared, for a person.",type:"string"},flipAtHeight:{default:[],description:"`flip` of the images reduced to other heights, which the bounds fill; from the largest.",items:{$ref:"#/$defs/FlipAtHeight"},type:"array"}},required:["psnr","flip","relativeMse","images","definition"],title:"Validation",type:"object"}}};var Do={object:s=>s!==null&&typeof s=="object"&&!Array.isArray(s),array:Array.isArray,string:s=>typeof s=="string",number:s=>typeof s=="number",integer:s=>Number.isSafeInteger(s),boolean:s=>typeof s=="boolean",null:s=>s===null};function ei(s,e,t=""){new Uo(s).check(s,e,t)}var Uo=class{constructor(e){this.root=e}fits(e,t){try{return this.check(e,t,""),!0}catch{return!1}}check(e,t,n){e.$ref&&this.check(this.root.$defs[e.$ref.split("/").pop()],t,n),e.if&&this.check(this.fits(e.if,t)?e.then:e.else,t,n);let i=r=>w("FIELD_VALUE",n,`found ${Oo(t)}, expected ${r}`);e.type&&!Do[e.type](t)&&i(e.type),"const"in e&&t!==e.const&&i(Oo(e.const)),e.enum&&!e.enum.includes(t)&&(e.enum.includes("features")&&w("INPUT_UNKNOWN",n,`no block ${Oo(t)}`),i(e.enum.join(", ")));for(let r of[e.anyOf,e.oneOf])r&&!r.some(o=>this.fits(o,t))&&this.check(r.find(o=>Do[o.type]?.(t))??r[0],t,n);e.not&&this.fits(e.not,t)&&i("another value"),typeof t=="number"&&this.checkNumber(e,t,i),typeof t=="string"&&this.checkString(e,t,i),Array.isArray(t)?this.checkArray(e,t,n,i):Do.object(t)&&this.checkObject(e,t,n)}checkNumber(e,t,n){t<e.minimum&&n(`at least ${e.minimum}`),t>e.maximum&&n(`at most ${e.maximum}`),t<=e.exclusiveMinimum&&n(`more than ${e.exclusiveMinimum}`),t>=e.exclusiveMaximum&&n(`less than ${e.exclusiveMaximum}`)}checkString(e,t,n){t.length<e.minLength&&n(`${e.minLength} characters or more`),t.length>e.maxLength&&n(`at most ${e.maxLength} characters`),e.pattern&&!new RegExp(e.pattern,"u").test(t)&&n(e.pattern)}checkArray(e,t,n,i){t.length<e.minItems&&i(`${e.minItems} items or more`),t.length>e.maxItems&&i(`at most ${e.maxItems} items`),t.forEach((r,o)=>{let a=e.prefixItems?.[o]??e.items;a&&this.check(a,r,`${n}/${o}`)}),e.uniqueItems&&new Set(t).size!==t.length&&w("INPUT_UNKNOWN",n,"a name twice")}checkObject(e,t,n){let i=Object.keys(t),r=e.properties??{};for(let o of i)e.additionalProperties===!1&&!Object.hasOwn(r,o)&&w("FIELD_UNKNOWN",`${n}/${o}`,"no such member"),e.propertyNames&&this.check({type:"string",...e.propertyNames},o,`${n}/${o}`);for(let o of e.required??[])Object.hasOwn(t,o)||w("FIELD_MISSING",`${n}/${o}`,"missing");for(let o of i){let a=Object.hasOwn(r,o)?r[o]:e.additionalProperties;a&&this.check(a,t[o],`${n}/${o}`)}}};function Oo(s){let e=JSON.stringify(s);return e.length>60?`${e.slice(0,57)}...`:e}var Fo={type:"string",pattern:"^[A-Za-z0-9_-][A-Za-z0-9._-]*(/[A-Za-z0-9_-][A-Za-z0-9._-]*)*$",maxLength:200},Ci=(s,e=Number.MAX_SAFE_INTEGER)=>({type:"integer",minimum:s,maximum:e}),Bo={type:"number",minimum:0,maximum:1},yn=s=>({type:"object",properties:s,required:Object.keys(s),additionalProperties:!1}),zl=2**32-2,Nm=2**20,Lm=64,kl={RNA_deflate:yn({entries:{type:"object",propertyNames:Fo,additionalProperties:yn({elementSize:{enum:[1,2,4]},distance:Ci(0),size:Ci(0,zl),sha256:{type:"string",pattern:"^[0-9a-f]{64}$"}})}}),RNA_poster:yn({image:Fo,width:Ci(1),height:Ci(1)}),RNA_standin:yn({parts:{type:"array",minItems:1,maxItems:16,items:yn({baseColor:{type:"array",items:Bo,minItems:3,maxItems:3},roughness:Bo,metallic:Bo})}}),RNA_proxy:yn({parts:{type:"array",minItems:1,maxItems:16,items:{anyOf:[{type:"null"},{type:"array",minItems:1,maxItems:8,items:yn({geometry:Fo,height:Ci(1)})}]}}})},$r=Object.keys(kl);function Gl(s){let e=s.extensions??{};for(let t of $r){let n=`/extensions/${t}`;if(!Object.hasOwn(e,t)){s.extensionsUsed?.includes(t)&&w("FIELD_MISSING",n,"its data is missing");continue}ei(kl[t],e[t],n),Dm[t](e[t],s,n)}}function zo(s,e,t){Object.hasOwn(s.entries,e)||w("REFERENCE_MISSING",t,`no entry ${e}`)}function Bl(s,e,t){s.length!==e.parts.length&&w("PARTS_DIFFER",t,`found ${s.length} parts, expected ${e.parts.length}`)}var Dm={RNA_deflate({entries:s},e,t){e.extensionsRequired?.includes("RNA_deflate")||w("EXTENSION_UNDECLARED",t,"RNA_deflate is not in extensionsRequired");let n=Object.values(s).reduce((i,{size:r})=>i+r,0);n>zl&&w("FIELD_VALUE",t,`${n} decoded bytes`);for(let[i,{size:r}]of Object.entries(s)){zo(e,i,t);let o=Nm+Lm*e.entries[i].size;r>o&&w("DEFLATE_SIZE",`${t}/entries/${i}/size`,`${r} decoded bytes; at most ${o}`)}},RNA_poster({image:s},e,t){zo(e,s,t)},RNA_standin({parts:s},e,t){Bl(s,e,t)},RNA_proxy({parts:s},e,t){Bl(s,e,t),s.some(n=>n)||w("FIELD_VALUE",t,"a proxy of no part"),s.forEach((n,i)=>{let{transmittance:r,normalMaps:o}=e.parts[i];n&&(r||o)&&w("FIELD_VALUE",t,"a proxy of a part with textures"),(n??[]).forEach(({geometry:a,height:l},c)=>{zo(e,a,t),c&&l>=n[c-1].height&&w("FIELD_VALUE",t,"heights must descend")})})}};var Hl=[1,1],Om=/^[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})$/;function Vl(s){let e=Yn(s,"manifest.json","MANIFEST_NOT_JSON");Um(e),ei(Fm(Fl,e),e);let t=Bm(e);zm(t),km(t),Gm(t);let n=Xl(Wl(t.minReaderVersion),Hl)<0;e.parts&&n&&w("VERSION_TOO_OLD","/minReaderVersion","1.0, with `parts`"),Hm(t),Gl(t),Vm(t),Wm(t),qm(t);let i=(t.extensionsUsed??[]).filter(r=>!$r.includes(r));return{...t,old:n,warnings:i.map(r=>`unknown extension ${r}`)}}var Wl=s=>s.split(".").map(Number),Xl=(s,e)=>s[0]-e[0]||s[1]-e[1];function Um(s){"format"in s||w("FIELD_MISSING","/format","missing"),s.format!=="rna"&&w("FORMAT_UNKNOWN","/format","this is no RNA package");let e=s.minReaderVersion;typeof e=="string"&&Om.test(e)&&!e.endsWith(`
`)&&Xl(Wl(e),Hl)>0&&w("VERSION_TOO_NEW","/minReaderVersion",`the package needs a reader of version ${e}`);let t=Array.isArray(s.parts)?s.parts:[s];for(let n of t)n?.kind!==void 0&&!["surface","fiber"].includes(n.kind)&&w("KIND_UNSUPPORTED","/kind",`found ${JSON.stringify(n.kind)}, expected surface or fiber`);for(let n of Array.isArray(s.extensionsRequired)?s.extensionsRequired:[])typeof n=="string"&&!$r.includes(n)&&w("EXTENSION_REQUIRED","/extensionsRequired",`this viewer does not know ${n}`)}function Fm(s,e){let t="parts"in e?"Manifest":"ShortManifest";return{...s.$defs[t],$defs:s.$defs}}function Bm(s){if(s.parts)return s;let{kind:e,bounds:t,geometry:n,...i}=s,r=s.tiers.map(({name:o,validation:a,cost:l,...c})=>({name:o,validation:a,cost:l,parts:[c]}));return{...i,parts:[{name:"asset",kind:e,bounds:t,geometry:n}],tiers:r}}function zm(s){s.parts.forEach(({bounds:{min:e,max:t}},n)=>{e.forEach((i,r)=>{Math.fround(t[r])-Math.fround(i)>=1e-18||w("BOUNDS_EMPTY",`/parts/${n}/bounds`,`no extent along axis ${r}`)})});for(let e of["wo","wi"]){let t=s.domain[e];for(let{axis:n}of Array.isArray(t)?t:[])Math.abs(Math.hypot(...n)-1)>.001&&w("FIELD_VALUE",`/domain/${e}`,"an axis is no unit vector")}}function km(s){for(let[e,t]of[["tiers","TIER_DUPLICATE"],["parts","PART_DUPLICATE"]]){let n=s[e].map(({name:i})=>i);new Set(n).size!==n.length&&w(t,`/${e}`,"a name is there twice")}s.tiers.forEach(({validation:e},t)=>{(e?.flipAtHeight??[]).forEach(({height:n},i,r)=>{i&&n>=r[i-1].height&&w("FIELD_VALUE",`/tiers/${t}/validation/flipAtHeight/${i}`,"heights must descend")})})}function Gm(s){s.tiers.forEach((e,t)=>{e.parts.length!==s.parts.length&&w("PARTS_DIFFER",`/tiers/${t}/parts`,`found ${e.parts.length}, expected ${s.parts.length}`),e.parts.forEach((n,i)=>{!n.emission!=!s.tiers[0].parts[i].emission&&w("PARTS_DIFFER",`/tiers/${t}/parts/${i}`,"emission in some tiers alone")})})}function Hm(s){let e=s.extensionsUsed??[];for(let t of[...Object.keys(s.extensions??{}),...s.extensionsRequired??[]])e.includes(t)||w("EXTENSION_UNDECLARED","/extensionsUsed",`${t} is not there`)}function Vm(s){s.tiers.forEach((e,t)=>e.parts.forEach((n,i)=>{let{kind:r}=s.parts[i],o=(a,l)=>{for(let c of a)l(vn(c))||w("INPUT_KIND",`/tiers/${t}/parts/${i}/inputs`,`${c} is not for this part`)};o(n.inputs,({kinds:a})=>a.includes(r)),o(n.emission?.inputs??[],({kinds:a,light:l})=>a.includes(r)&&!l)}))}function Wm(s){s.parts.forEach((e,t)=>{for(let[n,i]of[["transmittance","TRANSMITTANCE_RANGE"],["normalMaps","NORMAL_MAP_RANGE"]]){let r=`/parts/${t}/${n}`;e[n]&&e.kind!=="surface"&&w("FIELD_VALUE",r,`of a ${e.kind}`);let o=0;(e[n]??[]).forEach(({triangles:[a,l]},c)=>{a<o&&w(i,`${r}/${c}`,"ranges must ascend and not overlap"),o=a+l})}})}function*Xm(s){for(let[e,t]of s.parts.entries()){yield[`/parts/${e}/geometry`,t.geometry];for(let n of["transmittance","normalMaps"])for(let[i,r]of(t[n]??[]).entries())yield[`/parts/${e}/${n}/${i}`,r.texture]}for(let[e,t]of s.tiers.entries())for(let[n,i]of t.parts.entries()){let r=`/tiers/${e}/parts/${n}`;yield[`${r}/planes`,i.planes],yield[`${r}/decoder`,i.decoder],i.emission&&(yield[`${r}/emission/decoder`,i.emission.decoder])}}function qm(s){let e=new Set;for(let[n,i]of Xm(s))Object.hasOwn(s.entries,i)||w("REFERENCE_MISSING",n,`no entry ${i}`),e.add(i);let t=(s.extensionsUsed??[]).map(n=>`extensions/${n}/`);for(let n of Object.keys(s.entries))!e.has(n)&&!t.some(i=>n.startsWith(i))&&w("ENTRY_UNREFERENCED","/entries",`nothing refers to ${n}`)}function ql(s,e){for(let t of e.keys())t!=="manifest.json"&&!Object.hasOwn(s.entries,t)&&w("ENTRY_UNDECLARED","/entries",`the archive holds ${t}`);for(let[t,{size:n}]of Object.entries(s.entries)){let i=e.get(t);(!i||t==="manifest.json")&&w("ENTRY_MISSING","/entries",`the archive lacks ${t}`),i.size!==n&&w("ENTRY_SIZE",`/entries/${t}`,`found ${i.size}, expected ${n}`)}}var rn={type:"string"},$l={type:"array",items:{type:"number"}},bt=s=>({type:"integer",minimum:s,maximum:2**32-1}),sn=s=>({type:"array",minItems:1,maxItems:1,items:s}),St=(s,e={})=>({type:"object",properties:{...s,...e},required:Object.keys(s),additionalProperties:!1}),Yl={type:"array",minItems:3,maxItems:3,items:{type:"number"}},Zl={const:"KHR_mesh_quantization"};function Kl(s){let e=s?[5122,5123,5125,5126]:[5125,5126],t=St({bufferView:bt(0),componentType:{enum:e},count:bt(1),type:{enum:["SCALAR","VEC2","VEC3"]}},{byteOffset:bt(0),normalized:s?{type:"boolean"}:{const:!1},min:$l,max:$l,name:rn}),n=St({buffer:{const:0},byteLength:bt(1)},{byteOffset:bt(0),target:{enum:[34962,34963]},name:rn,...s&&{byteStride:{enum:[4,8]}}}),i=St({POSITION:bt(0),NORMAL:bt(0)},{TEXCOORD_0:bt(0)}),r=St({attributes:i,indices:bt(0)},{mode:{const:4}});return St({asset:St({version:{const:"2.0"}},{generator:rn,copyright:rn}),scenes:sn(St({nodes:sn({const:0})},{name:rn})),nodes:sn(St({mesh:{const:0},...s&&{translation:Yl,scale:Yl}},{name:rn})),meshes:sn(St({primitives:sn(r)},{name:rn})),buffers:sn(St({byteLength:bt(1)},{name:rn})),accessors:{type:"array",minItems:3,maxItems:4,items:t},bufferViews:{type:"array",minItems:1,maxItems:4,items:n},...s&&{extensionsUsed:sn(Zl),extensionsRequired:sn(Zl)}},{scene:{const:0},extras:{}})}var $m=Kl(!1),Ym=Kl(!0);function Jl(s,e){let t="extensionsUsed"in s||"extensionsRequired"in s;try{ei(t?Ym:$m,s)}catch(n){w("GEOMETRY_PROFILE",e,`${n.where}: not as meshes of packages are`)}return t&&Zm(s.nodes[0],e),Km(s,t,e),t}function Zm({scale:[s,e,t]},n){s>0&&s===e&&s===t||w("GEOMETRY_PROFILE",n,`the scale ${[s,e,t]}`)}function Km(s,e,t){let{attributes:n,indices:i}=s.meshes[0].primitives[0],r=e?{POSITION:[["VEC3"],[[5123,!1,8]]],NORMAL:[["VEC3"],[[5122,!0,8]]],TEXCOORD_0:[["VEC2"],[[5126,!1,void 0],[5123,!0,4]]],indices:[["SCALAR"],[[5123,!1,void 0],[5125,!1,void 0]]]}:{POSITION:[["VEC3"],[[5126,!1]]],NORMAL:[["VEC3"],[[5126,!1]]],TEXCOORD_0:[["VEC2"],[[5126,!1]]],indices:[["SCALAR"],[[5125,!1]]]};for(let[a,l]of[...Object.entries(n),["indices",i]]){let c=s.accessors[l],u=c&&s.bufferViews[c.bufferView];if(!u)continue;let[f,d]=r[a];f.includes(c.type)&&d.some(([_,v,S])=>c.componentType===_&&(c.normalized??!1)===v&&u.byteStride===S)||w("GEOMETRY_PROFILE",t,`the accessor of ${a}`)}s.accessors[i]?.componentType===5123&&s.accessors[n.POSITION]?.count>=65535&&w("GEOMETRY_PROFILE",t,"indices of 16 bits for too many vertices")}var Jm={5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},jm={SCALAR:1,VEC2:2,VEC3:3};function jl(s,e,t){let{json:n,bin:i}=Qm(s,e),r=Jl(n,e);r&&t&&w("VERSION_TOO_OLD",e,"a quantised mesh in a package for readers of 1.0");let o=n.buffers[0].byteLength;(o>i.length||i.length-o>3)&&w("GEOMETRY_RANGE",e,`a buffer of ${o} bytes in a chunk of ${i.length}`);let a=n.meshes[0].primitives[0],l=f=>eg(n,i.subarray(0,o),f,e),c={positions:l(a.attributes.POSITION),normals:l(a.attributes.NORMAL),uvs:"TEXCOORD_0"in a.attributes?l(a.attributes.TEXCOORD_0):null,indices:l(a.indices)};tg(c,e),ng(n.accessors[a.attributes.POSITION],c.positions,r,e);let u=r?ig(c,n.nodes[0]):c;return u.indices=Uint32Array.from(c.indices),rg(u,e),u}function Qm(s,e){let t="GEOMETRY_CONTAINER",n=new DataView(s.buffer,s.byteOffset,s.length);(s.length<20||n.getUint32(0,!0)!==1179937895||n.getUint32(4,!0)!==2)&&w(t,e,"no binary glTF 2.0"),n.getUint32(8,!0)!==s.length&&w(t,e,"the length in the header is not that of the entry");let i=[];for(let r=12;r<s.length;){r+8>s.length&&w(t,e,"a chunk is cut short");let o=n.getUint32(r,!0),a=n.getUint32(r+4,!0);(o%4||r+8+o>s.length)&&w(t,e,`a chunk of ${o} bytes`),i.push([a,s.subarray(r+8,r+8+o)]),r+=8+o}return i.map(([r])=>r).join()!==[1313821514,5130562].join()&&w(t,e,"not the chunks JSON and BIN"),i[0][1].length>65536&&w(t,e,"JSON of more than 64 KiB"),{json:Yn(i[0][1],e,t),bin:i[1][1]}}function eg(s,e,t,n){let i=s.accessors[t];i||w("GEOMETRY_RANGE",n,`no accessor ${t}`);let r=s.bufferViews[i.bufferView];r||w("GEOMETRY_RANGE",n,`no buffer view ${i.bufferView}`);let o=Jm[i.componentType],a=jm[i.type],l=o.BYTES_PER_ELEMENT*a,c=r.byteStride??l,u=(r.byteOffset??0)+(i.byteOffset??0),f=(i.byteOffset??0)+c*(i.count-1)+l;(f>r.byteLength||(r.byteOffset??0)+r.byteLength>e.length)&&w("GEOMETRY_RANGE",n,`accessor ${t} reaches past its bytes`),u%4&&w("GEOMETRY_PROFILE",n,`accessor ${t} is not aligned`);let d=c===l?Zn(o,e,u,a*i.count):new o(a*i.count);if(c!==l){let p=Zn(o,e,u,Math.floor(f-(i.byteOffset??0))/o.BYTES_PER_ELEMENT),_=c/o.BYTES_PER_ELEMENT;for(let v=0;v<i.count;v++)for(let S=0;S<a;S++)d[a*v+S]=p[_*v+S]}return Object.assign(d,{items:a})}function tg({positions:s,normals:e,uvs:t,indices:n},i){let r=s.length/3;(e.length!==s.length||t&&t.length!==2*r||!r)&&w("GEOMETRY_ARRAY",i,"attributes of different counts"),(n.length%3||!n.length)&&w("GEOMETRY_ARRAY",i,"part of a triangle")}function ng(s,e,t,n){["min","max"].every(r=>{if(s[r]?.length!==3)return!1;for(let o=0;o<3;o++){let a=e[o];for(let c=o;c<e.length;c+=3)(r==="min"?e[c]<a:e[c]>a)&&(a=e[c]);if((t?s[r][o]:Math.fround(s[r][o]))!==a&&Number.isFinite(a))return!1}return!0})||w("GEOMETRY_BOUNDS",n,"min and max of POSITION are not those of its values")}function ig({positions:s,normals:e,uvs:t},{translation:n,scale:i}){return{positions:Float32Array.from(s,(r,o)=>n[o%3]+i[0]*r),normals:Float32Array.from(e,r=>Math.max(r/32767,-1)),uvs:t&&(t instanceof Uint16Array?Float32Array.from(t,r=>r/65535):t)}}function rg({positions:s,normals:e,uvs:t,indices:n},i){for(let o of[s,e,t??[]])for(let a=0;a<o.length;a++)Number.isFinite(o[a])||w("GEOMETRY_NOT_FINITE",i,"an attribute is not finite");let r=s.length/3;for(let o=0;o<n.length;o++)n[o]>=r&&w("GEOMETRY_INDEX",i,`vertex ${n[o]} of ${r}`);for(let o=0;o<e.length;o+=3){let a=Math.hypot(e[o],e[o+1],e[o+2]);Math.abs(a-1)>.001&&w("GEOMETRY_NORMAL",i,`a normal of length ${a}`)}}var sg={float16:"F16",float32:"F32",int8:"I8"},ko=1e18;function Ql(s,{planePrecision:e,resolution:t,channels:n},i){let r=Kn(s,i,"PLANES_HEADER"),{tensors:o}=r,a=e==="int8",l=a?{scales:["F32",[3,n]],planes:["I8",[3,t,t,n]]}:{planes:[sg[e],[3,t,t,n]]},c=Object.keys(l),u=Object.keys(o);jn(r.metadata)||w("PLANES_TENSOR",i,"__metadata__ is no object"),(u.length!==c.length||c.some(_=>!u.includes(_)))&&w("PLANES_TENSOR",i,`found ${u.join(", ")||"no tensors"}, expected ${c.join(", ")}`);for(let _ of c)Jn(o[_])||w("PLANES_HEADER",i,`${_} is no tensor`);for(let _ of c){let[v,S]=l[_],M=o[_];M.dtype!==v&&w("PLANES_DTYPE",i,`${_}: found ${M.dtype}, expected ${v}`),M.shape.join()!==S.join()&&w("PLANES_SHAPE",i,`${_}: found [${M.shape}], expected [${S}]`)}let f=Qn(s,r,c,i,"PLANES_HEADER");r.data%64&&w("PLANES_ALIGNMENT",i,"data does not start at a multiple of 64");let d=f.at(-1),p=a?f[0]:null;return og(e,d,p,i),{values:d,scales:p,resolution:t,channels:n,precision:e}}function og(s,e,t,n){let i=()=>w("PLANES_NOT_FINITE",n,`NaN, or a value beyond ${ko}`);if(s==="int8")t.some(r=>!(Math.abs(r)*128<=ko))&&i();else if(s==="float16")for(let r=0;r<e.length;r++)(e[r]&31744)===31744&&i();else for(let r=0;r<e.length;r++)Math.abs(e[r])<=ko||i()}var ag=8192;function ec(s,e,t,n,i){let r=Kn(s,n,i),o=r.tensors[e];jn(r.metadata)||w(i,n,"__metadata__ is no object"),(Object.keys(r.tensors).join()!==e||!Jn(o))&&w(i,n,`not one tensor ${e}`);let[a,l,c]=o.shape,u=o.shape.length===3&&[a,l].every(d=>d>=1&&d<=ag);(o.dtype!=="U8"||!u||!t.includes(c))&&w(i,n,`found ${o.dtype} [${o.shape}], expected U8 [H, W, ${t.join(" or ")}]`),r.data%64&&w(i,n,"data does not start at a multiple of 64");let[f]=Qn(s,r,[e],n,i);return{values:f,height:a,width:l,channels:c}}function tc(s,e,t){let n="TRANSMITTANCE_TEXTURE",i=ec(s,"transmittance",[1,3],t,n);return e.cutoff!==void 0&&i.channels!==1&&w(n,t,"a cutoff of a coloured texture"),i}function nc(s,e){return ec(s,"normals",[2],e,"NORMAL_MAP_TEXTURE")}function Go({triangles:[s,e]},t,n,i,r){s+e>n.indices.length/3&&w(`${r}_RANGE`,i,`triangles ${s} to ${s+e} of ${n.indices.length/3}`),(r==="NORMAL_MAP"||t.width*t.height>1)&&!n.uvs&&w(`${r}_UV`,i,"the mesh has no texture coordinates")}var lg=65536,ti=class s{static async open(e){let t=new s;return t.source=e,t.directory=await wl(e),t.cache=new Map,t.manifest=Vl(await t._stored($n)),ql(t.manifest,t.directory),t}get poster(){return this.manifest.extensions?.RNA_poster}tier(e){let t=e?this.manifest.tiers.find(n=>n.name===e):this.manifest.tiers[0];if(!t){let n=this.manifest.tiers.map(i=>i.name).join(", ");w("TIER_UNKNOWN",this.source.name,`no tier ${e}; there are ${n}`)}return t}bytesOf(e){return this._ranges(this._entriesOf(this.tier(e))).reduce((t,[n,i])=>t+i-n,0)}async load(e){let t=this.tier(e),n=this._entriesOf(t);await this._fetch(n);let i=new Map;for(let o of n)i.set(o,await this._data(o));let r=this.manifest.parts.map((o,a)=>this._part(o,t.parts[a],a,i));return{name:t.name,tier:t,parts:r}}async posterImage(){return this.poster?(await this._fetch([this.poster.image]),new Blob([await this._data(this.poster.image)],{type:"image/png"})):null}forget(){this.cache.clear()}_part(e,t,n,i){let{kind:r,bounds:o,geometry:a}=e,l=this.manifest.old,c=`/parts/${n}`,u=i.get(a),f={name:e.name,kind:r,bounds:cg(o),inputs:t.inputs};return r==="surface"?f.mesh=jl(u,a,l):f.curves=Rl(u,a,l),f.transmittance=(e.transmittance??[]).map(d=>{let p=tc(i.get(d.texture),d,d.texture);return Go(d,p,f.mesh,c,"TRANSMITTANCE"),{...d,texture:p}}),f.normalMaps=(e.normalMaps??[]).map(d=>{let p=nc(i.get(d.texture),d.texture);return Go(d,p,f.mesh,c,"NORMAL_MAP"),{...d,texture:p}}),f.planes=Ql(i.get(t.planes),t,t.planes),f.transport=ic(i,t,t,"transport",6),f.emission=t.emission?{inputs:t.emission.inputs,...ic(i,t,t.emission,"emission",3)}:null,f}_entriesOf(e){let t=[];for(let n of this.manifest.parts){t.push(n.geometry);for(let i of[...n.transmittance??[],...n.normalMaps??[]])t.push(i.texture)}for(let n of e.parts)t.push(n.planes,n.decoder),n.emission&&t.push(n.emission.decoder);return[...new Set(t)]}_ranges(e){let t=e.map(i=>this.directory.get(i)).sort((i,r)=>i.header-r.header),n=[];for(let{header:i,end:r}of t){let o=n.at(-1);o&&i-o[1]<=lg?o[1]=r:n.push([i,r])}return n}async _fetch(e){let t=e.filter(n=>!this.cache.has(n));this.source.expected=this.source.ranged?this.source.fetched+this._ranges(t).reduce((n,[i,r])=>n+r-i,0):this.source.size;for(let[n,i]of this._ranges(t)){let r=await this.source.read(n,i);for(let o of t){let a=this.directory.get(o);a.header>=n&&a.end<=i&&this.cache.set(o,r.subarray(a.header-n,a.end-n))}}}async _stored(e){let t=this.directory.get(e),n=this.cache.get(e)??await this.source.read(t.header,t.end);return bl(t,n)}async _data(e){let t=await this._stored(e);await rc(t,this.manifest.entries[e].sha256,e);let n=this.manifest.extensions?.RNA_deflate?.entries[e];if(!n)return t;let i=await Ul(t,n,e);return await rc(i,n.sha256,e),i}};function ic(s,e,t,n,i){let o={columns:t.inputs.reduce((a,l)=>a+qr(l,e.channels),0),outputs:i,output:n,precision:t.decoderPrecision};return Ol(s.get(t.decoder),o,t.decoder)}function cg({min:s,max:e}){return{min:s.map(Math.fround),max:e.map(Math.fround)}}async function rc(s,e,t){if(!globalThis.crypto?.subtle)return;[...new Uint8Array(await crypto.subtle.digest("SHA-256",s))].map(r=>r.toString(16).padStart(2,"0")).join("")!==e&&w("ENTRY_HASH",t,"the bytes do not have the declared SHA-256")}var Ii={};wa(Ii,{evaluate:()=>fg,mappedNormals:()=>pg,visibility:()=>dg});function Yr(s,e,t,n,i,r){let o=Math.ceil(i/256),a=new Float32Array(4*256*o);for(let l=0;l<i;l++)a.set(t.subarray(r*l+n,r*l+n+4),4*l);s.bindTexture(s.TEXTURE_2D,e.texture),s.texSubImage2D(s.TEXTURE_2D,0,0,0,256,o,s.RGBA,s.FLOAT,a)}function hg(s){let e=[4,8,12].map(n=>ug(s.subarray(n,n+3))),t=s.every(Number.isFinite)&&e.every(Boolean);e.forEach((n,i)=>s.set(t?n:[0,0,0],4+4*i)),t||s.set([0,0,0,0],0)}function ug(s){let e=Math.hypot(...s);return e>0&&Number.isFinite(e)?Array.from(s,t=>t/e):null}function sc(s,e){let t=Math.ceil(e/256);s.resize(256,t),s.span={rows:t,firstRow:0},s.frame={cameraAt:["3fv",[0,0,0]],height:["1i",t],firstRow:["1i",0],sampleNumber:["1ui",0]}}async function fg(s,e,t,n,i=!0){let r=t==="transport"?2:1,o=n.length/16,a=new Float32Array(3*r*o),l=s.bandPixels;for(let c=0;c<o;c+=l){let u=Math.min(l,o-c),{gl:f}=s;sc(s,u);let d=n.slice(16*c,16*(c+u));for(let p=0;p<u;p++)hg(d.subarray(16*p,16*p+16)),d[16*p+7]=d[16*p+3],d[16*p+3]=e+1,d[16*p+15]=1;if([0,4,8].forEach((p,_)=>Yr(f,s.rows.images[_],d,p,u,16)),Yr(f,s.lit.images[0],d,12,u,16),s._decode(t),await s.done(),!!i)for(let p=0;p<r;p++){let _=s.answers.read(p);for(let v=0;v<u;v++)a.set(_.subarray(4*v,4*v+3),3*(r*(c+v)+p))}}return a}function oc(s,e){let t=new Float32Array(16*e.length);e.forEach(({place:n,b1:i,b2:r,x:o,wi:a,part:l},c)=>{t.set([...o,l+1,0,0,0,i,0,0,0,n,1,1,1,r],16*c),e[c].own=a}),sc(s,e.length),[0,4,8,12].forEach((n,i)=>Yr(s.gl,s.rows.images[i],t,n,e.length,16))}async function dg(s,e){oc(s,e);let{gl:t}=s,n=s.answers.images[0],i=new Float32Array(4*e.length);return e.forEach((r,o)=>i.set(r.wi,4*o)),Yr(t,n,i,0,e.length,4),s._light({kind:"given",colour:[1,1,1]},n),ac(s.lit.read(1),e.length)}async function pg(s,e){oc(s,e);let[,t,n,i]=s.rows.images;return s._pass("normals",s.answers,{...s.asset,rows1:t,rows2:n,rows3:i},s.geometry),ac(s.answers.read(0),e.length)}function ac(s,e){return Float32Array.from({length:3*e},(t,n)=>s[4*Math.floor(n/3)+n%3])}var Li={};wa(Li,{evaluate:()=>_g,mappedNormals:()=>xg,visibility:()=>vg});var mg=["maxStorageBufferBindingSize","maxBufferSize"];async function lc(){if(!navigator.gpu)throw new ee(isSecureContext?"this browser has no WebGPU":"WebGPU needs HTTPS, or a page from this machine");let s=await navigator.gpu.requestAdapter({powerPreference:"high-performance"});if(!s)throw new ee("WebGPU has no adapter here");let e=Object.fromEntries(mg.map(t=>[t,s.limits[t]]));return s.requestDevice({requiredLimits:e})}function Ae(s,e,t=GPUBufferUsage.STORAGE,n="a buffer"){let i=typeof e=="number"?e:e.byteLength,r=Math.max(16,Math.ceil(i/16)*16),o=s.limits.maxStorageBufferBindingSize;if(r>o)throw new ee(`${n} takes ${Vt(r)}; this GPU allows ${Vt(o)}`);let a=s.createBuffer({size:r,usage:t|GPUBufferUsage.COPY_DST|GPUBufferUsage.COPY_SRC,mappedAtCreation:typeof e!="number"});if(typeof e!="number"){let l=new Uint8Array(e.buffer,e.byteOffset,e.byteLength);new Uint8Array(a.getMappedRange()).set(l),a.unmap()}return a}async function Pi(s,e){let t=s.createShaderModule({code:e}),{messages:n}=await t.getCompilationInfo(),i=n.find(({type:r})=>r==="error");if(i)throw new Error(`a shader does not compile, line ${i.lineNum}: ${i.message}`);return t}function Ni(s,e,t,n){let i=n.map((r,o)=>({binding:o,resource:r instanceof GPUBuffer?{buffer:r}:r}));return s.createBindGroup({layout:e.getBindGroupLayout(t),entries:i})}function Mt(s,e,t,n){let i=Math.max(1,Math.ceil(n/64)),r=Math.min(i,32768);s.setPipeline(e),t.forEach((o,a)=>s.setBindGroup(a,o)),s.dispatchWorkgroups(r,Math.ceil(i/r))}async function ni(s,e,t){let n=s.createBuffer({size:Math.ceil(t/4)*4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST}),i=s.createCommandEncoder();i.copyBufferToBuffer(e,0,n,0,n.size),s.queue.submit([i.finish()]),await n.mapAsync(GPUMapMode.READ);let r=n.getMappedRange().slice(0);return n.destroy(),r}var gg={position:[0,0,0],corner:[0,0,0],stepX:[0,0,0],stepY:[0,0,0]};async function _g(s,e,t,n,i=!0){let r=s.parts[e][t],{device:o,queue:a,bandPixels:l}=s,c=t==="transport"?2:1,u=n.length/16,f=new Float32Array(3*c*u);for(let d=0;d<u;d+=l){let p=Math.min(l,u-d);if(o.queue.writeBuffer(a.rows,0,n,16*d,16*p),o.queue.writeBuffer(a.count,0,Uint32Array.of(p)),s._run(v=>r.run(v,a,p)),await s.done(),!i)continue;let _=new Float32Array(await ni(o,a.answers,16*c*p));for(let v=0;v<c*p;v++)f.set(_.subarray(4*v,4*v+3),3*(c*d+v))}return f}function cc(s,e){let t=new Float32Array(16*e.length),n=new Uint32Array(t.buffer);e.forEach(({place:i,b1:r,b2:o,x:a,wi:l,part:c},u)=>{t.set([...a,r],16*u),n[16*u+7]=c+1,n[16*u+11]=i,t.set([...l,o],16*u+12)}),s.resize(e.length,1),s.span={from:0,rows:1,pixels:e.length},s.device.queue.writeBuffer(s.band.rows,0,t),s._writeView(gg,0)}async function vg(s,e){cc(s,e),s._writeLight({kind:"given",colour:[1,1,1]},!0,!1),s._run(n=>Mt(n,s.kernels.light,s.groups.light,e.length));let t=new Float32Array(await ni(s.device,s.band.lit,32*e.length));return Float32Array.from({length:3*e.length},(n,i)=>t[8*Math.floor(i/3)+i%3])}async function xg(s,e){cc(s,e);let{device:t,view:n,geometry:[,i,r,o],band:a}=s,l=await s.pipelines.get(s.raySources.hit,"find_normals"),c=(d,p)=>t.createBindGroup({layout:l.getBindGroupLayout(d),entries:p.map(([_,v])=>({binding:_,resource:{buffer:v}}))}),u=[c(0,[[0,n],[2,i],[3,r],[4,o]]),c(1,[[0,a.rows]])];s._run(d=>Mt(d,l,u,e.length));let f=new Float32Array(await ni(s.device,s.band.rows,64*e.length));return Float32Array.from({length:3*e.length},(d,p)=>f[16*Math.floor(p/3)+4+p%3])}var Ho=s=>Uint8Array.from(atob(s),e=>e.charCodeAt(0));function Vo(s){let e=new Uint8Array(s.buffer,s.byteOffset,s.byteLength),t="";for(let n=0;n<e.length;n+=8192)t+=String.fromCharCode(...e.subarray(n,n+8192));return btoa(t)}var Zr=class{constructor(e){this.engine=e,this.answers=e.constructor.label==="WebGPU"?Li:Ii}async load(e,t){let n=await ti.open(new An(new Blob([Ho(e)]),"package"));this.shown=await n.load(t),this.arrays=Xr(this.shown.parts),await this.engine.setAsset(this.arrays,this.shown.parts),this.engine.resize(1,1)}async evaluate(e,t,n){let i=t==="transport"?13:10,r=new Float32Array(Ho(n).buffer),o=new Float32Array(16*r.length/i);for(let a=0;16*a<o.length;a++){let l=r.subarray(i*a,i*(a+1)),c=l.subarray(7,10);o.set([...l.subarray(0,3),l[6],...l.subarray(3,6),0,...c,0,...i===13?l.subarray(10):c],16*a)}return Vo(await this.answers.evaluate(this.engine,e,t,o))}async visibility(e){return Vo(await this.answers.visibility(this.engine,this._hits(e)))}async normals(e){return Vo(await this.answers.mappedNormals(this.engine,this._hits(e)))}_hits(e){let{buffer:t}=Ho(e),n=new Uint32Array(t),i=new Float32Array(t),r=[];for(let o=0;o<n.length;o+=8){let a=n[o+7],{first:l,fiber:c}=this.arrays.parts[a],u=i.subarray(o,o+7),f=this.arrays.where[l+n[o]];r.push(c?{place:f,part:a,b1:0,b2:0,x:u.slice(1,4),wi:u.slice(4,7)}:{place:f,part:a,b1:u[1],b2:u[2],x:[0,0,0],wi:u.slice(3,6)})}return r}};var yg=`#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;function hc(s){let e=s.getContext("webgl2",{alpha:!1,antialias:!1,preserveDrawingBuffer:!0});if(!e)throw new ee("this browser has no WebGL2");if(!e.getExtension("EXT_color_buffer_float"))throw new ee("this device's WebGL2 cannot draw into float textures");return e}var ii=class{constructor(e,t){this.gl=e,this.program=e.createProgram();for(let[n,i]of[[e.VERTEX_SHADER,yg],[e.FRAGMENT_SHADER,`#version 300 es
${t}`]]){let r=e.createShader(n);e.shaderSource(r,i),e.compileShader(r),e.attachShader(this.program,r),e.deleteShader(r)}e.linkProgram(this.program),this.places=new Map}check(){let{gl:e,program:t}=this;if(e.getProgramParameter(t,e.LINK_STATUS)||e.isContextLost())return;let n=e.getAttachedShaders(t).map(i=>e.getShaderInfoLog(i));throw new Error(`a shader does not compile: ${[e.getProgramInfoLog(t),...n].join(" ")}`)}_place(e){return this.places.has(e)||this.places.set(e,this.gl.getUniformLocation(this.program,e)),this.places.get(e)}set(e){for(let[t,[n,...i]]of Object.entries(e))this.gl[`uniform${n}`](this._place(t),...i)}textures(e){Object.entries(e).forEach(([t,n],i)=>{this.gl.activeTexture(this.gl.TEXTURE0+i),this.gl.bindTexture(n.target,n.texture),this.gl.uniform1i(this._place(t),i)})}delete(){this.gl.deleteProgram(this.program)}},wg=2048;function Bt(s,e,t,n=wg){let i={4:[[s.RGBA32F,s.RGBA,s.FLOAT],[s.RGBA32UI,s.RGBA_INTEGER,s.UNSIGNED_INT]],1:[null,[s.R8UI,s.RED_INTEGER,s.UNSIGNED_BYTE]]},[r,o,a]=i[t][e instanceof Float32Array?0:1],l=Math.max(1,Math.ceil(e.length/t)),c=Math.ceil(l/n);bg(s,c);let u=new e.constructor(n*c*t);return u.set(e),Di(s,n,c,r,o,a,u)}function bg(s,e){let t=s.getParameter(s.MAX_TEXTURE_SIZE);if(e>t)throw new ee(`the asset needs textures of side ${e}; this device has ${t}`)}function Di(s,e,t,n,i,r,o=null){let a=s.createTexture();return s.bindTexture(s.TEXTURE_2D,a),s.pixelStorei(s.UNPACK_ALIGNMENT,1),s.texImage2D(s.TEXTURE_2D,0,n,e,t,0,i,r,o),Wo(s,s.TEXTURE_2D),{target:s.TEXTURE_2D,texture:a,width:e,height:t}}function Wo(s,e){s.texParameteri(e,s.TEXTURE_MIN_FILTER,s.NEAREST),s.texParameteri(e,s.TEXTURE_MAG_FILTER,s.NEAREST),s.texParameteri(e,s.TEXTURE_WRAP_S,s.CLAMP_TO_EDGE),s.texParameteri(e,s.TEXTURE_WRAP_T,s.CLAMP_TO_EDGE)}var on=class{constructor(e,t,n,i){if(Object.assign(this,{gl:e,width:t,height:n}),this.images=Array.from({length:i},()=>Di(e,t,n,e.RGBA32F,e.RGBA,e.FLOAT)),this.frame=e.createFramebuffer(),e.bindFramebuffer(e.FRAMEBUFFER,this.frame),this.images.forEach(({texture:r},o)=>e.framebufferTexture2D(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0+o,e.TEXTURE_2D,r,0)),e.drawBuffers(this.images.map((r,o)=>e.COLOR_ATTACHMENT0+o)),e.checkFramebufferStatus(e.FRAMEBUFFER)!==e.FRAMEBUFFER_COMPLETE&&!e.isContextLost())throw new ee("this device cannot draw into float textures")}read(e){let{gl:t,width:n,height:i}=this,r=new Float32Array(4*n*i);return t.bindFramebuffer(t.FRAMEBUFFER,this.frame),t.readBuffer(t.COLOR_ATTACHMENT0+e),t.readPixels(0,0,n,i,t.RGBA,t.FLOAT,r),r}delete(){this.gl.deleteFramebuffer(this.frame);for(let{texture:e}of this.images)this.gl.deleteTexture(e)}};function Kr(s,e,t,{textures:n={},uniforms:i={},to:r}={}){let{width:o,height:a}=t??s.canvas;s.bindFramebuffer(s.FRAMEBUFFER,t?.frame??null),s.viewport(0,0,o,a),s.enable(s.SCISSOR_TEST),s.scissor(0,0,o,r??a),s.useProgram(e.program),e.set(i),e.textures(n),s.drawArrays(s.TRIANGLES,0,3)}async function uc(s){let e=s.fenceSync(s.SYNC_GPU_COMMANDS_COMPLETE,0);for(s.flush();;){if(s.isContextLost())return;let t=s.clientWaitSync(e,0,0);if(t===s.ALREADY_SIGNALED||t===s.CONDITION_SATISFIED)break;await new Promise(n=>setTimeout(n,1))}s.deleteSync(e)}var fc=`// Input blocks of a decoder (spec, 6.3), in the forms for float32.

uniform sampler2DArray planes;  // three planes of \`groups\` layers of four channels
uniform int resolution;
uniform int channels;
uniform vec4 scales[48];        // of int8: scale of each channel; else 1
uniform vec3 boundsMin;
uniform vec3 boundsMax;
uniform int blockCount;
uniform int blocks[BLOCKS];     // BLOCK_ of each, in the order of the columns

float columns[COLUMNS];

// Features are summed over the planes (spec, 5).
vec4 featuresOf(int group, vec3 p) {
  int groups = (channels + 3) / 4;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 3; k++) {
    vec2 at = clamp(vec2(p[k], p[(k + 1) % 3]) * float(resolution) - 0.5, 0.0, float(resolution - 1));
    ivec2 low = ivec2(floor(at)), high = min(low + 1, resolution - 1);
    vec2 f = at - floor(at);
    int layer = k * groups + group;
    vec4 lower = mix(texelFetch(planes, ivec3(low, layer), 0), texelFetch(planes, ivec3(high.x, low.y, layer), 0), f.x);
    vec4 upper = mix(texelFetch(planes, ivec3(low.x, high.y, layer), 0), texelFetch(planes, ivec3(high, layer), 0), f.x);
    sum += mix(lower, upper, f.y) * scales[layer];
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

void put(inout int at, float value) {
  columns[at++] = value;
}

void put3(inout int at, vec3 v) {
  put(at, v.x);
  put(at, v.y);
  put(at, v.z);
}

void putFeatures(inout int at, vec3 p) {
  for (int group = 0; 4 * group < channels; group++) {
    vec4 f = featuresOf(group, p);
    for (int c = 0; c < 4 && 4 * group + c < channels; c++) put(at, f[c]);
  }
}

void putFiber(inout int at, int block, vec3 t, float h, vec3 wo, vec3 wi) {
  vec3 o = cross(t, wo), i = cross(t, wi);
  float so = dot(t, wo), si = dot(t, wi), co = length(o), d = co * length(i), sum = so + si;
  float cosPhi = 1.0, sinPhi = 0.0;
  if (d >= 1e-6) {
    cosPhi = clamp(dot(o, i) / d, -1.0, 1.0);
    sinPhi = clamp(dot(t, cross(o, i)) / d, -1.0, 1.0);
  }
  if (block == BLOCK_FIBER_ANGLES) {
    put3(at, vec3(si, so, sum));
    put3(at, vec3(log2(sum * sum + 1e-3) / 6.0, cosPhi, sinPhi));
    return;
  }
  // Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi. As cosine and sine.
  float sinT = h * co / sqrt(1.55 * 1.55 - so * so);
  vec2 lobe = vec2(1.0 - 2.0 * h * h, 2.0 * h * sqrt(max(0.0, 1.0 - h * h)));
  vec2 turn = vec2(2.0 * sinT * sinT - 1.0, 2.0 * sinT * sqrt(max(0.0, 1.0 - sinT * sinT)));
  for (int p = 0; p < 3; p++) {
    put(at, cosPhi * lobe.x + sinPhi * lobe.y);
    lobe = vec2(lobe.x * turn.x - lobe.y * turn.y, lobe.x * turn.y + lobe.y * turn.x);
  }
}

// Fills \`columns\`. x: a position, axis: n or t; all directions unit.
void fillColumns(vec3 x, vec3 axis, float h, vec3 wo, vec3 wi) {
  vec3 p = clamp((x - boundsMin) / (boundsMax - boundsMin), 0.0, 1.0);
  int at = 0;
  for (int k = 0; k < blockCount; k++) {
    int block = blocks[k];
    if (block == BLOCK_FEATURES) putFeatures(at, p);
    else if (block == BLOCK_POSITION) put3(at, 2.0 * p - 1.0);
    else if (block == BLOCK_NORMAL || block == BLOCK_TANGENT) put3(at, axis);
    else if (block == BLOCK_H) put(at, h);
    else if (block == BLOCK_WO) put3(at, wo);
    else if (block == BLOCK_WI) put3(at, wi);
    else if (block == BLOCK_HALF_VECTOR) {
      vec3 m = halfway(wo, wi, axis);
      put3(at, vec3(dot(axis, m), gap(axis, m), dot(axis, wi)));
      put(at, dot(axis, wo));
      put(at, dot(wi, m));
    } else if (block == BLOCK_HIGHLIGHT) {
      vec3 c = cross(axis, halfway(wo, wi, axis));
      put(at, log2(dot(c, c) + 1e-8) / 12.0);
    } else if (block == BLOCK_LEARNED_NORMAL) {
      vec3 f = featuresOf(0, p).xyz * vec3(1.0, float(channels > 1), float(channels > 2));
      vec3 bent = axis + 0.1 * f;
      vec3 q = length(bent) < 1e-6 ? axis : unit(bent), m = halfway(wo, wi, q);
      put(at, dot(q, m));
      put(at, gap(q, m));
    } else putFiber(at, block, axis, h, wo, wi);
  }
}
`;var dc=`// Adds what one light brings, or what the asset emits, to the picture.
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
`;var pc=`// What the decoder of one part answers for the queries on it.
uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D lit0;
uniform int part;
uniform bool isFiber;
uniform bool hasLight;

layout(location = 0) out vec4 first;   // visible, or emitted
layout(location = 1) out vec4 second;  // shadowed

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 row0 = texelFetch(rows0, pixel, 0);
  vec4 light = texelFetch(lit0, pixel, 0);
  if (int(row0.w) != part + 1 || (hasLight && light.w != 1.0)) discard;
  vec4 row1 = texelFetch(rows1, pixel, 0);
  vec3 wo = texelFetch(rows2, pixel, 0).xyz, wi = hasLight ? light.xyz : wo;
  first = vec4(0.0, 0.0, 0.0, 1.0);
  second = vec4(0.0, 0.0, 0.0, 1.0);
  if (row1.xyz == vec3(0.0)) return;  // an argument was no direction (spec, 8.1)
  float h = isFiber ? clamp(row1.w, -1.0, 1.0) : 0.0;
  fillColumns(row0.xyz, row1.xyz, h, wo, wi);
  vec3 a, b;
  decode(COLUMNS, a, b);
  first.xyz = a;
  second.xyz = b;
}
`;var mc=`// The layers of a decoder (spec, 6.4). Values are in groups of four, weights in blocks of 4 x 4: four texels, one of
// outputs for each of four inputs.

uniform sampler2D weights;
uniform int layerCount;
uniform ivec4 layers[LAYERS];   // groups of inputs, groups of outputs, first texel of weights, of bias
uniform vec2 steps[LAYERS];     // of int8: scale of the inputs; first texel of the outputs' scales
uniform bool isInt8;
uniform int gainAt;             // of int8: first texel of gains, then of offsets
uniform vec3 limits;            // low and high of the first Clip, top of the second
uniform int matrixAt;           // first texel of the matrix, or -1
uniform float unitOf;
uniform int outputs;

vec4 values[GROUPS];
vec4 next[GROUPS];

vec4 weightAt(int k) {
  return texelFetch(weights, ivec2(k & 1023, k >> 10), 0);
}

void runLayer(int k) {
  ivec4 layer = layers[k];
  bool last = k == layerCount - 1;
  if (isInt8) {
    // Products and their sums are whole numbers below 2^24 as long as layers are narrower than 512.
    for (int i = 0; i < layer.x; i++) values[i] = clamp(roundEven(values[i] / steps[k].x), 0.0, 255.0);
  }
  for (int o = 0; o < layer.y; o++) {
    vec4 sum = isInt8 ? vec4(0.0) : weightAt(layer.w + o);
    int at = layer.z + 4 * layer.x * o;
    for (int i = 0; i < layer.x; i++, at += 4) {
      vec4 x = values[i];
      sum += weightAt(at) * x.x + weightAt(at + 1) * x.y + weightAt(at + 2) * x.z + weightAt(at + 3) * x.w;
    }
    if (isInt8) sum = (sum + weightAt(layer.w + o)) * weightAt(int(steps[k].y) + o) * steps[k].x;
    next[o] = last || isInt8 ? sum : max(sum, 0.0);
  }
  for (int o = 0; o < layer.y; o++) values[o] = next[o];
}

// Six numbers of \`columns\`, three and three.
void decode(int width, out vec3 first, out vec3 second) {
  int groups = layers[0].x;
  for (int i = 0; i < groups; i++) {
    vec4 value = vec4(0.0);
    for (int c = 0; c < 4; c++) if (4 * i + c < width) value[c] = columns[4 * i + c];
    value = clamp(value, limits.x, limits.y);
    values[i] = isInt8 ? value * weightAt(gainAt + i) + weightAt(gainAt + groups + i) : value;
  }
  for (int k = 0; k < layerCount; k++) runLayer(k);
  int last = layers[layerCount - 1].y;
  float result[8];
  for (int i = 0; i < 8; i++) result[i] = 0.0;
  for (int i = 0; i < last; i++) values[i] = exp(clamp(values[i], 0.0, limits.z)) - 1.0;
  if (matrixAt < 0) {
    for (int i = 0; i < outputs; i++) result[i] = values[i / 4][i % 4] * unitOf;
  } else {
    for (int i = 0; i < last; i++) {
      for (int c = 0; c < 4; c++) {
        vec4 low = weightAt(matrixAt + 2 * (4 * i + c)), high = weightAt(matrixAt + 2 * (4 * i + c) + 1);
        for (int o = 0; o < 4; o++) {
          result[o] += values[i][c] * low[o];
          result[4 + o] += values[i][c] * high[o];
        }
      }
    }
  }
  first = max(vec3(result[0], result[1], result[2]), 0.0);
  second = max(vec3(result[3], result[4], result[5]), 0.0);
}
`;var gc=`// A ray from the camera through each pixel, to the query of its first hit.
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
    bool fiber = (hit.number & SEGMENT) != 0u;
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
    float part = float(partOf(hit.number & ~SEGMENT) + 1);
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
`;var _c=`// Where a ray meets a triangle or a round segment (spec, 4.1 and 4.2).

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
    vec3 p = valuesAt(places, int(primitive[k])).xyz - origin;
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
  hit.number = primitive.w;
  hit.b1 = u1 / sum;
  hit.b2 = u2 / sum;
  return true;
}

struct Cone {
  vec3 a, b;
  float ra, rb;
};

Cone coneAt(int point) {
  vec4 a = valuesAt(places, point), b = valuesAt(places, point + 1);
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
    if ((neighbours & uint(1 + k)) == 0u) continue;
    Cone cone = coneAt(point + (k == 0 ? -1 : 1));
    if (distanceTo(cone, p) < -1e-4 * min(cone.ra, cone.rb)) return true;
  }
  return false;
}

bool meetsSegment(uvec4 primitive, vec3 origin, vec3 d, float far, inout Hit hit) {
  int point = int(primitive.x);
  float t;
  vec3 n;
  if (!entersCone(coneAt(point), origin, d, t, n)) return false;
  if (!(t >= 0.0 && t < far)) return false;
  if (insideNeighbour(point, primitive.y, origin + t * d)) return false;
  hit.t = t;
  hit.number = primitive.w;
  hit.n = n;
  return true;
}
`;var vc=`// For each query a direction of one light, what arrives from there, and how much of it the asset lets through.
#include random

uniform sampler2D rows0;
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
uniform sampler2D given;        // directions, of the conformance kit
uniform int lightKind;          // 0: sun; environment: 1 where it is bright, 3 about the point; 2: given directions
uniform vec3 lightDirection;    // of a sun
uniform vec3 lightColour;       // its irradiance, or a factor of the environment
uniform sampler2D environment;  // radiance, row 0 at +y; w: the row's distribution along it
uniform sampler2D marginal;     // distribution over rows; 1 / the sum of weights; the least weight
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

int searched(sampler2D table, int row, int count, float u, int channel) {
  int low = 0, high = count - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(table, ivec2(middle, row), 0)[channel] > u) high = middle;
    else low = middle + 1;
  }
  return low;
}

// A texel's weight among all: luminance times the sine of its row.
float texelWeight(vec3 rgb, int row, ivec2 size) {
  float least = texelFetch(marginal, ivec2(size.y + 1, 0), 0).x;
  return max(least, dot(rgb, vec3(0.2126, 0.7152, 0.0722))) * sin(PI * (float(row) + 0.5) / float(size.y));
}

// Radiance at a place in the image, bilinear, and the density there of brightDirection: the weights, bilinear.
vec3 skyAt(vec2 st, float sine, out float density) {
  ivec2 size = textureSize(environment, 0);
  vec2 at = st * vec2(size) - 0.5, low = floor(at), f = at - low;
  vec3 radiance = vec3(0.0);
  float weight = 0.0;
  for (int k = 0; k < 4; k++) {
    ivec2 offset = ivec2(k & 1, k >> 1);
    float share = (offset.x == 1 ? f.x : 1.0 - f.x) * (offset.y == 1 ? f.y : 1.0 - f.y);
    int column = (int(low.x) + offset.x + size.x) % size.x, row = clamp(int(low.y) + offset.y, 0, size.y - 1);
    vec3 rgb = texelFetch(environment, ivec2(column, row), 0).xyz;
    radiance += share * rgb;
    weight += share * texelWeight(rgb, row, size);
  }
  float overTotal = texelFetch(marginal, ivec2(size.y, 0), 0).x;
  density = weight * overTotal * float(size.x * size.y) / (2.0 * PI * PI * max(sine, 1e-6));
  return radiance;
}

// From the uniform distribution on [0, 1] to the tent about 0, on [-1, 1].
vec2 tent(vec2 u) {
  vec2 t = 2.0 * clamp(u, 0.0, 1.0) - 1.0;
  return sign(t) * (1.0 - sqrt(1.0 - abs(t)));
}

// A direction: a texel in proportion to its weight, then a place about its middle by a tent
// two texels wide. So the density is the weights' bilinear interpolation, and follows the radiance that is looked up.
vec3 brightDirection(vec2 u) {
  ivec2 size = textureSize(environment, 0);
  int row = searched(marginal, 0, size.y, u.y, 0);
  float before = row > 0 ? texelFetch(marginal, ivec2(row - 1, 0), 0).x : 0.0;
  float chance = texelFetch(marginal, ivec2(row, 0), 0).x - before;
  int column = searched(environment, row, size.x, u.x, 3);
  float left = column > 0 ? texelFetch(environment, ivec2(column - 1, row), 0).w : 0.0;
  float width = texelFetch(environment, ivec2(column, row), 0).w - left;
  vec2 within = (u - vec2(left, before)) / max(vec2(width, chance), 1e-12);
  vec2 place = (vec2(column, row) + 0.5 + tent(within)) / vec2(size);
  vec2 st = vec2(fract(place.x), 1.0 - abs(1.0 - abs(place.y)));  // back from beyond the poles
  float theta = PI * st.y, phi = 2.0 * PI * (st.x - 0.5), sine = sin(theta);
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
  if ((wordsAt(primitives, int(row2.w)).w & SEGMENT) != 0u) return Surroundings(vec3(0.0), vec3(0.0));
  vec3 n = row1.xyz, wo = row2.xyz;
  return Surroundings(dot(n, wo) < 0.0 ? -n : n, reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
vec3 sampleLight(ivec2 pixel, Surroundings at, out vec3 wi) {
  if (lightKind == 0 || lightKind == 2) {
    wi = lightKind == 0 ? lightDirection : texelFetch(given, pixel, 0).xyz;
    return lightColour;
  }
  vec2 u = random(ivec2(pixel.x, height - 1 - pixel.y - firstRow), DIRECTION);
  wi = lightKind == 1 ? brightDirection(u) : directionAbout(at, u);
  vec3 d = vec3(turn.x * wi.x - turn.y * wi.z, wi.y, turn.x * wi.z + turn.y * wi.x);
  float density;
  vec2 st = vec2(atan(d.x, -d.z) / (2.0 * PI) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / PI);
  vec3 radiance = skyAt(st, length(d.xz), density);
  return lightColour * radiance / (density + densityAbout(at, wi));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
  vec3 origin;
  uint strand;  // that is no obstacle
  vec3 weight;
  float coverage;
};

const uint NO_STRAND = 0xffffffffu;

Start startOf(vec4 row0, vec4 row1, vec4 row2, float b2, vec3 wi) {
  int place = int(row2.w);
  uvec4 primitive = wordsAt(primitives, place);
  if ((primitive.w & SEGMENT) != 0u) return Start(row0.xyz, primitive.z, vec3(1.0), 1.0);
  Hit hit = Hit(0.0, primitive.w, place, row1.w, b2, vec3(0.0));
  return Start(liftedOrigin(primitive, hit, wi), NO_STRAND, vec3(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
Start startOnGround(vec3 d, vec3 wi) {
  if (ground.y == 0.0 || d.y * (cameraAt.y - ground.x) >= 0.0) return Start(vec3(0.0), NO_STRAND, vec3(0.0), 0.0);
  vec3 x = cameraAt + d * ((ground.x - cameraAt.y) / d.y);
  float fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - ground.zw) / groundSize);
  return Start(x + vec3(0.0, epsilon, 0.0), NO_STRAND, fade * max(0.0, wi.y) * groundColour, fade);
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
`;var xc=`// The normals of hits whose place and barycentric coordinates are in the rows.
uniform sampler2D rows1;
uniform sampler2D rows2;
uniform sampler2D rows3;
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int place = int(texelFetch(rows2, pixel, 0).w);
  Hit hit = Hit(0.0, 0u, place, texelFetch(rows1, pixel, 0).w, texelFetch(rows3, pixel, 0).w, vec3(0.0));
  first = vec4(shadingNormal(wordsAt(primitives, place), hit), 1.0);
  second = vec4(0.0);
}
`;var yc=`// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and its own ray to the light (7.1).

struct Corners {
  vec3 p[3], n[3];
  vec2 uv[3];
};

Corners cornersOf(uvec4 primitive) {
  Corners corners;
  for (int k = 0; k < 3; k++) {
    vec4 place = valuesAt(places, int(primitive[k])), normal = valuesAt(normals, int(primitive[k]));
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

vec3 texelAt(uvec4 size, int offset, ivec2 place) {
  ivec2 wide = ivec2(size.xy);
  ivec2 at = place - wide * ivec2(floor(vec2(place) / vec2(wide)));
  int first = offset + (at.y * wide.x + at.x) * int(size.z);
  vec3 value = vec3(0.0);
  for (int c = 0; c < int(size.z); c++) value[c] = float(wordsAt(texels, first + c).x);
  return value;
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
vec3 lookUp(uvec4 size, int offset, vec2 uv) {
  vec2 place = uv * vec2(size.xy) - 0.5, low = floor(place), f = place - low;
  // Repeat before integers: coordinates may be large.
  low -= vec2(size.xy) * floor(low / vec2(size.xy));
  ivec2 at = ivec2(low);
  vec3 lower = mix(texelAt(size, offset, at), texelAt(size, offset, at + ivec2(1, 0)), f.x);
  vec3 upper = mix(texelAt(size, offset, at + ivec2(0, 1)), texelAt(size, offset, at + ivec2(1, 1)), f.x);
  return mix(lower, upper, f.y);
}

// The record of this kind that the triangle is in, or -1.
int recordOf(uint number, uint kind) {
  for (int k = 0; k < recordCount; k++) {
    uvec4 record = wordsAt(records, 3 * k);
    if (record.x == kind && number >= record.y && number < record.z) return k;
  }
  return -1;
}

float fresnel(float index, float c) {
  float g2 = index * index - 1.0 + c * c;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2), r = (g - c) / (g + c), s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
  return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

vec3 transmittance(uvec4 primitive, Hit hit, vec3 d) {
  int k = recordCount > 0 ? recordOf(primitive.w, 0u) : -1;
  if (k < 0) return vec3(0.0);
  uvec4 record = wordsAt(records, 3 * k), size = wordsAt(records, 3 * k + 1), indices = wordsAt(records, 3 * k + 2);
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  vec2 uv = b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
  vec3 tau = lookUp(size, int(record.w), uv) / 255.0;
  if (size.z == 1u) tau = tau.xxx;
  float cutoff = uintBitsToFloat(size.w), front = uintBitsToFloat(indices.x);
  if (cutoff > 0.0) tau = vec3(tau.x > cutoff ? 1.0 : 0.0);
  if (front > 0.0) {
    vec3 n = unit(mixed(corners.n, b)), ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
    float index = dot(d, ng) < 0.0 ? front : uintBitsToFloat(indices.y);
    tau *= 1.0 - fresnel(index, abs(dot(n, d)));
  }
  return tau;
}

// The normal with relief, 4.5.
vec3 mappedNormal(uint number, Corners corners, vec3 b, vec3 n) {
  int k = recordCount > 0 ? recordOf(number, 1u) : -1;
  if (k < 0) return n;
  vec3 e1 = corners.p[1] - corners.p[0], e2 = corners.p[2] - corners.p[0];
  vec2 a = corners.uv[1] - corners.uv[0], c = corners.uv[2] - corners.uv[0];
  float area = a.x * c.y - c.x * a.y;
  if (area == 0.0) return n;
  vec3 u = (c.y * e1 - a.y * e2) * sign(area), v = (a.x * e2 - c.x * e1) * sign(area);
  vec3 along = u - dot(u, n) * n;
  if (length(along) <= 1e-6 * length(u)) return n;
  vec3 t = unit(along), up = cross(n, t);
  if (dot(up, v) > 0.0) up = -up;
  vec2 uv = b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
  uvec4 record = wordsAt(records, 3 * k), size = wordsAt(records, 3 * k + 1);
  vec2 q = (lookUp(size, int(record.w), uv).xy - 127.0) / 127.0;
  vec3 m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
  return length(m) <= 1e-6 ? n : normalize(m);
}

vec3 shadingNormal(uvec4 primitive, Hit hit) {
  Corners corners = cornersOf(primitive);
  vec3 b = weightsOf(hit);
  return mappedNormal(primitive.w, corners, b, unit(mixed(corners.n, b)));
}

vec3 tangentOf(uvec4 primitive) {
  return unit(valuesAt(places, int(primitive.x) + 1).xyz - valuesAt(places, int(primitive.x)).xyz);
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
`;var wc=`// Numbers in [0, 1). Of a pixel's place and of the light: of each pixel a start of its own, and from there the additive
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
`;var Xo=`// The asset's geometry in textures: see geometry/scene_arrays.js.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;

uniform usampler2D nodes;       // two texels a node
uniform usampler2D primitives;  // one a primitive, in the order of the leaves
uniform sampler2D places;       // position, and u or the radius
uniform sampler2D normals;      // normal and v
uniform usampler2D records;     // three texels a record
uniform usampler2D texels;      // one byte of textures each
uniform int recordCount;
uniform int partCount;
uniform int partFirst[16];      // number of its first primitive
uniform bool partIsFiber[16];
uniform float epsilon;          // the spec's e, 7.1

const uint SEGMENT = 0x80000000u;

uvec4 wordsAt(usampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

vec4 valuesAt(sampler2D table, int k) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(k % width, k / width), 0);
}

int partOf(uint number) {
  // Parts stand in the order of their first primitives, but for meshes before strands.
  int found = 0, first = -1;
  for (int k = 0; k < partCount; k++) {
    if (int(number) >= partFirst[k] && partFirst[k] > first) {
      found = k;
      first = partFirst[k];
    }
  }
  return found;
}

struct Hit {
  float t;
  uint number;     // of the primitive, with SEGMENT; in \`place\` its place in the table
  int place;
  float b1, b2;    // barycentric coordinates
  vec3 n;          // of a segment, outward
};

vec3 unit(vec3 v) {
  vec3 size = abs(v);
  float largest = max(size.x, max(size.y, size.z));
  return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}
`;var bc=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.
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
`;var Sc=`// Rays against the hierarchy: the nearest hit, and how much light passes (spec, 7.1).

const int STACK = 48;
const float FAR = 1e30;

float entersBox(vec3 low, vec3 high, vec3 origin, vec3 inverse, float far) {
  vec3 a = (low - origin) * inverse, b = (high - origin) * inverse;
  vec3 near3 = min(a, b), far3 = max(a, b);
  float near = max(max(near3.x, near3.y), max(near3.z, 0.0));
  float last = min(min(far3.x, far3.y), min(far3.z, far)) * 1.0000004;
  return near <= last ? near : FAR;
}

// No axis is exactly parallel: 0 times infinity would be no number.
vec3 inverseOf(vec3 d) {
  vec3 tiny = vec3(1e-20);
  return 1.0 / mix(d, tiny, lessThan(abs(d), tiny));
}

float boxAt(int node, vec3 origin, vec3 inverse, float far) {
  uvec4 first = wordsAt(nodes, 2 * node);
  uvec2 second = wordsAt(nodes, 2 * node + 1).xy;
  vec4 a = uintBitsToFloat(first);
  vec2 b = uintBitsToFloat(second);
  return entersBox(a.xyz, vec3(a.w, b), origin, inverse, far);
}

// The nearest hit; t is FAR where there is none.
Hit nearest(vec3 origin, vec3 d) {
  Hit hit = Hit(FAR, 0u, 0, 0.0, 0.0, vec3(0.0));
  vec3 inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = 0;
  if (boxAt(0, origin, inverse, FAR) == FAR) return hit;
  for (;;) {
    uvec4 words = wordsAt(nodes, 2 * node + 1);
    if ((words.w >> 16) == 0xffffu) {
      for (int k = int(words.z); k < int(words.z + (words.w & 0xffffu)); k++) {
        uvec4 primitive = wordsAt(primitives, k);
        bool met = (primitive.w & SEGMENT) != 0u ? meetsSegment(primitive, origin, d, hit.t, hit)
                                                 : meetsTriangle(primitive, origin, shear, hit.t, hit);
        if (met) hit.place = k;
      }
    } else {
      int left = node + 1, right = node + int(words.z);
      float a = boxAt(left, origin, inverse, hit.t), b = boxAt(right, origin, inverse, hit.t);
      int nearer = a <= b ? left : right, farther = a <= b ? right : left;
      if (max(a, b) < FAR) stack[top++] = farther;
      if (min(a, b) < FAR) {
        node = nearer;
        continue;
      }
    }
    if (top == 0) return hit;
    node = stack[--top];
  }
}

// The light that passes from origin along d to infinity, strand \`own\` being no obstacle.
vec3 passes(vec3 origin, vec3 d, uint own) {
  vec3 light = vec3(1.0), inverse = inverseOf(d);
  Shear shear = shearOf(d);
  int stack[STACK];
  int top = 0, node = 0;
  if (boxAt(0, origin, inverse, FAR) == FAR) return light;
  for (;;) {
    uvec4 words = wordsAt(nodes, 2 * node + 1);
    if ((words.w >> 16) == 0xffffu) {
      for (int k = int(words.z); k < int(words.z + (words.w & 0xffffu)); k++) {
        uvec4 primitive = wordsAt(primitives, k);
        Hit hit;
        if ((primitive.w & SEGMENT) != 0u) {
          if (primitive.z != own && meetsSegment(primitive, origin, d, FAR, hit)) return vec3(0.0);
        } else if (meetsTriangle(primitive, origin, shear, FAR, hit)) {
          light *= transmittance(primitive, hit, d);
          if (light == vec3(0.0)) return light;
        }
      }
    } else {
      int left = node + 1, right = node + int(words.z);
      bool first = boxAt(left, origin, inverse, FAR) < FAR, second = boxAt(right, origin, inverse, FAR) < FAR;
      if (first && second) stack[top++] = right;
      if (first || second) {
        node = first ? left : right;
        continue;
      }
    }
    if (top == 0) return light;
    node = stack[--top];
  }
}
`;var qo=[Xo,_c,yc,Sc].join(`
`),Mc=s=>s.replace("#include random",wc),Jr={hit:qo+Mc(gc),light:qo+Mc(vc),normals:qo+xc,decode:[Xo,fc,mc,pc].join(`
`),clear:"precision highp float; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = b = vec4(0.0); }",combine:dc,show:bc};var At=s=>Math.ceil(s/4);function Ac(s,{values:e,scales:t,resolution:n,channels:i,precision:r}){let o=At(i),a=s.getParameter(s.MAX_TEXTURE_SIZE);if(n>a)throw new ee(`planes of ${n} texels a side; this device has ${a}`);let l=r==="float32",c=s.createTexture();s.bindTexture(s.TEXTURE_2D_ARRAY,c),s.pixelStorei(s.UNPACK_ALIGNMENT,1),s.texStorage3D(s.TEXTURE_2D_ARRAY,1,l?s.RGBA32F:s.RGBA16F,n,n,3*o),Wo(s,s.TEXTURE_2D_ARRAY);let u=r==="float16"?s.HALF_FLOAT:s.FLOAT,f=r==="float16"?Uint16Array:Float32Array,d=new f(4*n*n),p=n*n;for(let v=0;v<3*o;v++){let S=Math.floor(v/o),M=4*(v%o),A=Math.min(4,i-M);for(let P=0;P<p;P++){let L=(S*p+P)*i+M;for(let D=0;D<A;D++)d[4*P+D]=e[L+D]}s.texSubImage3D(s.TEXTURE_2D_ARRAY,0,0,0,v,n,n,1,s.RGBA,u,d)}let _=new Float32Array(192).fill(1);for(let v=0;t&&v<3;v++)for(let S=0;S<i;S++)_[4*(v*o+(S>>2))+(S&3)]=t[v*i+S];return{target:s.TEXTURE_2D_ARRAY,texture:c,factors:_}}function Ug(s){let e=[],t=[],n=[],i=0,r=d=>(e.push(d),i+=d.length/4,i-d.length/4),o=d=>Float32Array.from({length:4*At(d.length)},(p,_)=>d[_]??0),a=s.int8?r(o(s.gain)):0;s.int8&&r(o(s.offset));for(let{weight:d,bias:p,rows:_,columns:v,step:S,scales:M}of s.layers){let A=new Float32Array(16*At(_)*At(v));for(let D=0;D<_;D++)for(let Y=0;Y<v;Y++)A[4*((Y>>2)*4*At(_)+D)+(Y&3)]=d[D*v+Y];let P=r(A),L=r(o(p));t.push(At(_),At(v),P,L),n.push(S??0,s.int8?r(o(M)):0)}let l=s.matrix?r(Fg(s)):-1,c=new Float32Array(4*i),u=0;for(let d of e)c.set(d,u),u+=d.length;let f=Math.max(...s.layers.flatMap(({rows:d,columns:p})=>[At(d),At(p)]));return{values:c,layers:t,steps:n,gainAt:a,matrixAt:l,widest:f}}function Fg({matrix:s,outputs:e}){let t=s.length/e,n=new Float32Array(32*At(t));for(let i=0;i<t;i++)for(let r=0;r<e;r++)n[8*i+r]=s[i*e+r];return n}var Oi=class{constructor(e,t,n,i,r,o){let a=Ug(i);this.weights=Bt(e,a.values,4,1024),this.planes=o;let l={COLUMNS:i.columns,LAYERS:i.layers.length,GROUPS:a.widest,BLOCKS:Ut.length};Ut.forEach(({name:u},f)=>{l[`BLOCK_${u.toUpperCase()}`]=f});let c=Object.entries(l).map(([u,f])=>`#define ${u} ${f}
`).join("");this.program=new ii(e,c+Jr.decode),this.uniforms={part:["1i",t],isFiber:["1i",+(n.kind==="fiber")],hasLight:["1i",+(i.outputs===6)],resolution:["1i",n.planes.resolution],channels:["1i",n.planes.channels],scales:["4fv",o.factors],boundsMin:["3fv",n.bounds.min],boundsMax:["3fv",n.bounds.max],blockCount:["1i",r.length],blocks:["1iv",r.map(u=>Ut.indexOf(vn(u)))],layerCount:["1i",i.layers.length],layers:["4iv",a.layers],steps:["2fv",a.steps],isInt8:["1i",Number(i.int8)],gainAt:["1i",a.gainAt],limits:["3f",i.low,i.high,i.top],matrixAt:["1i",a.matrixAt],unitOf:["1f",i.unit],outputs:["1i",i.outputs]}}get textures(){return{planes:this.planes,weights:this.weights}}delete(e){this.program.delete(),e.deleteTexture(this.weights.texture)}};var Bg=1<<17,jr=class s{static label="WebGL2";static async open(e){let t=hc(e),n=new s;Object.assign(n,{gl:t,canvas:e,parts:[],target:null,lost:!1,bandPixels:Bg}),n.programs=Object.fromEntries(["hit","light","normals","clear","combine","show"].map(i=>[i,new ii(t,Jr[i])]));for(let i of Object.values(n.programs))i.check();return e.addEventListener("webglcontextlost",i=>{i.preventDefault(),n.lost=!0,n.onlost?.("the WebGL context was lost")}),n}setAsset(e,t){let{gl:n}=this;this._deleteAsset(),this.asset={nodes:Bt(n,e.nodes,4),primitives:Bt(n,e.primitives,4),places:Bt(n,e.places,4),normals:Bt(n,e.normals,4),records:Bt(n,e.records,4),texels:Bt(n,e.texels,1)},this.where=e.where,this.geometry={recordCount:["1i",e.recordCount],partCount:["1i",t.length],partFirst:["1iv",e.parts.map(({first:i})=>i)],epsilon:["1f",e.epsilon]},this.parts=t.map((i,r)=>{let o=Ac(n,i.planes),a=new Oi(n,r,i,i.transport,i.inputs,o),l=i.emission&&new Oi(n,r,i,i.emission,i.emission.inputs,o);return{planes:o,transport:a,emission:l}});for(let{transport:i,emission:r}of this.parts)i.program.check(),r?.program.check()}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment({values:e,marginal:t,width:n,height:i}){let{gl:r}=this;for(let o of[this.environment,this.marginal])o&&r.deleteTexture(o.texture);this.environment=Di(r,n,i,r.RGBA32F,r.RGBA,r.FLOAT,e),this.marginal=Di(r,t.length,1,r.R32F,r.RED,r.FLOAT,t)}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let{gl:n}=this,i=Math.max(1,Math.min(t,Math.floor(this.bandPixels/e)));this._deleteImages(),this.target={width:e,height:t},this.rows=new on(n,e,i,4),this.lit=new on(n,e,i,3),this.answers=new on(n,e,i,2),this.added=new on(n,e,i,1),this.sum=new on(n,e,t,1)}trace(e,t,n,i){let{height:r}=this.target;this.span={rows:i-n,firstRow:r-i};let{position:o,corner:a,stepX:l,stepY:c,jitter:u=1}=e;this.frame={cameraAt:["3fv",o],height:["1i",r],firstRow:["1i",this.span.firstRow],sampleNumber:["1ui",t]},this._pass("hit",this.rows,this.asset,{...this.geometry,...this.frame,jitter:["1f",u],corner:["3fv",a],stepX:["3fv",l],stepY:["3fv",c]})}light(e,{isFirst:t,countsCoverage:n}){this._light(e),this._decode("transport"),this._combine({isFirst:t,countsCoverage:n,isEmission:!1})}_light(e,t=null){let[n,i,r,o]=this.rows.images;this._pass("light",this.lit,{...this.asset,rows0:n,rows1:i,rows2:r,rows3:o,given:t??n,environment:this.environment??n,marginal:this.marginal??n},{...this.geometry,...this.frame,...kg(e)})}emission(){this._pass("clear",this.answers,{},{}),this._decode("emission"),this._combine({isFirst:!1,countsCoverage:!1,isEmission:!0})}_combine({isEmission:e,countsCoverage:t,isFirst:n}){let{gl:i}=this,{width:r}=this.target,{rows:o,firstRow:a}=this.span,[l,,,c]=this.rows.images,[u,f,d]=this.lit.images,[p,_]=this.answers.images,v=S=>["1i",Number(S)];this._pass("combine",this.added,{before:this.sum.images[0],rows0:l,rows3:c,lit0:u,lit1:f,lit2:d,first:p,second:_},{isEmission:v(e),countsCoverage:v(t),isFirst:v(n),firstRow:["1i",a]}),i.bindFramebuffer(i.READ_FRAMEBUFFER,this.added.frame),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,this.sum.frame),i.disable(i.SCISSOR_TEST),i.blitFramebuffer(0,0,r,o,0,a,r,a+o,i.COLOR_BUFFER_BIT,i.NEAREST)}_pass(e,t,n,i){Kr(this.gl,this.programs[e],t,{to:this.span.rows,textures:n,uniforms:i})}show({rounds:e,exposure:t,backdrop:n,filmic:i,spread:r}){let{width:o,height:a}=this.canvas;Kr(this.gl,this.programs.show,null,{textures:{picture:this.sum.images[0]},uniforms:{rounds:["1f",e],exposure:["1f",t],backdrop:["3fv",n],size:["2f",o,a],filmicView:["1f",Number(i)],spread:["1f",r]}})}done(){return uc(this.gl)}async picture(){let{width:e,height:t}=this.target,n=this.sum.read(0),i=new Float32Array(n.length);for(let r=0;r<t;r++)i.set(n.subarray(4*e*r,4*e*(r+1)),4*e*(t-1-r));return i}_decode(e){let[t,n,i]=this.rows.images,r=this.lit.images[0];for(let o of this.parts){let a=o[e];a&&Kr(this.gl,a.program,this.answers,{to:this.span.rows,textures:{...a.textures,rows0:t,rows1:n,rows2:i,lit0:r},uniforms:a.uniforms})}}_deleteAsset(){for(let{texture:e}of Object.values(this.asset??{}))this.gl.deleteTexture(e);for(let{planes:e,transport:t,emission:n}of this.parts)this.gl.deleteTexture(e.texture),t.delete(this.gl),n?.delete(this.gl);this.parts=[]}_deleteImages(){for(let e of[this.rows,this.lit,this.answers,this.added,this.sum])e?.delete();this.target=null}close(){this._deleteAsset(),this._deleteImages();for(let e of Object.values(this.programs))e.delete()}},zg={sun:0,environment:1,given:2,aroundPoint:3};function kg({kind:s,direction:e=[0,1,0],colour:t,angle:n=0,ground:i}){return{lightKind:["1i",zg[s]],lightDirection:["3fv",e],lightColour:["3fv",t],turn:["2f",Math.cos(n),Math.sin(n)],ground:["4f",i?.height??0,i?1:0,i?.x??0,i?.z??0],groundColour:["3fv",i?.colour??[0,0,0]],groundSize:["1f",i?.size??1]}}var Ui={note:"Generated by `python -m rna_gpu.records.write_records`; do not edit.",constants:{MAX_LAYERS:32,MAX_EXACT_INPUTS:512,UNIFORM_WEIGHTS:4096,RNA_NONE:4294967295,RNA_FLOAT32:0,RNA_FLOAT16:1,RNA_INT8:2,RNA_BLOCK_FEATURES:0,RNA_BLOCK_POSITION:1,RNA_BLOCK_NORMAL:2,RNA_BLOCK_TANGENT:3,RNA_BLOCK_H:4,RNA_BLOCK_WO:5,RNA_BLOCK_WI:6,RNA_BLOCK_HALF_VECTOR:7,RNA_BLOCK_HIGHLIGHT:8,RNA_BLOCK_LEARNED_NORMAL:9,RNA_BLOCK_FIBER_ANGLES:10,RNA_BLOCK_FIBER_LOBES:11,RNA_CHANNEL_GROUPS:16,NONE:4294967295,HAS_SKY:1,FOR_BETA:2,RAYS_MEET_LIGHTS:4,FOR_EMISSION:8,FOR_LIGHT:16,TRANSMITS:32},records:{RnaLayer:{words:8,members:{inputs:{at:0,type:"u32",count:1},outputs:{at:1,type:"u32",count:1},weights:{at:2,type:"u32",count:1},bias:{at:3,type:"u32",count:1},units:{at:4,type:"u32",count:1},relu:{at:5,type:"u32",count:1},int8_step:{at:6,type:"f32",count:1},reserved:{at:7,type:"u32",count:1}}},RnaPart:{words:484,members:{low:{at:0,type:"f32",count:3},resolution:{at:3,type:"u32",count:1},high:{at:4,type:"f32",count:3},channel_groups:{at:7,type:"u32",count:1},query_groups:{at:8,type:"u32",count:1},layer_count:{at:9,type:"u32",count:1},plane_precision:{at:10,type:"u32",count:1},gain:{at:11,type:"u32",count:1},query_low:{at:12,type:"f32",count:1},query_high:{at:13,type:"f32",count:1},top:{at:14,type:"f32",count:1},unit:{at:15,type:"f32",count:1},matrix:{at:16,record:"RnaLayer",count:1},scales:{at:24,type:"f32",count:192},layers:{at:216,record:"RnaLayer",count:32},slots:{at:472,type:"u32",count:12}}},Frame:{words:36,members:{camera:{at:0,type:"f32",count:3},width:{at:3,type:"u32",count:1},corner:{at:4,type:"f32",count:3},paths:{at:7,type:"u32",count:1},step_x:{at:8,type:"f32",count:3},sample:{at:11,type:"u32",count:1},step_y:{at:12,type:"f32",count:3},seed:{at:15,type:"u32",count:1},depth:{at:16,type:"u32",count:1},light:{at:17,type:"u32",count:1},part:{at:18,type:"u32",count:1},parts:{at:19,type:"u32",count:1},rays:{at:20,type:"u32",count:1},clamp:{at:21,type:"f32",count:1},light_count:{at:22,type:"u32",count:1},sums:{at:23,type:"u32",count:1},flags:{at:24,type:"u32",count:1},neural_part:{at:25,type:"u32",count:1},table_size:{at:26,type:"u32",count:1},things:{at:27,type:"u32",count:1},surfaces:{at:28,type:"u32",count:1},lights:{at:29,type:"u32",count:1},albedo:{at:30,type:"u32",count:1},domains:{at:31,type:"u32",count:1},textures:{at:32,type:"u32",count:1}}},Path:{words:24,members:{origin:{at:0,type:"f32",count:3},pixel:{at:3,type:"u32",count:1},direction:{at:4,type:"f32",count:3},pdf:{at:7,type:"f32",count:1},beta:{at:8,type:"f32",count:3},state:{at:11,type:"u32",count:1},normal:{at:12,type:"f32",count:3},t:{at:15,type:"f32",count:1},instance:{at:16,type:"u32",count:1},primitive:{at:17,type:"u32",count:1},own:{at:18,type:"u32",count:1},b1:{at:19,type:"f32",count:1},leaving:{at:20,type:"f32",count:3},b2:{at:23,type:"f32",count:1}}},Pending:{words:24,members:{x:{at:0,type:"f32",count:3},h:{at:3,type:"f32",count:1},axis:{at:4,type:"f32",count:3},part:{at:7,type:"u32",count:1},wo:{at:8,type:"f32",count:3},light:{at:11,type:"u32",count:1},wi:{at:12,type:"f32",count:3},strand:{at:15,type:"u32",count:1},weight:{at:16,type:"f32",count:3},seen:{at:19,type:"f32",count:1},visible:{at:20,type:"f32",count:3},reserved:{at:23,type:"u32",count:1}}}}};var Fi=Ui.constants;function Ec(s,e){let t=new Uint32Array(Ui.records[s].words);return Tc(t,new Float32Array(t.buffer),0,s,e),t}function Tc(s,e,t,n,i){for(let[r,o]of Object.entries(i)){let{at:a,type:l,record:c}=Ui.records[n].members[r],u=t+a,f=typeof o=="number"?[o]:o;c?[f].flat().forEach((d,p)=>Tc(s,e,u+p*Ui.records[c].words,c,d)):(l==="f32"?e:s).set(f,u)}}var{RNA_NONE:Nc,MAX_LAYERS:Rc,MAX_EXACT_INPUTS:Cc,RNA_CHANNEL_GROUPS:Ic}=Fi,Bi=s=>Math.ceil(s/4);function Lc(s,e,t){Hg(e);let{places:n,slots:i,queryGroups:r}=Vg(t,s.planes.channels),o=new $o,a=Nc;e.int8&&(a=o.add(Qr(e.gain,n,r)),o.add(Qr(e.offset,n,r)));let l=e.layers.map((p,_)=>{let v=+(!e.int8&&_+1<e.layers.length);return Pc(o,{...p,relu:v},_?null:n,_?0:r)}),c=null;if(e.matrix){let p=e.matrix.length/e.outputs,_=new Float32Array(e.outputs);c=Pc(o,{weight:e.matrix,bias:_,rows:p,columns:e.outputs,relu:0},null,0)}let u=[...l,...c?[c]:[]],f=Math.max(...u.flatMap(({inputs:p,outputs:_})=>[p,_])),d=Wg(s,e,{queryGroups:r,gain:a,slots:i,layers:l,matrix:c});return{weights:o.all(),record:d,groups:Math.max(4,2**Math.ceil(Math.log2(f)))}}function Hg({layers:s,int8:e}){if(s.length>Rc)throw new ee(`a decoder of ${s.length} layers; at most ${Rc}`);let t=e?Math.max(...s.map(({rows:n})=>n)):0;if(t>Cc)throw new ee(`an int8 layer of ${t} inputs; at most ${Cc}`)}function Vg(s,e){let t=[],n=Ut.map(()=>Nc),i=0;for(let r of s){let o=qr(r,e);n[Ut.indexOf(vn(r))]=i;for(let a=0;a<o;a++)t.push(4*i+a);i+=Bi(o)}return{places:t,slots:n,queryGroups:i}}var $o=class{constructor(){this.list=[],this.length=0}add(e){let t=this.length;return this.list.push(e),this.length+=e.length/4,t}all(){let e=new Float32Array(4*this.length),t=0;for(let n of this.list)e.set(n,t),t+=n.length;return e}};function Qr(s,e,t){let n=new Float32Array(4*t);return s.forEach((i,r)=>{n[e?e[r]:r]=i}),n}function Pc(s,{weight:e,bias:t,rows:n,columns:i,step:r=0,scales:o,relu:a},l,c){let u=c||Bi(n),f=Bi(i),d=new Float32Array(16*u*f);for(let S=0;S<n;S++){let M=l?l[S]:S,A=M>>2;for(let P=0;P<i;P++)d[16*((P>>2)*u+A)+4*(M&3)+(P&3)]=e[S*i+P]}let p=s.add(d),_=s.add(Qr(t,null,f)),v=o?s.add(Qr(Float32Array.from(o,S=>S*r),null,f)):0;return{inputs:u,outputs:f,weights:p,bias:_,units:v,relu:a,int8_step:r}}function Wg(s,e,{queryGroups:t,gain:n,slots:i,layers:r,matrix:o}){let{resolution:a,channels:l,precision:c,scales:u}=s.planes,{low:f,high:d,top:p,unit:_}=e,v=new Float32Array(12*Ic);for(let S=0;u&&S<3;S++)v.set(u.subarray(S*l,(S+1)*l),4*Ic*S);return Ec("RnaPart",{low:s.bounds.min,high:s.bounds.max,resolution:a,channel_groups:Bi(l),query_groups:t,layer_count:r.length,plane_precision:Fi[`RNA_${c.toUpperCase()}`],gain:n,query_low:f,query_high:d,top:p,unit:_,matrix:o??{},scales:v,layers:r,slots:i})}function Dc({values:s,resolution:e,channels:t},n){let i=e*e,r=s.subarray(n*i*t,(n+1)*i*t),o=4*Bi(t);if(o===t)return r;let a=new s.constructor(i*o);for(let l=0;l<i;l++)a.set(r.subarray(l*t,(l+1)*t),l*o);return a}var Oc={surface:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","surface_blocks.wgsl","decoder.wgsl","surface.wgsl"],fiber:["part_records.wgsl","part.wgsl","planes.wgsl","blocks.wgsl","fiber_blocks.wgsl","decoder.wgsl","fiber.wgsl"],evaluate:["arguments.wgsl","evaluate.wgsl"],trace:["geometry.wgsl","triangle.wgsl","segment.wgsl","bvh.wgsl","opaque.wgsl"]};var Uc=`// Arguments of a row that may be anything: spec/RNA.md, 8.1 Arguments and results. They are judged
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
`;var Fc=`// Input blocks that surfaces and fibers share: spec/RNA.md, 6.3 Input blocks. Each block starts at
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
    let first = rna_features(texels, 0u);
    let slot = rna_slot(RNA_BLOCK_FEATURES);
    if slot != RNA_NONE {
        rna_values[slot] = first;
        for (var group = 1u; group < rna_part.channel_groups; group++) {
            rna_values[slot + group] = rna_features(texels, group);
        }
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
`;var Bc=`// The decoder: spec/RNA.md, 6.4 Decoder profile. All loops take their lengths from RnaPart: shaders
// that are unrolled take minutes to compile.

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

// The colours for the queries in rna_values.
fn rna_decode() -> RnaTransport {
    rna_prepare_queries();
    var source = 0u;
    for (var k = 0u; k < rna_part.layer_count; k++) {
        rna_run_layer(rna_part.layers[k], source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    let last = rna_part.layers[rna_part.layer_count - 1u].outputs;
    for (var k = 0u; k < last; k++) {
        let x = clamp(rna_values[source + k], vec4f(0.0), vec4f(rna_part.top));
        rna_values[source + k] = (exp(x) - 1.0) * rna_part.unit;
    }
    if rna_part.matrix.inputs != 0u {
        rna_run_layer(rna_part.matrix, source, RNA_GROUPS - source);
        source = RNA_GROUPS - source;
    }
    let first = rna_values[source];
    let second = rna_values[source + 1u];
    let visible = max(first.xyz, vec3f(0.0));
    return RnaTransport(visible, max(vec3f(first.w, second.xy), vec3f(0.0)));
}
`;var zc=`// Evaluation of rows: spec/RNA.md, 8 Evaluation. Transport and emission, surfaces and fibers.

@group(1) @binding(0) var<storage, read> rna_rows: array<vec4<u32>>; // 4 a row, see README.md
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
    let position = rna_rows[4u * row];
    let axis = rna_rows[4u * row + 1u].xyz;
    let wo = rna_rows[4u * row + 2u].xyz;
    let wi = rna_rows[4u * row + 3u].xyz;
    let finite = rna_is_finite(position) && rna_is_finite(vec4<u32>(axis, 0u))
        && rna_is_finite(vec4<u32>(wo, 0u)) && rna_is_finite(vec4<u32>(wi, 0u));
    let a = rna_unit(axis);
    let o = rna_unit(wo);
    let i = rna_unit(wi);
    let nothing = vec3f(0.0);
    var result = RnaTransport(nothing, nothing);
    if finite && any(a != nothing) && any(o != nothing) && any(i != nothing) {
        result = rna_query(bitcast<vec3f>(position.xyz), a, bitcast<f32>(position.w), o, i);
    }
    rna_write(row, result);
}
`;var Yo=`// Directions about an axis.

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
`;var kc=`// Transport, or emission, at a point of a fiber: spec/RNA.md, 7 Light.

// x: object space, metres. t (root to tip), wo, wi: unit; h: offset across the width; all finite.
// An emission decoder reads no wi.
fn rna_fiber(x: vec3f, t: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    rna_common_blocks(x, wo, wi);
    rna_fiber_blocks(t, clamp(h, -1.0, 1.0), wo, wi);
    return rna_decode();
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_fiber(x, axis, h, wo, wi);
}
`;var Gc=`// Input blocks of fibers alone: spec/RNA.md, 6.3 Input blocks and "In float32".

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
`;var Hc=`// The bindings of one part of a tier: spec/RNA.md, 3 Manifest and 6.4 Decoder profile.

@group(0) @binding(0) var<uniform> rna_part: RnaPart;
@group(0) @binding(2) var<storage, read> rna_plane_xy: array<u32>;
@group(0) @binding(3) var<storage, read> rna_plane_yz: array<u32>;
@group(0) @binding(4) var<storage, read> rna_plane_zx: array<u32>;

// The queries' columns, and the values between layers: two halves of RNA_GROUPS groups, read and
// written by turns. RNA_GROUPS is declared by whoever composes the files.
var<private> rna_values: array<vec4f, 2u * RNA_GROUPS>;
`;var Vc=`// Generated by \`python -m rna_gpu.records.write_records\`; do not edit. Numbers before comments: bytes.

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
`;var Wc=`// Features of a position: spec/RNA.md, 5 Planes.

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
    let x = vec2<u32>(t.low.x, t.high.x);
    let y = vec2<u32>(t.low.y, t.high.y);
    let z = vec2<u32>(t.low.z, t.high.z);
    return rna_bilinear(0u, group, x, y, t.fraction.x, t.fraction.y)
        + rna_bilinear(1u, group, y, z, t.fraction.y, t.fraction.z)
        + rna_bilinear(2u, group, z, x, t.fraction.z, t.fraction.x);
}
`;var Zo=`// Where a ray enters a round cone from outside: spec/RNA.md, 4.2 Curves and 7.1 Transport.

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
fn rna_in_neighbour(segment: vec4<u32>, p: vec3f) -> bool {
    if (segment.y & 1u) != 0u {
        let before = rna_cone(segment.x - 1u);
        if rna_cone_distance(before, p) < -1e-4 * min(before.ra, before.rb) {
            return true;
        }
    }
    if (segment.y & 2u) != 0u {
        let after = rna_cone(segment.x + 1u);
        return rna_cone_distance(after, p) < -1e-4 * min(after.ra, after.rb);
    }
    return false;
}

// t of RNA_FAR for a miss.
fn rna_meet_segment(ray: RnaRay, segment: vec4<u32>) -> RnaEntry {
    let miss = RnaEntry(RNA_FAR, vec3f(0.0));
    let cone = rna_cone(segment.x);
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
`;var Xc=`// Transport, or emission, at a point of a surface: spec/RNA.md, 7 Light.

// x: object space, metres. n, wo, wi: unit, away from the surface; all finite. An emission decoder
// reads no wi.
fn rna_surface(x: vec3f, n: vec3f, wo: vec3f, wi: vec3f) -> RnaTransport {
    let features = rna_common_blocks(x, wo, wi);
    rna_surface_blocks(n, features, wo, wi);
    return rna_decode();
}

fn rna_query(x: vec3f, axis: vec3f, h: f32, wo: vec3f, wi: vec3f) -> RnaTransport {
    return rna_surface(x, axis, wo, wi);
}
`;var qc=`// Input blocks of surfaces alone: spec/RNA.md, 6.3 Input blocks and "In float32".

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
`;var Ko=`// Where a ray meets a triangle, from either side, watertight: Woop, Benthin and Wald, Watertight
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
`;var Jo=`// Where visibility rays of meshes start: spec/RNA.md, 7.1 Transport. Those of strands start at x.

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
`;var $c=`// Weights of more than 64 KiB.

@group(0) @binding(1) var<storage, read> rna_weights: array<vec4f>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`;var Yc=`// Weights of up to 64 KiB. On software drivers they are read ten times faster from a uniform
// buffer than from storage.

@group(0) @binding(1) var<uniform> rna_weights: array<vec4f, 4096>;

fn rna_weight(at: u32) -> vec4f {
    return rna_weights[at];
}
`;var Zc=`// What a band of the picture holds between the kernels: of each pixel a row as rna_evaluate reads it, with four
// numbers in its free places, and what it weighs.

struct Row {
    position: vec4<u32>, // and h of a fiber, b1 of a surface
    axis: vec4<u32>,     // and part + 1, or 0 where nothing is hit
    wo: vec4<u32>,       // and the place of the primitive
    wi: vec4<u32>,       // and b2
}

@group(1) @binding(0) var<storage, read_write> rows: array<Row>;
@group(1) @binding(1) var<storage, read_write> through: array<vec4f>; // throughput

// The pixel of an invocation; beyond the band y is at least view.rows.
fn pixel_of(index: u32) -> vec2<u32> {
    return vec2<u32>(index % view.width, index / view.width);
}
`;var Kc=`// A ray from the camera through each pixel of the band, to the query of its first hit.

const SEEN_THROUGH = 32u;

fn words(v: vec3f, last: u32) -> vec4<u32> {
    return vec4<u32>(bitcast<vec3<u32>>(v), last);
}

@compute @workgroup_size(64)
fn trace_pixels(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    let local = pixel_of(index);
    if local.y >= view.rows {
        return;
    }
    let pixel = vec2<u32>(local.x, local.y + view.first_row);
    let at = vec2f(pixel) + mix(vec2f(0.5), random(pixel, PLACE), view.jitter);
    let d = normalize(view.corner + at.x * view.step_x + at.y * view.step_y);
    var origin = view.camera;
    var throughput = vec3f(1.0);
    let nothing = vec4<u32>(0u);
    var row = Row(nothing, nothing, words(-d, 0u), nothing);
    for (var k = 0u; k < SEEN_THROUGH; k++) {
        let hit = nearest(origin, d);
        if hit.t == FAR {
            break;
        }
        let primitive = primitives[hit.place];
        let fiber = HAS_SEGMENTS && (hit.number & SEGMENT) != 0u;
        var tau = vec3f(0.0);
        if !fiber {
            tau = transmittance(primitive, hit, d);
        }
        let chance = max(tau.x, max(tau.y, tau.z));
        // Straight on, or stopped here: chosen at random (spec, 4.4).
        if chance > 0.0 && random(pixel, STOPPED + k).x < chance {
            throughput *= tau / chance;
            origin += d * (hit.t + 4.0 * view.epsilon);
            continue;
        }
        if chance > 0.0 {
            throughput *= (1.0 - tau) / (1.0 - chance);
        }
        let part = part_of(hit.number & ~SEGMENT) + 1u;
        if fiber {
            let t = tangent_of(primitive);
            let h = offset_across(hit.n, t, -d);
            row.position = words(origin + hit.t * d, bitcast<u32>(h));
            row.axis = words(t, part);
        } else {
            let corners = corners_of(primitive);
            row.position = words(mixed(corners.p, weights_of(hit)), bitcast<u32>(hit.b1));
            row.axis = words(shading_normal(primitive, hit), part);
        }
        row.wo.w = hit.place;
        row.wi.w = bitcast<u32>(hit.b2);
        break;
    }
    rows[index] = row;
    through[index] = vec4f(throughput, 0.0);
}

// The normals of hits whose place and barycentric coordinates are in the rows.
@compute @workgroup_size(64)
fn find_normals(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= view.width {
        return;
    }
    let row = rows[id.x];
    let hit = Hit(0.0, 0u, row.wo.w, bitcast<f32>(row.position.w), bitcast<f32>(row.wi.w), vec3f(0.0));
    rows[id.x].axis = words(shading_normal(primitives[row.wo.w], hit), row.axis.w);
}
`;var Jc=`// For each query a direction of one light, what arrives from there, and how much of it the asset lets through; and
// the light on the ground.

struct Light {
    direction: vec3f, // of a sun
    kind: u32,        // 0: sun; the environment: 1 where it is bright, 3 about the point; 2: directions of the rows
    colour: vec3f,    // irradiance of a sun, or a factor of the environment
    ground: f32,      // its height
    turn: vec2f,      // cosine and sine of the environment's rotation
    middle: vec2f,    // of the ground, x and z
    ground_colour: vec3f, // radiance of it in full light, over the light's irradiance
    ground_size: f32,     // 0: there is no ground
    first: u32,           // 1: the sum starts with this
    counts_coverage: u32,
    unused_a: u32,
    unused_b: u32,
}

struct Lit {
    visibility: vec3f,
    is_query: u32,
    radiance: vec3f, // over the density, times the throughput
    unused: u32,
}

@group(1) @binding(2) var<storage, read_write> lit: array<Lit>;
@group(1) @binding(3) var<storage, read_write> sums: array<vec4f>; // of the whole picture
@group(2) @binding(0) var<uniform> light: Light;
@group(2) @binding(1) var environment: texture_2d<f32>; // radiance, row 0 at +y; w: distribution along the row
@group(2) @binding(2) var marginal: texture_2d<f32>;    // distribution over rows; 1 / the sum of weights; the least weight

const PI = 3.14159265358979;

fn row_of(u: f32, count: i32) -> i32 {
    var low = 0;
    var high = count - 1;
    while low < high {
        let middle = (low + high) / 2;
        if textureLoad(marginal, vec2<i32>(middle, 0), 0).x > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

fn column_of(u: f32, row: i32, count: i32) -> i32 {
    var low = 0;
    var high = count - 1;
    while low < high {
        let middle = (low + high) / 2;
        if textureLoad(environment, vec2<i32>(middle, row), 0).w > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

struct Arrival {
    wi: vec3f,
    radiance: vec3f, // over the density
}

// A texel's weight among all: luminance times the sine of its row.
fn texel_weight(rgb: vec3f, row: i32, size: vec2<i32>) -> f32 {
    let least = textureLoad(marginal, vec2<i32>(size.y + 1, 0), 0).x;
    return max(least, dot(rgb, vec3f(0.2126, 0.7152, 0.0722))) * sin(PI * (f32(row) + 0.5) / f32(size.y));
}

struct Sky {
    radiance: vec3f,
    density: f32, // of \`bright_direction\`
}

// Radiance at a place in the image, bilinear, and the density there: the weights, bilinear.
fn sky_at(st: vec2f, sine: f32) -> Sky {
    let size = vec2<i32>(textureDimensions(environment));
    let at = st * vec2f(size) - 0.5;
    let low = floor(at);
    let f = at - low;
    var radiance = vec3f(0.0);
    var weight = 0.0;
    for (var k = 0; k < 4; k++) {
        let step = vec2<i32>(k & 1, k >> 1u);
        let share = select(1.0 - f.x, f.x, step.x == 1) * select(1.0 - f.y, f.y, step.y == 1);
        let column = (i32(low.x) + step.x + size.x) % size.x;
        let row = clamp(i32(low.y) + step.y, 0, size.y - 1);
        let rgb = textureLoad(environment, vec2<i32>(column, row), 0).xyz;
        radiance += share * rgb;
        weight += share * texel_weight(rgb, row, size);
    }
    let over_total = textureLoad(marginal, vec2<i32>(size.y, 0), 0).x;
    return Sky(radiance, weight * over_total * f32(size.x * size.y) / (2.0 * PI * PI * max(sine, 1e-6)));
}

// From a direction of the image to that of the world, and back.
fn turned(d: vec3f) -> vec3f {
    return vec3f(light.turn.x * d.x + light.turn.y * d.z, d.y, light.turn.x * d.z - light.turn.y * d.x);
}

fn turned_back(d: vec3f) -> vec3f {
    return vec3f(light.turn.x * d.x - light.turn.y * d.z, d.y, light.turn.x * d.z + light.turn.y * d.x);
}

// From the uniform distribution on [0, 1] to the tent about 0, on [-1, 1].
fn tent(u: vec2f) -> vec2f {
    let t = 2.0 * clamp(u, vec2f(0.0), vec2f(1.0)) - 1.0;
    return sign(t) * (1.0 - sqrt(1.0 - abs(t)));
}

// A direction: a texel in proportion to its weight, then a place about its middle by a tent two texels wide. So the
// density is the weights' bilinear interpolation, and follows the radiance that is looked up, beside a sun, too.
fn bright_direction(u: vec2f) -> vec3f {
    let size = vec2<i32>(textureDimensions(environment));
    let row = row_of(u.y, size.y);
    var before = 0.0;
    if row > 0 {
        before = textureLoad(marginal, vec2<i32>(row - 1, 0), 0).x;
    }
    let chance = textureLoad(marginal, vec2<i32>(row, 0), 0).x - before;
    let column = column_of(u.x, row, size.x);
    var left = 0.0;
    if column > 0 {
        left = textureLoad(environment, vec2<i32>(column - 1, row), 0).w;
    }
    let width = textureLoad(environment, vec2<i32>(column, row), 0).w - left;
    let within = (u - vec2f(left, before)) / max(vec2f(width, chance), vec2f(1e-12));
    let place = (vec2f(f32(column), f32(row)) + 0.5 + tent(within)) / vec2f(size);
    let st = vec2f(fract(place.x), 1.0 - abs(1.0 - abs(place.y))); // back from beyond the poles
    let theta = PI * st.y;
    let phi = 2.0 * PI * (st.x - 0.5);
    return turned(vec3f(sin(theta) * sin(phi), cos(theta), -sin(theta) * cos(phi)));
}

// Directions about a point: some about the mirror direction, where highlights lie; of the others some from all sides,
// since light comes through, and the rest by the cosine about the normal. A vector of zero stands for none: the ground
// has no highlights, and about a strand all come from all sides.
struct Surroundings {
    n: vec3f, // turned to the viewer
    mirror: vec3f,
}

const MIRRORED = 1.0 / 3.0;
const MIRROR_KAPPA = 20.0; // of a von Mises-Fisher distribution
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

fn surroundings_of(row: Row) -> Surroundings {
    if row.axis.w == 0u {
        return Surroundings(vec3f(0.0, 1.0, 0.0), vec3f(0.0)); // of the ground
    }
    if HAS_SEGMENTS && (primitives[row.wo.w].w & SEGMENT) != 0u {
        return Surroundings(vec3f(0.0), vec3f(0.0));
    }
    let n = bitcast<vec3f>(row.axis.xyz);
    let wo = bitcast<vec3f>(row.wo.xyz);
    return Surroundings(select(n, -n, dot(n, wo) < 0.0), reflect(-wo, n));
}

// One sample of both techniques each, as two lights: the balance heuristic (Veach and Guibas 1995).
fn arrival_at(pixel: vec2<u32>, row: Row) -> Arrival {
    if light.kind == 0u {
        return Arrival(light.direction, light.colour);
    }
    if light.kind == 2u {
        return Arrival(bitcast<vec3f>(row.wi.xyz), light.colour);
    }
    let u = random(pixel, DIRECTION);
    let at = surroundings_of(row);
    var wi: vec3f;
    if light.kind == 1u {
        wi = bright_direction(u);
    } else {
        wi = direction_about(at, u);
    }
    let d = turned_back(wi);
    let sky = sky_at(vec2f(atan2(d.x, -d.z) / (2.0 * PI) + 0.5, acos(clamp(d.y, -1.0, 1.0)) / PI), length(d.xz));
    return Arrival(wi, light.colour * sky.radiance / (sky.density + density_about(at, wi)));
}

// Where a ray to the light starts, and what it may bring.
struct Start {
    origin: vec3f,
    strand: u32, // that is no obstacle
    weight: vec3f,
    coverage: f32,
}

fn start_of(row: Row, wi: vec3f) -> Start {
    let primitive = primitives[row.wo.w];
    if HAS_SEGMENTS && (primitive.w & SEGMENT) != 0u {
        return Start(bitcast<vec3f>(row.position.xyz), primitive.z, vec3f(1.0), 1.0);
    }
    let hit = Hit(0.0, primitive.w, row.wo.w, bitcast<f32>(row.position.w), bitcast<f32>(row.wi.w), vec3f(0.0));
    return Start(lifted_origin(primitive, hit, wi), NO_STRAND, vec3f(1.0), 1.0);
}

// The ground shows the shadow, and fades with the distance.
fn start_on_ground(d: vec3f, wi: vec3f) -> Start {
    let nothing = Start(vec3f(0.0), NO_STRAND, vec3f(0.0), 0.0);
    if light.ground_size == 0.0 || d.y * (view.camera.y - light.ground) >= 0.0 {
        return nothing;
    }
    let x = view.camera + d * ((light.ground - view.camera.y) / d.y);
    let fade = 1.0 - smoothstep(0.5, 1.0, length(x.xz - light.middle) / light.ground_size);
    return Start(x + vec3f(0.0, view.epsilon, 0.0), NO_STRAND, fade * max(0.0, wi.y) * light.ground_colour, fade);
}

@compute @workgroup_size(64)
fn light_pixels(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    let local = pixel_of(index);
    if local.y >= view.rows {
        return;
    }
    let row = rows[index];
    let is_query = row.axis.w != 0u;
    let arrival = arrival_at(vec2<u32>(local.x, local.y + view.first_row), row);
    var start: Start;
    if is_query {
        start = start_of(row, arrival.wi);
    } else {
        start = start_on_ground(-bitcast<vec3f>(row.wo.xyz), arrival.wi);
    }
    var passed = vec3f(0.0);
    if any(start.weight > vec3f(0.0)) {
        passed = passes(start.origin, arrival.wi, start.strand);
    }
    let radiance = through[index].xyz * arrival.radiance;
    rows[index].wi = vec4<u32>(bitcast<vec3<u32>>(arrival.wi), row.wi.w);
    lit[index] = Lit(passed, u32(is_query), radiance, 0u);
    let at = view.first_row * view.width + index;
    var sum = vec4f(0.0);
    if light.first == 0u {
        sum = sums[at];
    }
    let on_ground = select(start.weight * passed * radiance, vec3f(0.0), is_query);
    sums[at] = sum + vec4f(on_ground, start.coverage * f32(light.counts_coverage));
}
`;var jc=`// What a hit is on: normals, relief, transmittance (spec, 4.1, 4.4, 4.5), and where its ray to the light starts (7.1).

struct Corners {
    p: array<vec3f, 3>,
    n: array<vec3f, 3>,
    uv: array<vec2f, 3>,
}

fn corners_of(primitive: vec4<u32>) -> Corners {
    var corners: Corners;
    for (var k = 0u; k < 3u; k++) {
        let place = rna_points[primitive[k]];
        let normal = rna_points[view.normals_at + primitive[k]];
        corners.p[k] = place.xyz;
        corners.n[k] = normal.xyz;
        corners.uv[k] = vec2f(place.w, normal.w);
    }
    return corners;
}

fn weights_of(hit: Hit) -> vec3f {
    return vec3f(1.0 - hit.b1 - hit.b2, hit.b1, hit.b2);
}

fn mixed(v: array<vec3f, 3>, b: vec3f) -> vec3f {
    return b.x * v[0] + b.y * v[1] + b.z * v[2];
}

// Of twelve words: kind, first and end of the primitives, offset of texels; width, height, channels,
// cutoff; two indices of refraction.
struct Record {
    offset: u32,
    size: vec2<u32>,
    channels: u32,
    cutoff: f32,
    front: f32,
    back: f32,
}

fn record_at(k: u32) -> Record {
    let at = 12u * k;
    return Record(
        textures[at + 3u], vec2<u32>(textures[at + 4u], textures[at + 5u]), textures[at + 6u],
        bitcast<f32>(textures[at + 7u]), bitcast<f32>(textures[at + 8u]), bitcast<f32>(textures[at + 9u]),
    );
}

// The record of this kind that the triangle is in, or -1.
fn record_of(number: u32, kind: u32) -> i32 {
    for (var k = 0u; k < view.record_count; k++) {
        let at = 12u * k;
        if textures[at] == kind && number >= textures[at + 1u] && number < textures[at + 2u] {
            return i32(k);
        }
    }
    return -1;
}

fn texel_at(record: Record, column: u32, row: u32) -> vec3f {
    let first = record.offset + ((row % record.size.y) * record.size.x + column % record.size.x) * record.channels;
    var value = vec3f(0.0);
    for (var c = 0u; c < record.channels; c++) {
        let at = first + c;
        value[c] = f32((textures[view.texels_at + at / 4u] >> (8u * (at % 4u))) & 255u);
    }
    return value;
}

// The bilinear lookup of 4.4, in values from 0 to 255; the texture repeats.
fn look_up(record: Record, uv: vec2f) -> vec3f {
    let size = vec2f(record.size);
    let place = uv * size - 0.5;
    let below = floor(place);
    let f = place - below;
    let low = vec2<u32>(clamp(below - size * floor(below / size), vec2f(0.0), size - 1.0));
    let lower = mix(texel_at(record, low.x, low.y), texel_at(record, low.x + 1u, low.y), f.x);
    let upper = mix(texel_at(record, low.x, low.y + 1u), texel_at(record, low.x + 1u, low.y + 1u), f.x);
    return mix(lower, upper, f.y);
}

fn uv_of(corners: Corners, b: vec3f) -> vec2f {
    return b.x * corners.uv[0] + b.y * corners.uv[1] + b.z * corners.uv[2];
}

fn fresnel(index: f32, c: f32) -> f32 {
    let g2 = index * index - 1.0 + c * c;
    if g2 <= 0.0 {
        return 1.0;
    }
    let g = sqrt(g2);
    let r = (g - c) / (g + c);
    let s = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return clamp(0.5 * r * r * (1.0 + s * s), 0.0, 1.0);
}

fn transmittance(primitive: vec4<u32>, hit: Hit, d: vec3f) -> vec3f {
    if !HAS_TEXTURES {
        return vec3f(0.0);
    }
    let k = record_of(primitive.w, 0u);
    if k < 0 {
        return vec3f(0.0);
    }
    let record = record_at(u32(k));
    let corners = corners_of(primitive);
    let b = weights_of(hit);
    var tau = look_up(record, uv_of(corners, b)) / 255.0;
    if record.channels == 1u {
        tau = tau.xxx;
    }
    if record.cutoff > 0.0 {
        tau = vec3f(select(0.0, 1.0, tau.x > record.cutoff));
    }
    if record.front > 0.0 {
        let n = unit(mixed(corners.n, b));
        let ng = cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]);
        let index = select(record.back, record.front, dot(d, ng) < 0.0);
        tau *= 1.0 - fresnel(index, abs(dot(n, d)));
    }
    return tau;
}

// The normal with relief, 4.5.
fn mapped_normal(number: u32, corners: Corners, b: vec3f, n: vec3f) -> vec3f {
    if !HAS_TEXTURES {
        return n;
    }
    let k = record_of(number, 1u);
    if k < 0 {
        return n;
    }
    let e1 = corners.p[1] - corners.p[0];
    let e2 = corners.p[2] - corners.p[0];
    let a = corners.uv[1] - corners.uv[0];
    let c = corners.uv[2] - corners.uv[0];
    let area = a.x * c.y - c.x * a.y;
    let u = (c.y * e1 - a.y * e2) * sign(area);
    let v = (a.x * e2 - c.x * e1) * sign(area);
    let along = u - dot(u, n) * n;
    if area == 0.0 || length(along) <= 1e-6 * length(u) {
        return n;
    }
    let t = unit(along);
    var up = cross(n, t);
    if dot(up, v) > 0.0 {
        up = -up;
    }
    let q = (look_up(record_at(u32(k)), uv_of(corners, b)).xy - 127.0) / 127.0;
    let m = q.x * t + q.y * up + sqrt(max(0.0, 1.0 - dot(q, q))) * n;
    if length(m) <= 1e-6 {
        return n;
    }
    return normalize(m);
}

fn shading_normal(primitive: vec4<u32>, hit: Hit) -> vec3f {
    let corners = corners_of(primitive);
    let b = weights_of(hit);
    return mapped_normal(primitive.w, corners, b, unit(mixed(corners.n, b)));
}

fn tangent_of(primitive: vec4<u32>) -> vec3f {
    return unit(rna_points[primitive.x + 1u].xyz - rna_points[primitive.x].xyz);
}

// h of 4.2.
fn offset_across(n: vec3f, t: vec3f, wo: vec3f) -> f32 {
    let across = cross(t, wo);
    let size = length(across);
    if size <= 1e-6 {
        return 0.0;
    }
    return clamp(dot(n, across) / size, -1.0, 1.0);
}

// Where the visibility ray of a mesh starts, by rna_gpu's visibility.wgsl.
fn lifted_origin(primitive: vec4<u32>, hit: Hit, wi: vec3f) -> vec3f {
    let corners = corners_of(primitive);
    let b = weights_of(hit);
    let x = mixed(corners.p, b);
    let n = unit(mixed(corners.n, b));
    let ng = unit(cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
    let places = mat3x3f(corners.p[0], corners.p[1], corners.p[2]);
    let lift = rna_lift(x, b, places, mat3x3f(corners.n[0], corners.n[1], corners.n[2]));
    return rna_leaving_origin(x, n, ng, lift, wi, view.epsilon * 0x1p18f);
}
`;var Qc=`// The queries of one part, one behind the other as rna_evaluate reads them; and back, its answers to the picture.

struct Queue {
    width: u32,
    first_row: u32,
    rows: u32,
    part: u32,      // + 1
    emission: u32,  // 1: answers are of emission, one vec4f each
    unused_a: u32,
    unused_b: u32,
    unused_c: u32,
}

struct Row {
    position: vec4<u32>,
    axis: vec4<u32>,
    wo: vec4<u32>,
    wi: vec4<u32>,
}

struct Lit {
    visibility: vec3f,
    is_query: u32,
    radiance: vec3f,
    unused: u32,
}

@group(0) @binding(0) var<uniform> queue: Queue;
@group(0) @binding(1) var<storage, read_write> rows: array<Row>;
@group(0) @binding(2) var<storage, read_write> through: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> lit: array<Lit>;
@group(0) @binding(4) var<storage, read_write> sums: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> asked: array<Row>;
@group(0) @binding(6) var<storage, read_write> answers: array<vec4f>;
@group(0) @binding(7) var<storage, read_write> count: array<atomic<u32>>; // [0]; then the pixel of each row

@compute @workgroup_size(64)
fn gather(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.y * groups.x * 64u + id.x;
    if index >= queue.width * queue.rows || rows[index].axis.w != queue.part {
        return;
    }
    var row = rows[index];
    let at = atomicAdd(&count[0], 1u);
    atomicStore(&count[at + 1u], index);
    if queue.emission == 1u {
        row.wi = row.wo; // which no block of emission reads
    }
    asked[at] = row;
}

@compute @workgroup_size(64)
fn scatter(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let at = id.y * groups.x * 64u + id.x;
    if at >= atomicLoad(&count[0]) {
        return;
    }
    let index = atomicLoad(&count[at + 1u]);
    var radiance: vec3f;
    if queue.emission == 1u {
        radiance = through[index].xyz * answers[at].xyz;
    } else {
        let own = lit[index];
        radiance = own.radiance * mix(answers[2u * at + 1u].xyz, answers[2u * at].xyz, own.visibility);
    }
    sums[queue.first_row * queue.width + index] += vec4f(radiance, 0.0);
}
`;var eh=`// Numbers in [0, 1). Of a pixel's place and of the light: of each pixel a start of its own, and from there the additive
// recurrence in four dimensions (Roberts 2018), so that the samples of a pixel are spread evenly. All others: hashed.

fn hashed(x: u32) -> u32 { // PCG; Jarzynski and Olano, "Hash Functions for GPU Rendering" (JCGT 2020)
    let state = x * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

const PLACE = 0u;
const DIRECTION = 1u;
const STOPPED = 2u; // and those behind it

fn random(pixel: vec2<u32>, dimension: u32) -> vec2f {
    let own = select(0u, view.sample, dimension >= STOPPED);
    let seed = hashed(pixel.x + hashed(pixel.y + hashed(dimension + hashed(own))));
    let start = vec2f(f32(seed >> 8u), f32(hashed(seed) >> 8u)) / 16777216.0;
    if dimension >= STOPPED {
        return start;
    }
    // In whole numbers: floats of later samples would lose digits.
    let turn = select(vec2<u32>(3679390609u, 3152041523u), vec2<u32>(2700274805u, 2313257605u), dimension == DIRECTION);
    return fract(start + vec2f((turn * view.sample) >> vec2<u32>(8u)) / 16777216.0);
}
`;var th=`// The asset's geometry in buffers: see geometry/scene_arrays.js. What this file and its neighbours do is what the
// spec says of hits (4) and of visibility rays (7.1).

// HAS_SEGMENTS and HAS_TEXTURES are declared by whoever composes the files: code that an asset has no use for
// is not compiled, which takes most of the time to its first picture.

struct View {
    camera: vec3f,
    epsilon: f32,           // the spec's e, 7.1
    corner: vec3f,          // direction through the image's top left corner
    width: u32,
    step_x: vec3f,          // of a pixel
    first_row: u32,         // of the band
    step_y: vec3f,
    rows: u32,              // of the band
    sample: u32,
    normals_at: u32,        // first normal in \`rna_points\`
    record_count: u32,
    texels_at: u32,         // first word of texels in \`textures\`
    part_count: u32,
    jitter: f32,            // 0: rays through the middles of pixels, 1: anywhere in them
    unused_b: u32,
    unused_c: u32,
    part_first: array<vec4<u32>, 4>, // number of each part's first primitive
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<storage, read> nodes: array<vec4<u32>>;      // two a node
@group(0) @binding(2) var<storage, read> primitives: array<vec4<u32>>; // in the order of the leaves
@group(0) @binding(3) var<storage, read> rna_points: array<vec4f>; // position, u or radius; then normal, v
@group(0) @binding(4) var<storage, read> textures: array<u32>;   // twelve words a record, then texels

const SEGMENT = 0x80000000u;
const FAR = RNA_FAR;

// What rna_gpu's triangle.wgsl and segment.wgsl take; a renderer with instances declares them in geometry.wgsl.
const RNA_FAR: f32 = 1e30;

struct RnaRay {
    origin: vec3f,
    near: f32,
    direction: vec3f, // unit
    far: f32,
}

struct Hit {
    t: f32,
    number: u32, // of the primitive, with SEGMENT
    place: u32,  // of it in \`primitives\`
    b1: f32,     // barycentric coordinates
    b2: f32,
    n: vec3f,    // of a segment, outward
}

fn part_of(number: u32) -> u32 {
    var found = 0u;
    var first = -1;
    for (var k = 0u; k < view.part_count; k++) {
        let own = i32(view.part_first[k / 4u][k % 4u]);
        if i32(number) >= own && own > first {
            found = k;
            first = own;
        }
    }
    return found;
}

fn unit(v: vec3f) -> vec3f {
    let size = abs(v);
    let largest = max(size.x, max(size.y, size.z));
    if largest == 0.0 {
        return vec3f(0.0);
    }
    return normalize(v / largest);
}
`;var nh=`// The picture on the page: mean of the samples, less noise while they are few, exposure, view transform, sRGB.

struct Show {
    size: vec2f,    // of the canvas, pixels
    picture: vec2f, // of the picture
    backdrop: vec3f, // linear light of the screen
    rounds: f32,
    exposure: f32,  // a factor
    filmic: f32,    // 1 for the filmic view transform, 0 for none
    spread: f32,    // of noise, in values of the screen; 0 to leave it
    unused: f32,
}

@group(0) @binding(0) var<uniform> shown: Show;
@group(0) @binding(1) var<storage, read> sums: array<vec4f>;

@vertex
fn corner(@builtin(vertex_index) k: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(k & 1u), f32(k >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

fn picture_at(x: f32, y: f32) -> vec4f {
    let place = vec2<u32>(clamp(vec2f(x, y), vec2f(0.0), shown.picture - 1.0));
    return sums[place.y * u32(shown.picture.x) + place.x];
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
    let mean = mix(above, below, f.y) / shown.rounds;
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
            let other = picture_at(there.x, there.y) / shown.rounds;
            let value = displayed(other);
            let away = there - place;
            let unlike = (value - here) / shown.spread;
            let edge = 4.0 * (other.w - mean.w);
            sum += vec4f(value, 1.0) * exp(-0.3 * dot(away, away) - 0.5 * dot(unlike, unlike) - edge * edge);
        }
    }
    return vec4f(sum.xyz / sum.w, 1.0);
}
`;var ih=`// Rays against the hierarchy of three-mesh-bvh: the nearest hit, and how much light passes (spec, 7.1).

const STACK = 48;
const NO_STRAND = 0xffffffffu;

// No axis is exactly parallel: 0 times infinity would be no number.
fn inverse_of(d: vec3f) -> vec3f {
    return 1.0 / select(d, vec3f(1e-20), abs(d) < vec3f(1e-20));
}

// Where the ray enters the box of a node, FAR if not.
fn enters(node: u32, origin: vec3f, inverse: vec3f, far: f32) -> f32 {
    let first = bitcast<vec4f>(nodes[2u * node]);
    let second = bitcast<vec2f>(nodes[2u * node + 1u].xy);
    let a = (first.xyz - origin) * inverse;
    let b = (vec3f(first.w, second) - origin) * inverse;
    let low = min(a, b);
    let high = max(a, b);
    let near = max(max(low.x, low.y), max(low.z, 0.0));
    let last = min(min(high.x, high.y), min(high.z, far)) * 1.0000004;
    return select(FAR, near, near <= last);
}

// A primitive in a leaf, by rna_gpu's triangle.wgsl and segment.wgsl: whether it is met, nearer than \`hit\`,
// which then becomes it.
fn meets(place: u32, ray: RnaRay, own: u32, hit: ptr<function, Hit>) -> bool {
    let primitive = primitives[place];
    if !HAS_SEGMENTS || (primitive.w & SEGMENT) == 0u {
        let found = rna_meet_triangle(
            ray, rna_points[primitive.x].xyz, rna_points[primitive.y].xyz, rna_points[primitive.z].xyz,
        );
        if found.x >= FAR {
            return false;
        }
        *hit = Hit(found.x, primitive.w, place, found.y, found.z, vec3f(0.0));
        return true;
    }
    if primitive.z == own {
        return false;
    }
    let entry = rna_meet_segment(ray, primitive);
    if entry.t >= FAR {
        return false;
    }
    *hit = Hit(entry.t, primitive.w, place, 0.0, 0.0, entry.normal);
    return true;
}

// t is FAR where there is no hit.
fn nearest(origin: vec3f, d: vec3f) -> Hit {
    var hit = Hit(FAR, 0u, 0u, 0.0, 0.0, vec3f(0.0));
    let inverse = inverse_of(d);
    var stack: array<u32, STACK>;
    var top = 0;
    var node = 0u;
    if enters(0u, origin, inverse, FAR) == FAR {
        return hit;
    }
    loop {
        let words = nodes[2u * node + 1u];
        if (words.w >> 16u) == 0xffffu {
            for (var k = words.z; k < words.z + (words.w & 0xffffu); k++) {
                meets(k, RnaRay(origin, 0.0, d, hit.t), NO_STRAND, &hit);
            }
        } else {
            let left = node + 1u;
            let right = node + words.z;
            let a = enters(left, origin, inverse, hit.t);
            let b = enters(right, origin, inverse, hit.t);
            if max(a, b) < FAR {
                stack[top] = select(left, right, a <= b);
                top++;
            }
            if min(a, b) < FAR {
                node = select(right, left, a <= b);
                continue;
            }
        }
        if top == 0 {
            break;
        }
        top--;
        node = stack[top];
    }
    return hit;
}

// The light that passes from origin along d to infinity, strand \`own\` being no obstacle.
fn passes(origin: vec3f, d: vec3f, own: u32) -> vec3f {
    var light = vec3f(1.0);
    let inverse = inverse_of(d);
    var stack: array<u32, STACK>;
    var top = 0;
    var node = 0u;
    if enters(0u, origin, inverse, FAR) == FAR {
        return light;
    }
    loop {
        let words = nodes[2u * node + 1u];
        if (words.w >> 16u) == 0xffffu {
            for (var k = words.z; k < words.z + (words.w & 0xffffu); k++) {
                var hit: Hit;
                if meets(k, RnaRay(origin, 0.0, d, FAR), own, &hit) {
                    if (hit.number & SEGMENT) != 0u {
                        return vec3f(0.0);
                    }
                    light *= transmittance(primitives[k], hit, d);
                    if all(light == vec3f(0.0)) {
                        return light;
                    }
                }
            }
        } else {
            let left = node + 1u;
            let right = node + words.z;
            let first = enters(left, origin, inverse, FAR) < FAR;
            let second = enters(right, origin, inverse, FAR) < FAR;
            if first && second {
                stack[top] = right;
                top++;
            }
            if first || second {
                node = select(right, left, first);
                continue;
            }
        }
        if top == 0 {
            break;
        }
        top--;
        node = stack[top];
    }
    return light;
}
`;var jo={"arguments.wgsl":Uc,"blocks.wgsl":Fc,"decoder.wgsl":Bc,"evaluate.wgsl":zc,"fiber.wgsl":kc,"fiber_blocks.wgsl":Gc,"part.wgsl":Hc,"part_records.wgsl":Vc,"planes.wgsl":Wc,"segment.wgsl":Zo,"surface.wgsl":Xc,"surface_blocks.wgsl":qc,"triangle.wgsl":Ko,"visibility.wgsl":Jo,"weights_storage.wgsl":$c,"weights_uniform.wgsl":Yc,"render/directions.wgsl":Yo};function es(s,...e){let t=e.flatMap(i=>i.endsWith(".wgsl")?[i]:Oc[i]);return Object.entries(s).map(([i,r])=>`const ${i}: u32 = ${r}u;
`).join("")+[...new Set(t)].map(i=>jo[i]).join(`
`)}var rh=[th,Ko,Zo,Jo,jc,ih,eh,Zc];function ts({hasSegments:s,hasTextures:e}){let t=`const HAS_SEGMENTS = ${s};
const HAS_TEXTURES = ${e};
`;return{hit:t+[...rh,Kc].join(`
`),light:t+[...rh,Yo,Jc].join(`
`)}}var Qo={queue:Qc,show:nh};var ns=class{constructor(e){this.device=e,this.made=new Map}get(e,t){let n=`${t}
${e}`;return this.made.has(n)||this.made.set(n,this._make(e,t)),this.made.get(n)}async _make(e,t){let n=await Pi(this.device,e);return this.device.createComputePipelineAsync({layout:"auto",compute:{module:n,entryPoint:t}})}},is=class s{static async make(e,t,n,i,r,o){let a=new s,{weights:l,record:c,groups:u}=Lc(n,i,r),{UNIFORM_WEIGHTS:f}=Fi,d=l.length/4<=f,p={RNA_GROUPS:u,RNA_COLOURS:i.outputs===6?2:1},_=d?"weights_uniform.wgsl":"weights_storage.wgsl";a.pipeline=await t.get(es(p,_,n.kind,"evaluate"),"rna_evaluate");let{UNIFORM:v,STORAGE:S}=GPUBufferUsage,M=d?new Float32Array(4*f):l;return d&&M.set(l),a.buffers=[Ae(e,c,v,"a decoder"),Ae(e,M,d?v:S,"a decoder")],a.part=Ni(e,a.pipeline,0,[...a.buffers,...o]),a.device=e,a}run(e,{rows:t,answers:n,count:i},r){this.bound??=Ni(this.device,this.pipeline,1,[t,n,i]),Mt(e,this.pipeline,[this.part,this.bound],r)}delete(){for(let e of this.buffers)e.destroy()}};var wn=1<<17,v0={sun:0,environment:1,given:2,aroundPoint:3},rs=class s{static label="WebGPU";static async open(e){let t=new s,n=await lc();Object.assign(t,{canvas:e,device:n,parts:[],lost:!1,bandPixels:wn}),n.lost.then(({reason:r,message:o})=>{t.lost=!0,t.closed||t.onlost?.(`the GPU was lost (${o||r})`)}),n.addEventListener("uncapturederror",({error:r})=>{t.error??=r}),t.context=e.getContext("webgpu");let i=navigator.gpu.getPreferredCanvasFormat();return t.context.configure({device:n,format:i,alphaMode:"opaque",usage:GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.COPY_SRC}),t.pipelines=new ns(n),t.compiled=t._compile(i),t.compiled.catch(()=>{}),t}async _compile(e){let{device:t}=this,n=await Pi(t,Qo.show),[i,r,o]=await Promise.all([...await this._queuePipelines(),t.createRenderPipelineAsync({layout:"auto",vertex:{module:n,entryPoint:"corner"},fragment:{module:n,entryPoint:"colour",targets:[{format:e}]}})]);Object.assign(this,{queueKernels:{gather:i,scatter:r},shown:o}),this._makeBand()}async _queuePipelines(){let{device:e}=this,t=await Pi(e,Qo.queue),n=GPUShaderStage.COMPUTE,i=Array.from({length:8},(o,a)=>({binding:a,visibility:n,buffer:{type:a?"storage":"uniform"}}));this.queueLayout=e.createBindGroupLayout({entries:i});let r=e.createPipelineLayout({bindGroupLayouts:[this.queueLayout]});return["gather","scatter"].map(o=>e.createComputePipelineAsync({layout:r,compute:{module:t,entryPoint:o}}))}_makeBand(){let{device:e}=this,{UNIFORM:t}=GPUBufferUsage;this.view=Ae(e,176,t),this.lightRecord=Ae(e,96,t),this.queueRecord=Ae(e,32,t),this.showRecord=Ae(e,48,t),this.band={rows:Ae(e,64*wn),through:Ae(e,16*wn),lit:Ae(e,32*wn)},this.queue={rows:Ae(e,64*wn),answers:Ae(e,32*wn),count:Ae(e,4*(wn+4))},this.images||this.setEnvironment({values:new Float32Array(4),marginal:new Float32Array(1),width:1,height:1})}async setAsset(e,t){let{device:n}=this;this._deleteAsset();let i=new Float32Array(e.places.length+e.normals.length);i.set(e.places),i.set(e.normals,e.places.length);let r=new Uint32Array(e.records.length+Math.ceil(e.texels.length/4));r.set(e.records),new Uint8Array(r.buffer).set(e.texels,4*e.records.length),this.geometry=[Ae(n,e.nodes,void 0,"the asset's hierarchy"),Ae(n,e.primitives,void 0,"the asset's geometry"),Ae(n,i,void 0,"the asset's geometry"),Ae(n,r,void 0,"the asset's textures")],this.where=e.where,this.sceneWords=[e.places.length/4,e.recordCount,e.records.length,t.length],this.epsilon=e.epsilon,this.firsts=e.parts.map(({first:f})=>f),this.raySources=ts({hasSegments:e.strands>0,hasTextures:e.recordCount>0});let{hit:o,light:a}=this.raySources,[l,c,,...u]=await Promise.all([this.pipelines.get(o,"trace_pixels"),this.pipelines.get(a,"light_pixels"),this.compiled,...t.map(f=>this._makePart(f))]);this.parts=u,this.kernels={hit:l,light:c,...this.queueKernels},this._bind()}async _makePart(e){let{device:t,pipelines:n}=this,i=[0,1,2].map(a=>Ae(t,Dc(e.planes,a),void 0,"a plane of features")),r=(a,l)=>is.make(t,n,e,a,l,i),o=await r(e.transport,e.inputs);return{planes:i,transport:o,emission:e.emission&&await r(e.emission,e.emission.inputs)}}get emits(){return this.parts.some(({emission:e})=>e)}setEnvironment({values:e,marginal:t,width:n,height:i}){let{device:r}=this,o=(a,l,c,u,f)=>{let d=r.createTexture({size:[a,l],format:c,usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST});return r.queue.writeTexture({texture:d},u,{bytesPerRow:f*a,rowsPerImage:l},[a,l]),d};this.images?.forEach(a=>a.destroy()),this.images=[o(n,i,"rgba32float",e,16),o(t.length,1,"r32float",t,4)],this._bind()}resize(e,t){if(this.target?.width===e&&this.target.height===t)return;let n=e*t;(!this.sums||n>this.capacity||n*8<this.capacity)&&(this.sums?.destroy(),this.sums=Ae(this.device,16*n,void 0,"the picture"),this.capacity=n,this._bind()),this.target={width:e,height:t}}_bind(){if(!this.geometry||!this.sums||!this.images||!this.kernels)return;let{device:e,kernels:t,band:n,queue:i}=this,{rows:r,through:o,lit:a}=n,l=[this.view,...this.geometry],c=(f,d,p)=>e.createBindGroup({layout:f.getBindGroupLayout(d),entries:p.map(([_,v])=>({binding:_,resource:v instanceof GPUBuffer?{buffer:v}:v}))}),u=l.map((f,d)=>[d,f]);this.groups={hit:[c(t.hit,0,u),c(t.hit,1,[[0,r],[1,o]])],light:[c(t.light,0,u),c(t.light,1,[[0,r],[1,o],[2,a],[3,this.sums]]),c(t.light,2,[[0,this.lightRecord],[1,this.images[0].createView()],[2,this.images[1].createView()]])],queue:[e.createBindGroup({layout:this.queueLayout,entries:[this.queueRecord,r,o,a,this.sums,i.rows,i.answers,i.count].map((f,d)=>({binding:d,resource:{buffer:f}}))})],show:Ni(e,this.shown,0,[this.showRecord,this.sums])}}trace(e,t,n,i){this.span={from:n,rows:i-n,pixels:(i-n)*this.target.width},this._writeView(e,t),this._run(r=>Mt(r,this.kernels.hit,this.groups.hit,this.span.pixels))}light(e,{isFirst:t,countsCoverage:n}){this._writeLight(e,t,n),this._run(i=>Mt(i,this.kernels.light,this.groups.light,this.span.pixels)),this._decode("transport")}emission(){this._decode("emission")}show({rounds:e,exposure:t,backdrop:n,filmic:i,spread:r}){let{width:o,height:a}=this.target,{canvas:l,device:c}=this,u=Float32Array.of(l.width,l.height,o,a,...n,e,t,Number(i),r,0);c.queue.writeBuffer(this.showRecord,0,u);let f=c.createCommandEncoder(),d=this.context.getCurrentTexture().createView(),p=f.beginRenderPass({colorAttachments:[{view:d,loadOp:"clear",storeOp:"store"}]});p.setPipeline(this.shown),p.setBindGroup(0,this.groups.show),p.draw(3),p.end(),c.queue.submit([f.finish()])}async done(){if(await this.device.queue.onSubmittedWorkDone(),this.error)throw this.error}async picture(){let{width:e,height:t}=this.target;return new Float32Array(await ni(this.device,this.sums,16*e*t))}_decode(e){let{device:t,span:n,target:i}=this;for(let[r,o]of this.parts.entries()){let a=o[e];if(!a)continue;let l=Uint32Array.of(i.width,n.from,n.rows,r+1,+(e==="emission"),0,0,0);t.queue.writeBuffer(this.queueRecord,0,l),t.queue.writeBuffer(this.queue.count,0,Uint32Array.of(0)),this._run(c=>{Mt(c,this.kernels.gather,this.groups.queue,n.pixels),a.run(c,this.queue,n.pixels),Mt(c,this.kernels.scatter,this.groups.queue,n.pixels)})}}_run(e){let t=this.device.createCommandEncoder(),n=t.beginComputePass();e(n),n.end(),this.device.queue.submit([t.finish()])}_writeView({position:e,corner:t,stepX:n,stepY:i,jitter:r=1},o){let a=new ArrayBuffer(176),l=new Float32Array(a),c=new Uint32Array(a);l.set([...e,this.epsilon],0),l.set(t,4),c[7]=this.target.width,l.set(n,8),c[11]=this.span.from,l.set(i,12),c[15]=this.span.rows;let[u,f,d,p]=this.sceneWords;c.set([o,u,f,d,p],16),l[21]=r,c.set(this.firsts,24),this.device.queue.writeBuffer(this.view,0,a)}_writeLight({kind:e,direction:t=[0,1,0],colour:n,angle:i=0,ground:r},o,a){let l=new ArrayBuffer(96),c=new Float32Array(l),u=new Uint32Array(l);c.set(t,0),u[3]=v0[e],c.set([...n,r?.height??0,Math.cos(i),Math.sin(i),r?.x??0,r?.z??0],4),c.set([...r?.colour??[0,0,0],r?.size??0],12),u.set([Number(o),Number(a)],16),this.device.queue.writeBuffer(this.lightRecord,0,l)}_deleteAsset(){this.geometry?.forEach(e=>e.destroy());for(let{planes:e,transport:t,emission:n}of this.parts)e.forEach(i=>i.destroy()),t.delete(),n?.delete();this.parts=[],this.geometry=null}close(){this.closed=!0,this._deleteAsset(),this.device.destroy()}};var x0={webgpu:rs,webgl2:jr};async function sh(s,e){let t=[];for(let[n,i]of Object.entries(x0))if(!(e&&e!==n))try{let r=s();return{engine:await i.open(r),canvas:r,reasons:t}}catch(r){t.push(r.message)}throw new ee(`this browser shows the poster alone: ${t.join("; ")||`no engine ${e}`}`)}var oh=[1024,512];function ah({rgb:s,width:e,height:t}){({rgb:s,width:e,height:t}=w0({rgb:s,width:e,height:t}));let i=new Float32Array(4*e*t),r=new Float32Array(t+2),o=[0,0,0],a=0,l=1e-4*y0(s)+1e-20;for(let c=0;c<t;c++){let u=Math.PI*(c+.5)/t,f=2*Math.PI**2*Math.sin(u)/(e*t),d=0;for(let p=0;p<e;p++){let _=c*e+p;for(let v=0;v<3;v++)i[4*_+v]=s[3*_+v],o[v]+=s[3*_+v]*f*Math.max(0,Math.cos(u));d+=Math.max(l,.2126*s[3*_]+.7152*s[3*_+1]+.0722*s[3*_+2]),i[4*_+3]=d}for(let p=0;p<e;p++)i[4*(c*e+p)+3]/=d;a+=d*Math.sin(u),r[c]=a}for(let c=0;c<t;c++)r[c]/=a;return r.set([1/a,l],t),{values:i,marginal:r,width:e,height:t,up:o}}function y0(s){let e=0;for(let t=0;t<s.length;t++)e+=s[t];return e/s.length}function w0({rgb:s,width:e,height:t}){let n=Math.max(1,Math.ceil(e/oh[0]),Math.ceil(t/oh[1]));if(n===1)return{rgb:s,width:e,height:t};let i=Math.ceil(e/n),r=Math.ceil(t/n),o=new Float32Array(3*i*r);for(let a=0;a<r;a++)for(let l=0;l<i;l++){let c=0;for(let u=a*n;u<Math.min(t,(a+1)*n);u++)for(let f=l*n;f<Math.min(e,(l+1)*n);f++,c++)for(let d=0;d<3;d++)o[3*(a*i+l)+d]+=s[3*(u*e+f)+d];for(let u=0;u<3;u++)o[3*(a*i+l)+u]/=c}return{rgb:o,width:i,height:r}}function ss(s){return{rgb:Float32Array.from({length:96},(n,i)=>s[i%3]),width:8,height:4}}function lh(){let t=new Float32Array(24576),n=[[[-.7,.6,.5],.93,[2.4,2.5,2.7]],[[.8,.5,-.35],.95,[3.2,3,2.7]]];for(let i=0;i<64;i++){let r=Math.PI*(i+.5)/64;for(let o=0;o<128;o++){let a=2*Math.PI*((o+.5)/128-.5),l=[Math.sin(r)*Math.sin(a),Math.cos(r),-Math.sin(r)*Math.cos(a)],c=.16+.14*Math.max(0,l[1]);for(let u=0;u<3;u++){let f=c*[.95,1,1.08][u];for(let[d,p,_]of n){let v=(l[0]*d[0]+l[1]*d[1]+l[2]*d[2])/Math.hypot(...d);f+=_[u]*Math.min(1,Math.max(0,(v-p)/.03))}t[3*(i*128+o)+u]=f}}}return{rgb:t,width:128,height:64}}var rt=Uint8Array,ri=Uint16Array,b0=Int32Array,ch=new rt([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),hh=new rt([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),S0=new rt([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),uh=function(s,e){for(var t=new ri(31),n=0;n<31;++n)t[n]=e+=1<<s[n-1];for(var i=new b0(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)i[r]=r-t[n]<<5|n;return{b:t,r:i}},fh=uh(ch,2),dh=fh.b,M0=fh.r;dh[28]=258,M0[258]=28;var ph=uh(hh,0),A0=ph.b,UT=ph.r,na=new ri(32768);for(de=0;de<32768;++de)zt=(de&43690)>>1|(de&21845)<<1,zt=(zt&52428)>>2|(zt&13107)<<2,zt=(zt&61680)>>4|(zt&3855)<<4,na[de]=((zt&65280)>>8|(zt&255)<<8)>>1;var zt,de,zi=(function(s,e,t){for(var n=s.length,i=0,r=new ri(e);i<n;++i)s[i]&&++r[s[i]-1];var o=new ri(e);for(i=1;i<e;++i)o[i]=o[i-1]+r[i-1]<<1;var a;if(t){a=new ri(1<<e);var l=15-e;for(i=0;i<n;++i)if(s[i])for(var c=i<<4|s[i],u=e-s[i],f=o[s[i]-1]++<<u,d=f|(1<<u)-1;f<=d;++f)a[na[f]>>l]=c}else for(a=new ri(n),i=0;i<n;++i)s[i]&&(a[i]=na[o[s[i]-1]++]>>15-s[i]);return a}),ki=new rt(288);for(de=0;de<144;++de)ki[de]=8;var de;for(de=144;de<256;++de)ki[de]=9;var de;for(de=256;de<280;++de)ki[de]=7;var de;for(de=280;de<288;++de)ki[de]=8;var de,mh=new rt(32);for(de=0;de<32;++de)mh[de]=5;var de;var E0=zi(ki,9,1);var T0=zi(mh,5,1),ea=function(s){for(var e=s[0],t=1;t<s.length;++t)s[t]>e&&(e=s[t]);return e},pt=function(s,e,t){var n=e/8|0;return(s[n]|s[n+1]<<8)>>(e&7)&t},ta=function(s,e){var t=e/8|0;return(s[t]|s[t+1]<<8|s[t+2]<<16)>>(e&7)},R0=function(s){return(s+7)/8|0},C0=function(s,e,t){return(e==null||e<0)&&(e=0),(t==null||t>s.length)&&(t=s.length),new rt(s.subarray(e,t))};var I0=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],mt=function(s,e,t){var n=new Error(e||I0[s]);if(n.code=s,Error.captureStackTrace&&Error.captureStackTrace(n,mt),!t)throw n;return n},P0=function(s,e,t,n){var i=s.length,r=n?n.length:0;if(!i||e.f&&!e.l)return t||new rt(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new rt(i*3));var c=function(Vi){var Wi=t.length;if(Vi>Wi){var li=new rt(Math.max(Wi*2,Vi));li.set(t),t=li}},u=e.f||0,f=e.p||0,d=e.b||0,p=e.l,_=e.d,v=e.m,S=e.n,M=i*8;do{if(!p){u=pt(s,f,1);var A=pt(s,f+1,3);if(f+=3,A)if(A==1)p=E0,_=T0,v=9,S=5;else if(A==2){var Y=pt(s,f,31)+257,G=pt(s,f+10,15)+4,Q=Y+pt(s,f+5,31)+1;f+=14;for(var k=new rt(Q),Z=new rt(19),X=0;X<G;++X)Z[S0[X]]=pt(s,f+X*3,7);f+=G*3;for(var V=ea(Z),oe=(1<<V)-1,ne=zi(Z,V,1),X=0;X<Q;){var te=ne[pt(s,f,oe)];f+=te&15;var P=te>>4;if(P<16)k[X++]=P;else{var pe=0,Ue=0;for(P==16?(Ue=3+pt(s,f,3),f+=2,pe=k[X-1]):P==17?(Ue=3+pt(s,f,7),f+=3):P==18&&(Ue=11+pt(s,f,127),f+=7);Ue--;)k[X++]=pe}}var Ke=k.subarray(0,Y),Ee=k.subarray(Y);v=ea(Ke),S=ea(Ee),p=zi(Ke,v,1),_=zi(Ee,S,1)}else mt(1);else{var P=R0(f)+4,L=s[P-4]|s[P-3]<<8,D=P+L;if(D>i){l&&mt(0);break}a&&c(d+L),t.set(s.subarray(P,D),d),e.b=d+=L,e.p=f=D*8,e.f=u;continue}if(f>M){l&&mt(0);break}}a&&c(d+131072);for(var Et=(1<<v)-1,kt=(1<<S)-1,Je=f;;Je=f){var pe=p[ta(s,f)&Et],gt=pe>>4;if(f+=pe&15,f>M){l&&mt(0);break}if(pe||mt(2),gt<256)t[d++]=gt;else if(gt==256){Je=f,p=null;break}else{var ot=gt-254;if(gt>264){var X=gt-257,Tt=ch[X];ot=pt(s,f,(1<<Tt)-1)+dh[X],f+=Tt}var an=_[ta(s,f)&kt],bn=an>>4;an||mt(3),f+=an&15;var Ee=A0[bn];if(bn>3){var Tt=hh[bn];Ee+=ta(s,f)&(1<<Tt)-1,f+=Tt}if(f>M){l&&mt(0);break}a&&c(d+131072);var ge=d+ot;if(d<Ee){var Rt=r-Ee,Gt=Math.min(Ee,ge);for(Rt+d<0&&mt(3);d<Gt;++d)t[d]=n[Rt+d]}for(;d<ge;++d)t[d]=t[d-Ee]}}e.l=p,e.p=Je,e.b=d,e.f=u,p&&(u=1,e.m=v,e.d=_,e.n=S)}while(!u);return d!=t.length&&o?C0(t,0,d):t.subarray(0,d)};var N0=new rt(0);var L0=function(s,e){return((s[0]&15)!=8||s[0]>>4>7||(s[0]<<8|s[1])%31)&&mt(6,"invalid zlib data"),(s[1]>>5&1)==+!e&&mt(6,"invalid zlib data: "+(s[1]&32?"need":"unexpected")+" dictionary"),(s[1]>>3&4)+2};function si(s,e){return P0(s.subarray(L0(s,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var D0=typeof TextDecoder<"u"&&new TextDecoder,O0=0;try{D0.decode(N0,{stream:!0}),O0=1}catch{}var os=class extends Si{constructor(e){super(e),this.type=mn,this.outputFormat=xt,this.part=0}parse(e){let k=Math.pow(2.7182818,2.2),Z=null,X=null;function V(h,m){let g=0;for(let b=0;b<65536;++b)(b==0||h[b>>3]&1<<(b&7))&&(m[g++]=b);let y=g-1;for(;g<65536;)m[g++]=0;return y}function oe(h){for(let m=0;m<16384;m++)h[m]={},h[m].len=0,h[m].lit=0,h[m].p=null}let ne={l:0,c:0,lc:0};function te(h,m,g,y,b){for(;g<h;)m=m<<8|ga(y,b),g+=8;g-=h,ne.l=m>>g&(1<<h)-1,ne.c=m,ne.lc=g}let pe=new Array(59);function Ue(h){for(let g=0;g<=58;++g)pe[g]=0;for(let g=0;g<65537;++g)pe[h[g]]+=1;let m=0;for(let g=58;g>0;--g){let y=m+pe[g]>>1;pe[g]=m,m=y}for(let g=0;g<65537;++g){let y=h[g];y>0&&(h[g]=y|pe[y]++<<6)}}function Ke(h,m,g,y,b,T){let x=m,C=0,E=0;for(;y<=b;y++){if(x.value-m.value>g)return!1;te(6,C,E,h,x);let R=ne.l;if(C=ne.c,E=ne.lc,T[y]=R,R==63){if(x.value-m.value>g)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");te(8,C,E,h,x);let I=ne.l+6;if(C=ne.c,E=ne.lc,y+I>b+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;I--;)T[y++]=0;y--}else if(R>=59){let I=R-59+2;if(y+I>b+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;I--;)T[y++]=0;y--}}Ue(T)}function Ee(h){return h&63}function Et(h){return h>>6}function kt(h,m,g,y){for(;m<=g;m++){let b=Et(h[m]),T=Ee(h[m]);if(b>>T)throw new Error("THREE.EXRLoader: Invalid table entry");if(T>14){let x=y[b>>T-14];if(x.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(x.lit++,x.p){let C=x.p;x.p=new Array(x.lit);for(let E=0;E<x.lit-1;++E)x.p[E]=C[E]}else x.p=new Array(1);x.p[x.lit-1]=m}else if(T){let x=0;for(let C=1<<14-T;C>0;C--){let E=y[(b<<14-T)+x];if(E.len||E.p)throw new Error("THREE.EXRLoader: Invalid table entry");E.len=T,E.lit=m,x++}}}return!0}let Je={c:0,lc:0};function gt(h,m,g,y){h=h<<8|ga(g,y),m+=8,Je.c=h,Je.lc=m}let ot={c:0,lc:0};function Tt(h,m,g,y,b,T,x,C,E){if(h==m){y<8&&(gt(g,y,b,T),g=Je.c,y=Je.lc),y-=8;let R=g>>y;if(R=new Uint8Array([R])[0],C.value+R>E)return!1;let I=x[C.value-1];for(;R-- >0;)x[C.value++]=I}else if(C.value<E)x[C.value++]=h;else return!1;ot.c=g,ot.lc=y}function an(h){return h&65535}function bn(h){let m=an(h);return m>32767?m-65536:m}let ge={a:0,b:0};function Rt(h,m){let g=bn(h),b=bn(m),T=g+(b&1)+(b>>1),x=T,C=T-b;ge.a=x,ge.b=C}function Gt(h,m){let g=an(h),y=an(m),b=g-(y>>1)&65535,T=y+b-32768&65535;ge.a=T,ge.b=b}function Vi(h,m,g,y,b,T,x){let C=x<16384,E=g>b?b:g,R=1,I,O;for(;R<=E;)R<<=1;for(R>>=1,I=R,R>>=1;R>=1;){O=0;let N=O+T*(b-I),B=T*R,q=T*I,U=y*R,H=y*I,j,ae,ie,ue;for(;O<=N;O+=q){let K=O,$=O+y*(g-I);for(;K<=$;K+=H){let J=K+U,me=K+B,fe=me+U;C?(Rt(h[K+m],h[me+m]),j=ge.a,ie=ge.b,Rt(h[J+m],h[fe+m]),ae=ge.a,ue=ge.b,Rt(j,ae),h[K+m]=ge.a,h[J+m]=ge.b,Rt(ie,ue),h[me+m]=ge.a,h[fe+m]=ge.b):(Gt(h[K+m],h[me+m]),j=ge.a,ie=ge.b,Gt(h[J+m],h[fe+m]),ae=ge.a,ue=ge.b,Gt(j,ae),h[K+m]=ge.a,h[J+m]=ge.b,Gt(ie,ue),h[me+m]=ge.a,h[fe+m]=ge.b)}if(g&R){let J=K+B;C?Rt(h[K+m],h[J+m]):Gt(h[K+m],h[J+m]),j=ge.a,h[J+m]=ge.b,h[K+m]=j}}if(b&R){let K=O,$=O+y*(g-I);for(;K<=$;K+=H){let J=K+U;C?Rt(h[K+m],h[J+m]):Gt(h[K+m],h[J+m]),j=ge.a,h[J+m]=ge.b,h[K+m]=j}}I=R,R>>=1}return O}function Wi(h,m,g,y,b,T,x,C,E){let R=0,I=0,O=x,N=Math.trunc(y.value+(b+7)/8);for(;y.value<N;)for(gt(R,I,g,y),R=Je.c,I=Je.lc;I>=14;){let q=R>>I-14&16383,U=m[q];if(U.len)I-=U.len,Tt(U.lit,T,R,I,g,y,C,E,O),R=ot.c,I=ot.lc;else{if(!U.p)throw new Error("THREE.EXRLoader: hufDecode issues");let H;for(H=0;H<U.lit;H++){let j=Ee(h[U.p[H]]);for(;I<j&&y.value<N;)gt(R,I,g,y),R=Je.c,I=Je.lc;if(I>=j&&Et(h[U.p[H]])==(R>>I-j&(1<<j)-1)){I-=j,Tt(U.p[H],T,R,I,g,y,C,E,O),R=ot.c,I=ot.lc;break}}if(H==U.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let B=8-b&7;for(R>>=B,I-=B;I>0;){let q=m[R<<14-I&16383];if(q.len)I-=q.len,Tt(q.lit,T,R,I,g,y,C,E,O),R=ot.c,I=ot.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function li(h,m,g,y,b,T){let x={value:0},C=g.value,E=Ve(m,g),R=Ve(m,g);g.value+=4;let I=Ve(m,g);if(g.value+=4,E<0||E>=65537||R<0||R>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let O=new Array(65537),N=new Array(16384);oe(N);let B=y-(g.value-C);if(Ke(h,g,B,E,R,O),I>8*(y-(g.value-C)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");kt(O,E,R,N),Wi(O,N,h,g,I,R,T,b,x)}function Lh(h,m,g){for(let y=0;y<g;++y)m[y]=h[m[y]]}function Xi(h){for(let m=1;m<h.length;m++){let g=h[m-1]+h[m]-128;h[m]=g}}function qi(h,m){let g=0,y=Math.floor((h.length+1)/2),b=0,T=h.length-1;for(;!(b>T||(m[b++]=h[g++],b>T));)m[b++]=h[y++]}function xs(h){let m=h.byteLength,g=new Array,y=0,b=new DataView(h);for(;m>0;){let T=b.getInt8(y++);if(T<0){let x=-T;m-=x+1;for(let C=0;C<x;C++)g.push(b.getUint8(y++))}else{let x=T;m-=2;let C=b.getUint8(y++);for(let E=0;E<x+1;E++)g.push(C)}}return g}function Dh(h,m,g,y,b,T){let x=new DataView(T.buffer),C=g[h.idx[0]].width,E=g[h.idx[0]].height,R=3,I=Math.floor(C/8),O=Math.ceil(C/8),N=Math.ceil(E/8),B=C-(O-1)*8,q=E-(N-1)*8,U={value:0},H=new Array(R),j=new Array(R),ae=new Array(R),ie=new Array(R),ue=new Array(R);for(let $=0;$<R;++$)ue[$]=m[h.idx[$]],H[$]=$<1?0:H[$-1]+O*N,j[$]=new Float32Array(64),ae[$]=new Uint16Array(64),ie[$]=new Uint16Array(O*64);for(let $=0;$<N;++$){let J=8;$==N-1&&(J=q);let me=8;for(let re=0;re<O;++re){re==O-1&&(me=B);for(let le=0;le<R;++le)ae[le].fill(0),ae[le][0]=b[H[le]++],ca(U,y,ae[le]),ha(ae[le],j[le]),ua(j[le]);R==3&&Uh(j);for(let le=0;le<R;++le)pa(j[le],ie[le],re*64)}let fe=0;for(let re=0;re<R;++re){let le=g[h.idx[re]].type;for(let we=8*$;we<8*$+J;++we){fe=ue[re][we];for(let We=0;We<I;++We){let _e=We*64+(we&7)*8;x.setUint16(fe+0*le,ie[re][_e+0],!0),x.setUint16(fe+2*le,ie[re][_e+1],!0),x.setUint16(fe+4*le,ie[re][_e+2],!0),x.setUint16(fe+6*le,ie[re][_e+3],!0),x.setUint16(fe+8*le,ie[re][_e+4],!0),x.setUint16(fe+10*le,ie[re][_e+5],!0),x.setUint16(fe+12*le,ie[re][_e+6],!0),x.setUint16(fe+14*le,ie[re][_e+7],!0),fe+=16*le}}if(I!=O)for(let we=8*$;we<8*$+J;++we){let We=ue[re][we]+8*I*2*le,_e=I*64+(we&7)*8;for(let _t=0;_t<me;++_t)x.setUint16(We+_t*2*le,ie[re][_e+_t],!0)}}}let K=new Uint16Array(C);x=new DataView(T.buffer);for(let $=0;$<R;++$){g[h.idx[$]].decoded=!0;let J=g[h.idx[$]].type;if(g[$].type==2)for(let me=0;me<E;++me){let fe=ue[$][me];for(let re=0;re<C;++re)K[re]=x.getUint16(fe+re*2*J,!0);for(let re=0;re<C;++re)x.setFloat32(fe+re*2*J,F.fromHalfFloat(K[re]),!0)}}}function Oh(h,m,g,y,b,T){let x=new DataView(T.buffer),C=g[h],E=C.width,R=C.height,I=Math.ceil(E/8),O=Math.ceil(R/8),N=Math.floor(E/8),B=E-(I-1)*8,q=R-(O-1)*8,U={value:0},H=0,j=new Float32Array(64),ae=new Uint16Array(64),ie=new Uint16Array(I*64);for(let ue=0;ue<O;++ue){let K=8;ue==O-1&&(K=q);for(let $=0;$<I;++$)ae.fill(0),ae[0]=b[H++],ca(U,y,ae),ha(ae,j),ua(j),pa(j,ie,$*64);for(let $=8*ue;$<8*ue+K;++$){let J=m[h][$];for(let me=0;me<N;++me){let fe=me*64+($&7)*8;for(let re=0;re<8;++re)x.setUint16(J+re*2*C.type,ie[fe+re],!0);J+=16*C.type}if(I!=N){let me=N*64+($&7)*8;for(let fe=0;fe<B;++fe)x.setUint16(J+fe*2*C.type,ie[me+fe],!0)}}}C.decoded=!0}function ca(h,m,g){let y,b=1;for(;b<64;)y=m[h.value],y==65280?b=64:y>>8==255?b+=y&255:(g[b]=y,b++),h.value++}function ha(h,m){m[0]=F.fromHalfFloat(h[0]),m[1]=F.fromHalfFloat(h[1]),m[2]=F.fromHalfFloat(h[5]),m[3]=F.fromHalfFloat(h[6]),m[4]=F.fromHalfFloat(h[14]),m[5]=F.fromHalfFloat(h[15]),m[6]=F.fromHalfFloat(h[27]),m[7]=F.fromHalfFloat(h[28]),m[8]=F.fromHalfFloat(h[2]),m[9]=F.fromHalfFloat(h[4]),m[10]=F.fromHalfFloat(h[7]),m[11]=F.fromHalfFloat(h[13]),m[12]=F.fromHalfFloat(h[16]),m[13]=F.fromHalfFloat(h[26]),m[14]=F.fromHalfFloat(h[29]),m[15]=F.fromHalfFloat(h[42]),m[16]=F.fromHalfFloat(h[3]),m[17]=F.fromHalfFloat(h[8]),m[18]=F.fromHalfFloat(h[12]),m[19]=F.fromHalfFloat(h[17]),m[20]=F.fromHalfFloat(h[25]),m[21]=F.fromHalfFloat(h[30]),m[22]=F.fromHalfFloat(h[41]),m[23]=F.fromHalfFloat(h[43]),m[24]=F.fromHalfFloat(h[9]),m[25]=F.fromHalfFloat(h[11]),m[26]=F.fromHalfFloat(h[18]),m[27]=F.fromHalfFloat(h[24]),m[28]=F.fromHalfFloat(h[31]),m[29]=F.fromHalfFloat(h[40]),m[30]=F.fromHalfFloat(h[44]),m[31]=F.fromHalfFloat(h[53]),m[32]=F.fromHalfFloat(h[10]),m[33]=F.fromHalfFloat(h[19]),m[34]=F.fromHalfFloat(h[23]),m[35]=F.fromHalfFloat(h[32]),m[36]=F.fromHalfFloat(h[39]),m[37]=F.fromHalfFloat(h[45]),m[38]=F.fromHalfFloat(h[52]),m[39]=F.fromHalfFloat(h[54]),m[40]=F.fromHalfFloat(h[20]),m[41]=F.fromHalfFloat(h[22]),m[42]=F.fromHalfFloat(h[33]),m[43]=F.fromHalfFloat(h[38]),m[44]=F.fromHalfFloat(h[46]),m[45]=F.fromHalfFloat(h[51]),m[46]=F.fromHalfFloat(h[55]),m[47]=F.fromHalfFloat(h[60]),m[48]=F.fromHalfFloat(h[21]),m[49]=F.fromHalfFloat(h[34]),m[50]=F.fromHalfFloat(h[37]),m[51]=F.fromHalfFloat(h[47]),m[52]=F.fromHalfFloat(h[50]),m[53]=F.fromHalfFloat(h[56]),m[54]=F.fromHalfFloat(h[59]),m[55]=F.fromHalfFloat(h[61]),m[56]=F.fromHalfFloat(h[35]),m[57]=F.fromHalfFloat(h[36]),m[58]=F.fromHalfFloat(h[48]),m[59]=F.fromHalfFloat(h[49]),m[60]=F.fromHalfFloat(h[57]),m[61]=F.fromHalfFloat(h[58]),m[62]=F.fromHalfFloat(h[62]),m[63]=F.fromHalfFloat(h[63])}function ua(h){let m=.5*Math.cos(.7853975),g=.5*Math.cos(3.14159/16),y=.5*Math.cos(3.14159/8),b=.5*Math.cos(3*3.14159/16),T=.5*Math.cos(5*3.14159/16),x=.5*Math.cos(3*3.14159/8),C=.5*Math.cos(7*3.14159/16),E=new Array(4),R=new Array(4),I=new Array(4),O=new Array(4);for(let N=0;N<8;++N){let B=N*8;E[0]=y*h[B+2],E[1]=x*h[B+2],E[2]=y*h[B+6],E[3]=x*h[B+6],R[0]=g*h[B+1]+b*h[B+3]+T*h[B+5]+C*h[B+7],R[1]=b*h[B+1]-C*h[B+3]-g*h[B+5]-T*h[B+7],R[2]=T*h[B+1]-g*h[B+3]+C*h[B+5]+b*h[B+7],R[3]=C*h[B+1]-T*h[B+3]+b*h[B+5]-g*h[B+7],I[0]=m*(h[B+0]+h[B+4]),I[3]=m*(h[B+0]-h[B+4]),I[1]=E[0]+E[3],I[2]=E[1]-E[2],O[0]=I[0]+I[1],O[1]=I[3]+I[2],O[2]=I[3]-I[2],O[3]=I[0]-I[1],h[B+0]=O[0]+R[0],h[B+1]=O[1]+R[1],h[B+2]=O[2]+R[2],h[B+3]=O[3]+R[3],h[B+4]=O[3]-R[3],h[B+5]=O[2]-R[2],h[B+6]=O[1]-R[1],h[B+7]=O[0]-R[0]}for(let N=0;N<8;++N)E[0]=y*h[16+N],E[1]=x*h[16+N],E[2]=y*h[48+N],E[3]=x*h[48+N],R[0]=g*h[8+N]+b*h[24+N]+T*h[40+N]+C*h[56+N],R[1]=b*h[8+N]-C*h[24+N]-g*h[40+N]-T*h[56+N],R[2]=T*h[8+N]-g*h[24+N]+C*h[40+N]+b*h[56+N],R[3]=C*h[8+N]-T*h[24+N]+b*h[40+N]-g*h[56+N],I[0]=m*(h[N]+h[32+N]),I[3]=m*(h[N]-h[32+N]),I[1]=E[0]+E[3],I[2]=E[1]-E[2],O[0]=I[0]+I[1],O[1]=I[3]+I[2],O[2]=I[3]-I[2],O[3]=I[0]-I[1],h[0+N]=O[0]+R[0],h[8+N]=O[1]+R[1],h[16+N]=O[2]+R[2],h[24+N]=O[3]+R[3],h[32+N]=O[3]-R[3],h[40+N]=O[2]-R[2],h[48+N]=O[1]-R[1],h[56+N]=O[0]-R[0]}function Uh(h){for(let m=0;m<64;++m){let g=h[0][m],y=h[1][m],b=h[2][m];h[0][m]=g+1.5747*b,h[1][m]=g-.1873*y-.4682*b,h[2][m]=g+1.8556*y}}let ys=new Float32Array(1),fa=new Uint32Array(ys.buffer);function da(h){ys[0]=h;let m=fa[0],g=m>>>16&32768,y=m&2147483647;if(y>=1199570944)return g|(y>2139095040?32256:31744);if(y<947912704)return ys[0]=Math.abs(h)+.5,g|fa[0]-1056964608;let b=y+4095+(y>>>13&1);return g|b-939524096>>>13}function pa(h,m,g){if(X===null){X=new Uint16Array(65536);for(let y=1;y<65536;++y){if((y&31744)===31744)continue;let b=F.fromHalfFloat(y),T=Math.abs(b),x=T<=1?Math.pow(T,2.2):Math.pow(k,T-1);X[y]=da(b<0?-x:x)}}for(let y=0;y<64;++y)m[g+y]=X[da(h[y])]}function $i(h){return new DataView(h.array.buffer,h.offset.value,h.size)}function Fh(h){let m=h.viewer.buffer.slice(h.offset.value,h.offset.value+h.size),g=new Uint8Array(xs(m)),y=new Uint8Array(g.length);return Xi(g),qi(g,y),new DataView(y.buffer)}function ws(h){let m=h.array.slice(h.offset.value,h.offset.value+h.size),g=si(m),y=new Uint8Array(g.length);return Xi(g),qi(g,y),new DataView(y.buffer)}function Bh(h){let m=h.viewer,g={value:h.offset.value},y=new Uint16Array(h.columns*h.lines*(h.inputChannels.length*h.type)),b=new Uint8Array(8192),T=0,x=new Array(h.inputChannels.length);for(let q=0,U=h.inputChannels.length;q<U;q++)x[q]={},x[q].start=T,x[q].end=x[q].start,x[q].nx=h.columns,x[q].ny=h.lines,x[q].size=h.type,T+=x[q].nx*x[q].ny*x[q].size;let C=ci(m,g),E=ci(m,g);if(E>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(C<=E)for(let q=0;q<E-C+1;q++)b[q+C]=Ht(m,g);let R=new Uint16Array(65536),I=V(b,R),O=Ve(m,g);li(h.array,m,g,O,y,T);for(let q=0;q<h.inputChannels.length;++q){let U=x[q];for(let H=0;H<x[q].size;++H)Vi(y,U.start+H,U.nx,U.size,U.ny,U.nx*U.size,I)}Lh(R,y,T);let N=0,B=new Uint8Array(y.buffer.byteLength);for(let q=0;q<h.lines;q++)for(let U=0;U<h.inputChannels.length;U++){let H=x[U],j=H.nx*H.size,ae=new Uint8Array(y.buffer,H.end*2,j*2);B.set(ae,N),N+=j*2,H.end+=j}return new DataView(B.buffer)}function zh(h){let m=h.array.slice(h.offset.value,h.offset.value+h.size),g=si(m),y=h.inputChannels.length*h.lines*h.columns*h.totalBytes,b=new ArrayBuffer(y),T=new DataView(b),x=0,C=0,E=new Array(4);for(let R=0;R<h.lines;R++)for(let I=0;I<h.inputChannels.length;I++){let O=0;switch(h.inputChannels[I].pixelType){case 1:E[0]=x,E[1]=E[0]+h.columns,x=E[1]+h.columns;for(let B=0;B<h.columns;++B){let q=g[E[0]++]<<8|g[E[1]++];O+=q,T.setUint16(C,O,!0),C+=2}break;case 2:E[0]=x,E[1]=E[0]+h.columns,E[2]=E[1]+h.columns,x=E[2]+h.columns;for(let B=0;B<h.columns;++B){let q=g[E[0]++]<<24|g[E[1]++]<<16|g[E[2]++]<<8;O+=q,T.setUint32(C,O,!0),C+=4}break}}return T}function kh(h){let m=h.array,g=h.offset.value,y=h.columns,b=h.lines,T=h.inputChannels,x=h.totalBytes,C=Ne.compression==="B44A_COMPRESSION",E=new Uint8Array(b*y*x),R=new Uint16Array(16),I=0;for(let O=0;O<T.length;O++){let N=T[O],B=N.pixelType*2,q=Math.ceil(y/N.xSampling),U=Math.ceil(b/N.ySampling),H=N.xSampling===1&&N.ySampling===1;if(N.pixelType!==1){for(let ie=0;ie<U;ie++)if(H){let ue=ie*y*x+I*y;for(let K=0;K<q*B;K++)E[ue+K]=m[g++]}else g+=q*B;I+=B;continue}let j=Math.ceil(q/4),ae=Math.ceil(U/4);for(let ie=0;ie<ae;ie++)for(let ue=0;ue<j;ue++){if(C&&m[g+2]>=52){let K=m[g]<<8|m[g+1],$=K&32768?K&32767:~K&65535;R.fill($),g+=3}else{let K=m[g]<<8|m[g+1],$=m[g+2]>>2,J=32<<$,me=K+((m[g+2]<<4|m[g+3]>>4)&63)*(1<<$)-J&65535,fe=me+((m[g+3]<<2|m[g+4]>>6)&63)*(1<<$)-J&65535,re=fe+(m[g+4]&63)*(1<<$)-J&65535,le=K+(m[g+5]>>2&63)*(1<<$)-J&65535,we=me+((m[g+5]<<4|m[g+6]>>4)&63)*(1<<$)-J&65535,We=fe+((m[g+6]<<2|m[g+7]>>6)&63)*(1<<$)-J&65535,_e=re+(m[g+7]&63)*(1<<$)-J&65535,_t=le+(m[g+8]>>2&63)*(1<<$)-J&65535,Sn=we+((m[g+8]<<4|m[g+9]>>4)&63)*(1<<$)-J&65535,hi=We+((m[g+9]<<2|m[g+10]>>6)&63)*(1<<$)-J&65535,vt=_e+(m[g+10]&63)*(1<<$)-J&65535,ln=_t+(m[g+11]>>2&63)*(1<<$)-J&65535,ji=Sn+((m[g+11]<<4|m[g+12]>>4)&63)*(1<<$)-J&65535,Qi=hi+((m[g+12]<<2|m[g+13]>>6)&63)*(1<<$)-J&65535,er=vt+(m[g+13]&63)*(1<<$)-J&65535,ui=[K,le,_t,ln,me,we,Sn,ji,fe,We,hi,Qi,re,_e,vt,er];for(let Mn=0;Mn<16;Mn++)R[Mn]=ui[Mn]&32768?ui[Mn]&32767:~ui[Mn]&65535;g+=14}if(N.pLinear){if(Z===null){Z=new Uint16Array(65536);for(let K=0;K<65536;K++)if((K&31744)===31744||K>32768)Z[K]=0;else{let $=F.fromHalfFloat(K);Z[K]=$<=0?0:F.toHalfFloat(8*Math.log($))}}for(let K=0;K<16;K++)R[K]=Z[R[K]]}for(let K=0;K<4;K++){let $=ie*4+K;if(!($>=U))for(let J=0;J<4;J++){let me=ue*4+J;if(me>=q)continue;let fe=R[K*4+J];for(let re=0;re<N.ySampling;re++){let le=$*N.ySampling+re;if(!(le>=b))for(let we=0;we<N.xSampling;we++){let We=me*N.xSampling+we;if(We>=y)continue;let _e=le*y*x+I*y+We*2;E[_e]=fe&255,E[_e+1]=fe>>8&255}}}}}I+=2}return new DataView(E.buffer)}function ma(h){let m=h.viewer,g={value:h.offset.value},y=new Uint8Array(h.columns*h.lines*(h.inputChannels.length*h.type*2)),b={version:Re(m,g),unknownUncompressedSize:Re(m,g),unknownCompressedSize:Re(m,g),acCompressedSize:Re(m,g),dcCompressedSize:Re(m,g),rleCompressedSize:Re(m,g),rleUncompressedSize:Re(m,g),rleRawSize:Re(m,g),totalAcUncompressedCount:Re(m,g),totalDcUncompressedCount:Re(m,g),acCompression:Re(m,g)};if(b.version<2)throw new Error("THREE.EXRLoader: "+Ne.compression+" version "+b.version+" is unsupported");let T=new Array,x=ci(m,g)-2;for(;x>0;){let U=Yi(m.buffer,g),H=Ht(m,g),j=H>>2&3,ae=(H>>4)-1,ie=new Int8Array([ae])[0],ue=Ht(m,g);T.push({name:U,index:ie,type:ue,compression:j}),x-=U.length+3}let C=Ne.channels,E=new Array(h.inputChannels.length);for(let U=0;U<h.inputChannels.length;++U){let H=E[U]={},j=C[U];H.name=j.name,H.compression=0,H.decoded=!1,H.type=j.pixelType,H.pLinear=j.pLinear,H.width=h.columns,H.height=h.lines}let R={idx:new Array(3)};for(let U=0;U<h.inputChannels.length;++U){let H=E[U],j=H.name.lastIndexOf("."),ae=j>=0?H.name.substring(j+1):H.name;for(let ie=0;ie<T.length;++ie){let ue=T[ie];ae===ue.name&&H.type===ue.type&&(H.compression=ue.compression,ue.index>=0&&(R.idx[ue.index]=U),H.offset=U)}}let I,O,N;if(b.acCompressedSize>0)switch(b.acCompression){case 0:I=new Uint16Array(b.totalAcUncompressedCount),li(h.array,m,g,b.acCompressedSize,I,b.totalAcUncompressedCount);break;case 1:let U=h.array.slice(g.value,g.value+b.totalAcUncompressedCount),H=si(U);I=new Uint16Array(H.buffer),g.value+=b.totalAcUncompressedCount;break}if(b.dcCompressedSize>0){let U={array:h.array,offset:g,size:b.dcCompressedSize};O=new Uint16Array(ws(U).buffer),g.value+=b.dcCompressedSize}if(b.rleRawSize>0){let U=h.array.slice(g.value,g.value+b.rleCompressedSize),H=si(U);N=xs(H.buffer),g.value+=b.rleCompressedSize}let B=0,q=new Array(E.length);for(let U=0;U<q.length;++U)q[U]=new Array;for(let U=0;U<h.lines;++U)for(let H=0;H<E.length;++H)q[H].push(B),B+=E[H].width*h.type*2;R.idx[0]!==void 0&&E[R.idx[0]]&&Dh(R,q,E,I,O,y);for(let U=0;U<E.length;++U){let H=E[U];if(!H.decoded)switch(H.compression){case 2:let j=0,ae=0;for(let ie=0;ie<h.lines;++ie){let ue=q[U][j];for(let K=0;K<H.width;++K){for(let $=0;$<2*H.type;++$)y[ue++]=N[ae+$*H.width*H.height];ae++}j++}break;case 1:Oh(U,q,E,I,O,y);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(y.buffer)}function Yi(h,m){let g=new Uint8Array(h),y=0;for(;g[m.value+y]!=0;)y+=1;let b=new TextDecoder().decode(g.slice(m.value,m.value+y));return m.value=m.value+y+1,b}function Gh(h,m,g){let y=new TextDecoder().decode(new Uint8Array(h).slice(m.value,m.value+g));return m.value=m.value+g,y}function Hh(h,m){let g=ze(h,m),y=Ve(h,m);return[g,y]}function Vh(h,m){let g=Ve(h,m),y=Ve(h,m);return[g,y]}function ze(h,m){let g=h.getInt32(m.value,!0);return m.value=m.value+4,g}function Ve(h,m){let g=h.getUint32(m.value,!0);return m.value=m.value+4,g}function ga(h,m){let g=h[m.value];return m.value=m.value+1,g}function Ht(h,m){let g=h.getUint8(m.value);return m.value=m.value+1,g}let Re=function(h,m){let g=Number(h.getBigInt64(m.value,!0));return m.value+=8,g};function Pe(h,m){let g=h.getFloat32(m.value,!0);return m.value+=4,g}function Wh(h,m){return F.toHalfFloat(Pe(h,m))}function ci(h,m){let g=h.getUint16(m.value,!0);return m.value+=2,g}function Xh(h,m){return F.fromHalfFloat(ci(h,m))}function qh(h,m,g,y){let b=g.value,T=[];for(;g.value<b+y-1;){let x=Yi(m,g),C=ze(h,g),E=Ht(h,g);g.value+=3;let R=ze(h,g),I=ze(h,g);T.push({name:x,pixelType:C,pLinear:E,xSampling:R,ySampling:I})}return g.value+=1,T}function $h(h,m){let g=Pe(h,m),y=Pe(h,m),b=Pe(h,m),T=Pe(h,m),x=Pe(h,m),C=Pe(h,m),E=Pe(h,m),R=Pe(h,m);return{redX:g,redY:y,greenX:b,greenY:T,blueX:x,blueY:C,whiteX:E,whiteY:R}}function Yh(h,m){let g=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],y=Ht(h,m);return g[y]}function Zh(h,m){let g=ze(h,m),y=ze(h,m),b=ze(h,m),T=ze(h,m);return{xMin:g,yMin:y,xMax:b,yMax:T}}function Kh(h,m){let g=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],y=Ht(h,m);return g[y]}function Jh(h,m){let g=["ENVMAP_LATLONG","ENVMAP_CUBE"],y=Ht(h,m);return g[y]}function jh(h,m){let g=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],y=["ROUND_DOWN","ROUND_UP"],b=Ve(h,m),T=Ve(h,m),x=Ht(h,m);return{xSize:b,ySize:T,levelMode:g[x&15],roundingMode:y[x>>4]}}function Qh(h,m){let g=Pe(h,m),y=Pe(h,m);return[g,y]}function eu(h,m){let g=Pe(h,m),y=Pe(h,m),b=Pe(h,m);return[g,y,b]}function tu(h,m,g,y,b){if(y==="string"||y==="stringvector"||y==="iccProfile")return Gh(m,g,b);if(y==="chlist")return qh(h,m,g,b);if(y==="chromaticities")return $h(h,g);if(y==="compression")return Yh(h,g);if(y==="box2i")return Zh(h,g);if(y==="envmap")return Jh(h,g);if(y==="tiledesc")return jh(h,g);if(y==="lineOrder")return Kh(h,g);if(y==="float")return Pe(h,g);if(y==="v2f")return Qh(h,g);if(y==="v3f")return eu(h,g);if(y==="int")return ze(h,g);if(y==="rational")return Hh(h,g);if(y==="timecode")return Vh(h,g);if(y==="preview"||y==="deepImageState"||y==="idmanifest")return g.value+=b,"skipped";g.value+=b}function nu(h,m){let g=Math.log2(h);return m=="ROUND_DOWN"?Math.floor(g):Math.ceil(g)}function iu(h,m,g){let y=0;switch(h.levelMode){case"ONE_LEVEL":y=1;break;case"MIPMAP_LEVELS":y=nu(Math.max(m,g),h.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return y}function _a(h,m,g,y){let b=new Array(h);for(let T=0;T<h;T++){let x=1<<T,C=m/x|0;y=="ROUND_UP"&&C*x<m&&(C+=1);let E=Math.max(C,1);b[T]=(E+g-1)/g|0}return b}function ru(){let h=this,m=h.offset,g={value:0};for(let y=0;y<h.tileCount;y++){let b=ze(h.viewer,m),T=ze(h.viewer,m);m.value+=8,h.size=Ve(h.viewer,m);let x=b*h.blockWidth,C=T*h.blockHeight;h.columns=x+h.blockWidth>h.width?h.width-x:h.blockWidth,h.lines=C+h.blockHeight>h.height?h.height-C:h.blockHeight;let E=h.columns*h.totalBytes,I=h.size<h.lines*E?h.uncompress(h):$i(h);m.value+=h.size;for(let O=0;O<h.lines;O++){let N=O*h.columns*h.totalBytes;for(let B=0;B<h.inputChannels.length;B++){let q=Ne.channels[B].name,U=h.channelByteOffsets[q]*h.columns,H=h.decodeChannels[q];if(H===void 0)continue;g.value=N+U;let j=(h.height-(1+C+O))*h.outLineWidth;for(let ae=0;ae<h.columns;ae++){let ie=j+(ae+x)*h.outputChannels+H;h.byteArray[ie]=h.getter(I,g)}}}}}function su(){let h=this,m=h.offset,g={value:0};for(let y=0;y<h.height/h.blockHeight;y++){let b=ze(h.viewer,m)-Ne.dataWindow.yMin;h.size=Ve(h.viewer,m),h.lines=b+h.blockHeight>h.height?h.height-b:h.blockHeight;let T=h.columns*h.totalBytes,C=h.size<h.lines*T?h.uncompress(h):$i(h);m.value+=h.size;for(let E=0;E<h.lines;E++){let R=b+E,I=E*T,O=(h.height-1-R)*h.outLineWidth;for(let N=0;N<h.inputChannels.length;N++){let B=Ne.channels[N].name,q=h.channelByteOffsets[B]*h.columns,U=h.decodeChannels[B];if(U!==void 0){g.value=I+q;for(let H=0;H<h.columns;H++){let j=O+H*h.outputChannels+U;h.byteArray[j]=h.getter(C,g)}}}}}}function ou(){let h=this,m=h.chunkOffsets,g={value:0};for(let y=0;y<m.length;y++){let b={value:m[y]};b.value+=4;let T=ze(h.viewer,b)-Ne.dataWindow.yMin;h.size=Ve(h.viewer,b),h.lines=T+h.blockHeight>h.height?h.height-T:h.blockHeight;let x=h.columns*h.totalBytes,C=h.size<h.lines*x,E=h.offset;h.offset=b;let R=C?h.uncompress(h):$i(h);h.offset=E;for(let I=0;I<h.lines;I++){let O=T+I,N=I*x,B=(h.height-1-O)*h.outLineWidth;for(let q=0;q<h.inputChannels.length;q++){let U=Ne.channels[q].name,H=h.channelByteOffsets[U]*h.columns,j=h.decodeChannels[U];if(j!==void 0){g.value=N+H;for(let ae=0;ae<h.columns;ae++){let ie=B+ae*h.outputChannels+j;h.byteArray[ie]=h.getter(R,g)}}}}}}function va(h,m,g,y){if(g===0)return null;let b=h.slice(m,m+g);switch(y){case"NO_COMPRESSION":return new DataView(b.buffer,b.byteOffset,b.byteLength);case"RLE_COMPRESSION":{let T=new Uint8Array(xs(b.buffer.slice(b.byteOffset,b.byteOffset+b.byteLength))),x=new Uint8Array(T.length);return Xi(T),qi(T,x),new DataView(x.buffer)}case"ZIPS_COMPRESSION":{let T=si(b),x=new Uint8Array(T.length);return Xi(T),qi(T,x),new DataView(x.buffer)}default:throw new Error("THREE.EXRLoader: "+y+" is unsupported for deep data")}}function au(){let h=this,m=h.chunkOffsets,g=h.width,y=h.height,b=h.deepChannels,T=Ne.compression,x=h.multiPart,C=h.decodeChannels,E=h.outputChannels,R=h.byteArray instanceof Uint16Array,I=-1;for(let O=0;O<b.length;O++)if(b[O].name==="A"){I=O;break}for(let O=0;O<m.length;O++){let N={value:m[O]};x&&(N.value+=4);let B=ze(h.viewer,N)-Ne.dataWindow.yMin,q=Re(h.viewer,N),U=Re(h.viewer,N);Re(h.viewer,N);let H=va(h.array,N.value,q,T);if(N.value+=q,H===null)continue;let j=new Uint32Array(g);for(let J=0;J<g;J++)j[J]=H.getUint32(J*4,!0);let ae=j[g-1];if(ae===0){N.value+=U;continue}let ie=va(h.array,N.value,U,T),ue=[],K=0;for(let J=0;J<b.length;J++)ue.push(K),K+=ae*b[J].bytesPerSample;let $=(y-1-B)*h.outLineWidth;for(let J=0;J<g;J++){let me=J===0?0:j[J-1],re=j[J]-me;if(re===0)continue;let le=new Float32Array(E),we=0;for(let _e=0;_e<re;_e++){let _t=me+_e,Sn=1-we;if(Sn<=0)break;let hi=1;if(I>=0){let vt=b[I].bytesPerSample,ln=ue[I]+_t*vt;hi=vt===2?F.fromHalfFloat(ie.getUint16(ln,!0)):ie.getFloat32(ln,!0)}for(let vt=0;vt<b.length;vt++){let ln=b[vt],ji=C[ln.name];if(ji===void 0)continue;let Qi=ln.bytesPerSample,er=ue[vt]+_t*Qi,ui=Qi===2?F.fromHalfFloat(ie.getUint16(er,!0)):ie.getFloat32(er,!0);le[ji]+=ui*Sn}we+=hi*Sn}C.A!==void 0&&(le[C.A]=we);let We=$+J*E;for(let _e=0;_e<E;_e++)h.byteArray[We+_e]=R?F.toHalfFloat(le[_e]):le[_e]}}}function xa(h,m,g){let y={},b=!1;for(;;){let T=Yi(m,g);if(T==="")break;b=!0;let x=Yi(m,g),C=Ve(h,g),E=tu(h,m,g,x,C);E===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${x}'.`):y[T]=E}return b?y:null}function lu(h,m,g){if(h.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let y=h.getUint8(4),b=h.getUint8(5),T={singleTile:!!(b&2),longName:!!(b&4),deepFormat:!!(b&8),multiPart:!!(b&16)};g.value=8;let x=[];if(T.multiPart){for(;;){let C=xa(h,m,g);if(C===null)break;C.version=y,C.spec=T,x.push(C)}if(x.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let C=xa(h,m,g);C.version=y,C.spec=T,x.push(C)}return x}function cu(h,m,g,y,b,T){let x={size:0,viewer:m,array:g,offset:y,width:h.dataWindow.xMax-h.dataWindow.xMin+1,height:h.dataWindow.yMax-h.dataWindow.yMin+1,inputChannels:h.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:ut};switch(h.compression){case"NO_COMPRESSION":x.blockHeight=1,x.uncompress=$i;break;case"RLE_COMPRESSION":x.blockHeight=1,x.uncompress=Fh;break;case"ZIPS_COMPRESSION":x.blockHeight=1,x.uncompress=ws;break;case"ZIP_COMPRESSION":x.blockHeight=16,x.uncompress=ws;break;case"PIZ_COMPRESSION":x.blockHeight=32,x.uncompress=Bh;break;case"PXR24_COMPRESSION":x.blockHeight=16,x.uncompress=zh;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":x.blockHeight=32,x.uncompress=kh;break;case"DWAA_COMPRESSION":x.blockHeight=32,x.uncompress=ma;break;case"DWAB_COMPRESSION":x.blockHeight=256,x.uncompress=ma;break;default:throw new Error("THREE.EXRLoader: "+h.compression+" is unsupported")}let C={};for(let N of h.channels)switch(N.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":C[N.name]=!0,x.type=N.pixelType}let E=!1,R=!1;if(C.Y&&C.RY&&C.BY)x.outputChannels=4,x.yCbCr=!0;else if(C.R&&C.G&&C.B)x.outputChannels=4;else if(C.Y)x.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(x.outputChannels){case 4:T==xt?(E=!C.A,x.format=xt,x.colorSpace=ut,x.outputChannels=4,x.decodeChannels={R:0,G:1,B:2,A:3}):T==gn?(x.format=gn,x.colorSpace=ut,x.outputChannels=2,x.decodeChannels={R:0,G:1}):T==Bn?(x.format=Bn,x.colorSpace=ut,x.outputChannels=1,x.decodeChannels={R:0}):R=!0;break;case 1:T==xt?(E=!0,x.format=xt,x.colorSpace=ut,x.outputChannels=4,x.shouldExpand=!0,x.decodeChannels={Y:0}):T==gn?(x.format=gn,x.colorSpace=ut,x.outputChannels=2,x.shouldExpand=!0,x.decodeChannels={Y:0}):T==Bn?(x.format=Bn,x.colorSpace=ut,x.outputChannels=1,x.decodeChannels={Y:0}):R=!0;break;default:R=!0}if(R)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(x.yCbCr&&(x.format=xt,x.outputChannels=4,x.decodeChannels={Y:0,RY:1,BY:2},E=!0),x.type==1)switch(b){case jt:x.getter=Xh;break;case mn:x.getter=ci;break}else if(x.type==2)switch(b){case jt:x.getter=Pe;break;case mn:x.getter=Wh}else throw new Error("THREE.EXRLoader: unsupported pixelType "+x.type+" for "+h.compression+".");x.columns=x.width;let I=x.width*x.height*x.outputChannels;switch(b){case jt:x.byteArray=new Float32Array(I),E&&x.byteArray.fill(1,0,I);break;case mn:x.byteArray=new Uint16Array(I),E&&x.byteArray.fill(15360,0,I);break;default:console.error("THREE.EXRLoader: unsupported type: ",b);break}let O=0;for(let N of h.channels)x.decodeChannels[N.name]!==void 0&&(x.channelByteOffsets[N.name]=O),O+=N.pixelType*2;if(x.totalBytes=O,x.outLineWidth=x.width*x.outputChannels,h.spec.deepFormat){x.deepChannels=[];let N=0;for(let B of h.channels){let q=B.pixelType===0?4:B.pixelType*2;x.deepChannels.push({name:B.name,pixelType:B.pixelType,bytesPerSample:q}),N+=q}x.deepBytesPerSample=N,x.chunkOffsets=h._chunkOffsets,x.multiPart=h.spec.multiPart,x.decode=au.bind(x)}else if(h.spec.singleTile){x.blockHeight=h.tiles.ySize,x.blockWidth=h.tiles.xSize;let N=iu(h.tiles,x.width,x.height),B=_a(N,x.width,h.tiles.xSize,h.tiles.roundingMode),q=_a(N,x.height,h.tiles.ySize,h.tiles.roundingMode);x.tileCount=B[0]*q[0];for(let U=0;U<N;U++)for(let H=0;H<q[U];H++)for(let j=0;j<B[U];j++)Re(m,y);x.decode=ru.bind(x)}else if(h.spec.multiPart)x.blockWidth=x.width,x.chunkOffsets=h._chunkOffsets,x.decode=ou.bind(x);else{x.blockWidth=x.width;let N=Math.ceil(x.height/x.blockHeight);for(let B=0;B<N;B++)Re(m,y);x.decode=su.bind(x)}return x}let Zi={value:0},Ki=new DataView(e),hu=new Uint8Array(e),Ji=lu(Ki,e,Zi),ya=Math.max(0,Math.min(this.part,Ji.length-1)),Ne=Ji[ya];if(Ne.spec.multiPart||Ne.spec.deepFormat)for(let h=0;h<Ji.length;h++){let m=Ji[h].chunkCount;if(h===ya){Ne._chunkOffsets=[];for(let g=0;g<m;g++)Ne._chunkOffsets.push(Re(Ki,Zi))}else for(let g=0;g<m;g++)Re(Ki,Zi)}let je=cu(Ne,Ki,hu,Zi,this.type,this.outputFormat);if(je.decode(),je.shouldExpand){let h=je.byteArray;if(this.outputFormat==xt)for(let m=0;m<h.length;m+=4)h[m+2]=h[m+1]=h[m];else if(this.outputFormat==gn)for(let m=0;m<h.length;m+=2)h[m+1]=h[m]}if(je.yCbCr){let h=je.byteArray,m=je.width*je.height;if(this.type===mn)for(let g=0;g<m;g++){let y=g*4,b=F.fromHalfFloat(h[y]),T=F.fromHalfFloat(h[y+1]),x=F.fromHalfFloat(h[y+2]),C=(1+T)*b,E=(1+x)*b,R=(b-C*.2126-E*.0722)/.7152;h[y]=F.toHalfFloat(Math.max(0,C)),h[y+1]=F.toHalfFloat(Math.max(0,R)),h[y+2]=F.toHalfFloat(Math.max(0,E))}else for(let g=0;g<m;g++){let y=g*4,b=h[y],T=h[y+1],x=h[y+2],C=(1+T)*b,E=(1+x)*b;h[y]=Math.max(0,C),h[y+1]=Math.max(0,(b-C*.2126-E*.0722)/.7152),h[y+2]=Math.max(0,E)}}return{header:Ne,width:je.width,height:je.height,data:je.byteArray,format:je.format,colorSpace:je.colorSpace,type:this.type,minFilter:Yt,magFilter:Yt,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var gh=32768,U0=2**27,_h=2**28,vh=1024,F0=12,ia=2**29,xh=1e18;function as(s,e,t){let n=Math.max(s,e)>gh||s*e>U0;if(Math.min(s,e)<1||n)throw new ee(`has ${s} x ${e} pixels; from 1 to ${gh} a side, 2^27 in all`);let i=s*e*F0;if(i>_h&&i>vh*t)throw new ee(`has ${s} x ${e} pixels in ${t} bytes; an image above ${_h} bytes of radiance is at most ${vh} times its file`)}var B0=512,z0=2048,k0=4096,cs=["NO","RLE","ZIPS","ZIP","PIZ","PXR24","B44","B44A","DWAA","DWAB"],G0=0,H0=2,V0=2,W0=4096,yh=["RY","BY"];function wh(s){let{parts:e,flags:t}=K0(s),n=q0(e),i=e[n];$0(i,e.length,t);for(let A of[i.dataWindow,i.displayWindow])as(...ls(A),s.length);let r=e.reduce((A,P)=>A+Math.max(0,X0(P)),0);if(r>ia)throw new ee(`has ${r} values in all its channels; at most ${ia}`);let o=i.dataWindow,a=i.displayWindow,l=Math.max(o[0],a[0]),c=Math.min(o[2],a[2]),u=Math.max(o[1],a[1]),f=Math.min(o[3],a[3]);if(l>c||u>f)throw new ee("its data window lies outside its display window");Y0(i);let p=new os().setDataType(jt).setPart(n).parse(Z0(s,i).buffer),[_,v]=ls(a),[S]=ls(o),M=new Float32Array(3*_*v);for(let A=u;A<=f;A++){let P=o[3]-A;for(let L=l;L<=c;L++){let D=4*(P*S+L-o[0]),Y=3*((A-a[1])*_+L-a[0]);for(let G=0;G<3;G++)M[Y+G]=p.data[D+G]}}return{rgb:M,width:_,height:v}}function ls([s,e,t,n]){return[t-s+1,n-e+1]}function X0({dataWindow:s,channels:e}){let[t,n]=ls(s);return Math.max(0,t)*Math.max(0,n)*e.length}function sa({channels:s}){let e=new Set(s.map(({name:t})=>t));return e.has("R")&&e.has("G")&&e.has("B")?["R","G","B"]:e.has("Y")&&!yh.some(t=>e.has(t))?["Y"]:[]}function q0(s){let e=s.findIndex(i=>sa(i).length>0);if(e>=0)return e;let t=[...new Set(s.flatMap(({channels:i})=>i.map(({name:r})=>r)))].sort();if(["Y",...yh].every(i=>t.includes(i)))throw new ee("has luminance and chroma (Y, RY, BY): save it with R, G and B");let n=t.length>12?` and ${t.length-12} more`:"";throw new ee(`has no channels R, G and B, nor Y; it has ${t.slice(0,12).join(", ")||"none"}${n}`)}function $0(s,e,t){let n=s.type?s.type.startsWith("deep"):(t&z0)!==0,i=s.type?s.type==="tiledimage":(t&B0)!==0,r=o=>{throw new ee(o)};n&&r("is a deep image, with any number of samples a pixel: flatten it"),s.envmap&&r("is a cube map: convert it to latitude and longitude"),s.channels.some(({x:o,y:a})=>o!==1||a!==1)&&r("has channels of fewer texels than others: save them all at full size"),cs[s.compression]===void 0&&r(`has compression ${s.compression}, expected one of ${cs.join(", ")}`),i&&e>1&&r("has tiles in one of several parts: save it with scan lines"),i&&s.levels===V0&&r("has tiles of several sizes by row and column: save it with one size")}function Y0(s){let e=sa(s),t=new Set;for(let{name:n,type:i}of s.channels)e.includes(n)&&t.add(["uint32","float16","float32"][i]);if(t.size>1||t.has("uint32"))throw new ee(`has colours of type ${[...t].sort().join(", ")}, expected float16 or float32`)}function Z0(s,e){let t=s.slice(),n=sa(e),i=e.channels.find(({name:o})=>o===n[0]).type,r=["DWAA","DWAB"].includes(cs[e.compression]);for(let o of e.channels)if(o.type===G0&&cs[e.compression]!=="PXR24"&&(t[o.typeAt]=H0),["A","Y","RY","BY"].includes(o.name)&&!n.includes(o.name)&&!(r&&o.type===i))for(let l=0;l<o.name.length;l++)t[o.at+l]|=32;return t}function K0(s){let e=new DataView(s.buffer,s.byteOffset,s.length),t=e.getUint32(4,!0),n={bytes:s,view:e,at:8},i=[];do{let r=J0(n);if(r===null)break;i.push(r)}while(t&k0);if(!i.length)throw new ee("broken EXR image: it has no header");return{parts:i,flags:t}}function J0(s){let e={channels:null,compression:null,dataWindow:null,displayWindow:null,type:"",envmap:0,levels:0},{view:t}=s;for(let i=0;;i++){let r=ra(s);if(r===""){if(i===0)return null;break}let o=ra(s),a=t.getInt32(s.at,!0),l=s.at+4;if(a<0||l+a>s.bytes.length||i>W0)throw new ee("broken EXR image: an attribute goes past the file's end");r==="channels"&&(e.channels=j0({...s,at:l})),r==="compression"&&(e.compression=t.getUint8(l)),(r==="dataWindow"||r==="displayWindow")&&(e[r]=[0,4,8,12].map(c=>t.getInt32(l+c,!0))),r==="type"&&(e.type=String.fromCharCode(...s.bytes.subarray(l,l+Math.min(a,64)))),r==="envmap"&&o==="envmap"&&(e.envmap=t.getUint8(l)),r==="tiles"&&(e.levels=t.getUint8(l+8)&15),s.at=l+a}let n=["channels","compression","dataWindow","displayWindow"].find(i=>e[i]===null);if(n!==void 0)throw new ee(`broken EXR image: it has no ${n}`);return e}function j0(s){let e=[];for(;;){let t=s.at,n=ra(s);if(n==="")return e;let i=s.at,{view:r}=s;e.push({name:n,at:t,typeAt:i,type:r.getInt32(i,!0),x:r.getInt32(i+8,!0),y:r.getInt32(i+12,!0)}),s.at+=16}}function ra(s){let e=s.bytes.indexOf(0,s.at);if(e<0||e-s.at>255)throw new ee("broken EXR image: its header does not end");let t=new TextDecoder("utf-8",{fatal:!0}).decode(s.bytes.subarray(s.at,e));return s.at=e+1,t}var Q0=65536,bh=[8,32767],e_=/^([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})$/,t_=/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/,oa=/^[ \t\r\x0b\f]+|[ \t\r\x0b\f]+$/g,st=s=>new ee(`broken HDR image${s}`);function Sh(s){let e=n_(s),{count:t,length:n,columns:i,back:r,exposure:o}=e,a=i_(s,e),l=1/o,[c,u]=i?[t,n]:[n,t],f=new Float32Array(3*c*u);for(let d=0;d<t;d++){let p=r[0]?t-1-d:d;for(let _=0;_<n;_++){let v=r[1]?n-1-_:_,S=4*(d*n+_),M=3*(i?v*c+p:p*c+v),A=a[S+3],P=A>0?l*2**(A-136):0;for(let L=0;L<3;L++)f[M+L]=a[S+L]*P}}return{rgb:f,width:c,height:u}}function n_(s){let e=[],t=0,n=-1;for(;n<0||e.length<n+2;){let f=s.subarray(0,Q0).indexOf(10,t);if(f<0)throw st(": it has no header");e.push(Array.from(s.subarray(t,f),d=>String.fromCharCode(d)).join("")),t=f+1,n<0&&e.at(-1).replace(/\r+$/,"")===""&&(n=e.length-1)}let i=1;for(let f of e.slice(1,n)){let d=f.indexOf("="),[p,_]=d<0?[f,""]:[f.slice(0,d),f.slice(d+1)],v=p.replace(oa,""),S=_.replace(oa,"");if(v==="FORMAT"&&S!=="32-bit_rle_rgbe")throw st(`: format '${S}', expected 32-bit_rle_rgbe`);v==="EXPOSURE"&&(i*=t_.test(S)?Number(S)||1:0)}if(!(i>0&&i<1/0))throw st(": EXPOSURE is not a positive number");let r=e[n+1].replace(oa,""),o=e_.exec(r);if(o===null||o[2]===o[5])throw st(`: size '${r.slice(0,40)}', expected such as '-Y height +X width'`);let a=Number(o[3]),l=Number(o[6]),c=o[2]==="X",u=[o[1]+o[2],o[4]+o[5]].map(f=>f==="+Y"||f==="-X");return as(...c?[a,l]:[l,a],s.length),{offset:t,count:a,length:l,columns:c,back:u,exposure:i}}function i_(s,{offset:e,count:t,length:n}){let i=new Uint8Array(4*t*n),r=e;try{for(let o=0;o<t;o++)r=r_(s,r,i.subarray(4*o*n),n,o)}catch(o){if(s.length-e===i.length)return s.subarray(e);throw o}return i}function r_(s,e,t,n,i){if(n>=bh[0]&&n<=bh[1]&&e+4<=s.length&&s[e]===2&&s[e+1]===2&&s[e+2]<128){if(s[e+2]*256+s[e+3]!==n)throw st(`, line ${i}: a run goes past the line's end`);return s_(s,e+4,t,n,i)}return o_(s,e,t,n,i)}function s_(s,e,t,n,i){for(let r=0;r<4;r++)for(let o=0;o<n;){if(e+2>s.length)throw st(`, line ${i}: the file ends there`);let a=s[e]>128,l=a?s[e]-128:s[e];if(l===0)throw st(`, line ${i}: a run of no pixels`);if(o+l>n)throw st(`, line ${i}: a run goes past the line's end`);if(e+1+(a?1:l)>s.length)throw st(`, line ${i}: the file ends there`);for(let c=0;c<l;c++)t[4*(o+c)+r]=s[e+1+(a?0:c)];o+=l,e+=a?2:1+l}return e}function o_(s,e,t,n,i){let r=0,o=0;for(;r<n;){if(e+4>s.length)throw st(`, line ${i}: the file ends there`);if(s[e]===1&&s[e+1]===1&&s[e+2]===1){if(r===0)throw st(`, line ${i}: a run repeats a pixel, but there is none before it`);let a=o>16?1/0:s[e+3]*2**o;if(r+a>n)throw st(`, line ${i}: a run goes past the line's end`);for(let l=0;l<a;l++)t.copyWithin(4*(r+l),4*(r-1),4*r);r+=a,o+=8}else t.set(s.subarray(e,e+4),4*r),r+=1,o=0;e+=4}return e}var a_=[118,47,49,1],l_=[35,63];function aa(s,e){let t=new Uint8Array(s),n=r=>r.every((o,a)=>t[a]===o),i=n(a_)?wh:n(l_)?Sh:null;if(i===null)throw new ee(`${e}: is neither an EXR nor a Radiance HDR image`);try{return c_(i(t))}catch(r){let o=r instanceof ee?r.message:`cannot read the image: ${r.message??r}`;throw new ee(`${e}: ${o}`)}}function c_(s){let{rgb:e}=s,t=0;for(let n=0;n<e.length;n+=3){let i=!0;for(let r=n;r<n+3;r++)i&&=Number.isFinite(e[r])&&e[r]<=xh,e[r]>0||(e[r]=0);i||t++}if(t)throw new ee(`has ${t} texels that are not finite numbers of at most 1e+18`);return s}var ai=.4*Math.PI/180,oi=5*Math.PI/180;function Mh(s,e){let t=new Map,n=null;s.addEventListener("pointerdown",r=>{t.set(r.pointerId,{x:r.clientX,y:r.clientY}),h_(s,r.pointerId),s.classList.add("dragging"),t.size===2?n="two":t.size===1&&(n=r.button===2?"pan":r.button!==0?null:r.altKey||r.shiftKey?"light":"orbit")}),s.addEventListener("pointermove",r=>{let o=t.get(r.pointerId);if(!o)return;let a={x:r.clientX,y:r.clientY},l=a.x-o.x,c=a.y-o.y;n==="two"&&u_(t,r.pointerId,o,a,e),t.set(r.pointerId,a),!(!l&&!c)&&(n==="orbit"&&e.orbit(-l*ai,c*ai,!0),n==="light"&&e.light(l*ai,-c*ai,!0),n==="pan"&&e.pan(-l/s.clientHeight,c/s.clientHeight,!0))});for(let r of["pointerup","pointercancel"])s.addEventListener(r,o=>{t.delete(o.pointerId)&&(t.size||(n=null,s.classList.remove("dragging"),e.settle()))});s.addEventListener("contextmenu",r=>r.preventDefault()),s.addEventListener("dblclick",()=>e.reset());let i=0;s.addEventListener("wheel",r=>{r.preventDefault();let o=r.deltaMode===0?r.deltaY:r.deltaY*32;e.zoom(Math.exp(Math.min(300,Math.max(-300,o))*.0012),!0),clearTimeout(i),i=setTimeout(()=>e.settle(),200)},{passive:!1}),s.addEventListener("keydown",r=>f_(r,e))}function h_(s,e){try{s.setPointerCapture(e)}catch{}}function u_(s,e,t,n,i){let r=[...s].find(([a])=>a!==e)?.[1];if(!r)return;let o=a=>Math.hypot(a.x-r.x,a.y-r.y)||1;i.zoom(o(t)/o(n),!0),i.light(.5*(n.x-t.x)*ai,-.5*(n.y-t.y)*ai,!0)}function f_(s,e){if(s.ctrlKey||s.metaKey)return;let t=s.altKey||s.shiftKey?e.light:e.orbit,n={ArrowLeft:()=>t(-oi,0),ArrowRight:()=>t(oi,0),ArrowUp:()=>t(0,oi),ArrowDown:()=>t(0,-oi),"+":()=>e.zoom(1/1.1),"=":()=>e.zoom(1/1.1),"-":()=>e.zoom(1.1),"[":()=>e.light(-oi,0),"]":()=>e.light(oi,0),Home:()=>e.reset()};Object.hasOwn(n,s.key)&&(s.preventDefault(),n[s.key]())}var d_={studio:["Studio",lh],white:["White from all sides",()=>ss([1,1,1])]},p_=[1.06,1,.9],hs=Math.PI/180,us=class{constructor(){this.images=new Map(Object.entries(d_).map(([e,[t,n]])=>[e,{label:t,make:n}])),this.choice="studio",this.reset()}reset(){Object.assign(this,{rotation:0,sunHeight:45,sunAzimuth:40,sun:2,strength:1,suns:null,imageTurn:0})}add(e,t){let n=`image-${this.images.size}`;return this.images.set(n,{label:e,make:()=>t}),n}tables(){let e=this.images.get(this.choice);return e.tables??=ah(e.make()),e.tables}lights(){let e=[],t=[0,0,0];for(let{direction:n,irradiance:i}of this.suns??[this._sun()]){if(!i.some(o=>o>0))continue;let r=m_(n,this.rotation*hs);e.push({kind:"sun",direction:r,colour:i}),i.forEach((o,a)=>{t[a]+=o*Math.max(0,r[1])})}if(this.strength>0){let n=[this.strength,this.strength,this.strength],i=(this.rotation+this.imageTurn)*hs;e.push({kind:"environment",colour:n,angle:i},{kind:"aroundPoint",colour:n,angle:i}),this.tables().up.forEach((r,o)=>{t[o]+=r*this.strength})}return{lights:e,irradiance:t}}_sun(){let e=this.sunHeight*hs,t=this.sunAzimuth*hs;return{direction:[Math.cos(e)*Math.sin(t),Math.sin(e),Math.cos(e)*Math.cos(t)],irradiance:p_.map(n=>n*this.sun)}}};function m_([s,e,t],n){let i=Math.cos(n),r=Math.sin(n),o=Math.hypot(s,e,t);return[(i*s+r*t)/o,e/o,(i*t-r*s)/o]}var Ah=89*Math.PI/180,fs=class{constructor(){Object.assign(this,{target:new z,azimuth:.6,elevation:.35,distance:1,fov:30})}frame({min:e,max:t},n){let i=new z(...e),r=new z(...t);this.target.addVectors(i,r).multiplyScalar(.5);let o=i.distanceTo(r)/2||1,a=this.fov*Math.PI/360,l=Math.min(a,Math.atan(Math.tan(a)*n));this.distance=.92*o/Math.sin(l),this.size=o}lookFrom(e,t,n){let i=new z(...e).sub(new z(...t));this.target.set(...t),this.distance=i.length(),this.azimuth=Math.atan2(i.x,i.z),this.elevation=Math.asin(i.y/this.distance),n&&(this.fov=n)}get position(){let e=Math.cos(this.elevation);return new z(e*Math.sin(this.azimuth),Math.sin(this.elevation),e*Math.cos(this.azimuth)).multiplyScalar(this.distance).add(this.target)}turn(e,t){this.azimuth+=e,this.elevation=Math.min(Ah,Math.max(-Ah,this.elevation+t))}zoom(e){this.distance=Math.min(1e4*this.size,Math.max(.001*this.size,this.distance*e))}pan(e,t){let{forward:n,side:i,above:r}=this._axes(),o=2*this.distance*Math.tan(this.fov*Math.PI/360);return this.target.addScaledVector(i,e*o).addScaledVector(r,t*o),n}camera(e,t){let{forward:n,side:i,above:r}=this._axes(),o=Math.tan(this.fov*Math.PI/360),a=o*e/t,l=n.clone().addScaledVector(i,-a).addScaledVector(r,o);return{position:this.position.toArray(),corner:l.toArray(),stepX:i.clone().multiplyScalar(2*a/e).toArray(),stepY:r.clone().multiplyScalar(-2*o/t).toArray()}}_axes(){let e=this.target.clone().sub(this.position).normalize(),t=e.clone().cross(new z(0,1,0)).normalize();return{forward:e,side:t,above:t.clone().cross(e)}}};var Gi=()=>null,ds=(...s)=>e=>s.includes(e)?null:`expected ${s.join(" or ")}`,Eh=(s,e,t)=>n=>{let i=Number(n);return n.trim()!==""&&i>=s&&i<=e&&(!t||Number.isInteger(i))?null:`expected a ${t?"whole ":""}number from ${s} to ${e}`},ps={asset:Gi,tier:Gi,env:Gi,scene:Gi,api:Gi,ui:ds("0","1"),bench:ds("0","1"),jitter:ds("0","1"),view:ds("srgb","filmic"),rounds:Eh(1,1e6,!0),dpr:Eh(.1,8,!1)};function Th(s,e){let t=new Map,n=[];for(let i of[s,e])for(let[r,o]of new URLSearchParams(i)){let a=Object.hasOwn(ps,r)?ps[r](o):g_(r);a?n.push(Object.hasOwn(ps,r)?`?${r}=: ${a}, found ${o}`:a):t.set(r,o)}return{parameters:t,problems:n}}function g_(s){let e=Object.keys(ps).find(t=>__(s.toLowerCase(),t)<=(t.length>3?2:1));return e?`?${s}= is no parameter of this page: did you mean ${e}=?`:null}function __(s,e){let t=[Array.from({length:e.length+1},(n,i)=>i)];for(let n=1;n<=s.length;n++){t.push([n]);for(let i=1;i<=e.length;i++){let r=n>1&&i>1&&s[n-1]===e[i-2]&&s[n-2]===e[i-1]?t[n-2][i-2]+1:1/0,o=t[n-1][i-1]+ +(s[n-1]!==e[i-1]);t[n].push(Math.min(t[n-1][i]+1,t[n][i-1]+1,o,r))}}return t[s.length][e.length]}function Hi(s){return s.replaceAll("#","%23").replace(/%(?![0-9a-f]{2})/gi,"%25")}var Rh=100,v_=.7,ms=class{constructor(e){this.app=e,ke("tier","change",({value:n})=>e.switchTier(n));let t=(n,i)=>{ke(n,"input",({valueAsNumber:r})=>this._setLight(i,r,!0)),ke(n,"change",({valueAsNumber:r})=>this._setLight(i,r,!1))};t("environment-intensity","strength"),t("sun-intensity","sun"),t("sun-height","sunHeight"),t("rotation","rotation"),ke("environment","change",({value:n})=>this._setLight("choice",n,!1)),ke("exposure","input",({valueAsNumber:n})=>e.setExposure(n)),ke("exposure","change",()=>this.hasGround&&e.changed()),ke("view-transform","change",({value:n})=>e.setView(n)),ke("denoise","change",({checked:n})=>e.setDenoise(n)),ke("ground","change",()=>e.changed()),ke("faster","click",()=>e.switchTier(this.faster)),ke("reset","click",()=>e.resetView()),ke("screenshot","click",()=>this._save()),ke("fullscreen","click",()=>this._fullScreen()),this.showLighting(e.lighting),this.showExposure(0)}_setLight(e,t,n){(e==="sun"||e==="sunHeight")&&(this.app.lighting.suns=null),this.app.lighting[e]=t,this.showLighting(this.app.lighting),this.app.changed(n)}get hasGround(){return xe("ground").checked}setGround(e){xe("ground").checked=e}showLighting({images:e,choice:t,strength:n,sun:i,suns:r,sunHeight:o,rotation:a}){let l=[...e].map(([c,{label:u}])=>new Option(u,c,!1,c===t));xe("environment").replaceChildren(...l),En("environment-intensity",n,n.toFixed(2)),En("sun-intensity",i,r?"the scene's":i.toFixed(1)),En("sun-height",o,r?"the scene's":`${nr(Math.round(o),0)}\xB0`),En("rotation",a,`${nr(Math.round(a),0)}\xB0`)}showExposure(e){En("exposure",e,`${nr(e,1)} stops`)}showView(e){xe("view-transform").value=e}showEngine(e,t){xe("api").textContent=[e,...t].join(": ")}showPackage({manifest:e,warnings:t=e.warnings,bytesOf:n,...i},{tier:r}){let o=this.app.opened;document.title=`${e.name} \u2013 RNA viewer`,xe("name").textContent=e.name,xe("tier").replaceChildren(...e.tiers.map(({name:c})=>new Option(c,c,!1,c===r.name)));let{validation:a,cost:l}=r;xe("error").textContent=a?`${a.psnr.toFixed(1)} dB, FLIP ${a.flip.toFixed(3)}`:"not recorded",xe("cost").textContent=l?`${l.multiplyAdds.toLocaleString("en")} multiply-adds`:"not recorded",xe("size").textContent=Vt(o.bytesOf(r.name)),t.length&&at(t.join("; "),!0,"asset")}showStats({ms:e,rounds:t,scale:n}){xe("time").textContent=e?As(e):"\u2013",xe("rounds").textContent=n===1?String(t):`first look, 1/${n} of the size`,this._suggestTier(e)}_suggestTier(e){let{opened:t,shown:n}=this.app,i=n?.tier.cost?.multiplyAdds,r=({cost:l})=>e*l.multiplyAdds/i,o=i&&e>Rh?t.manifest.tiers.filter(({cost:l})=>l&&l.multiplyAdds<v_*i).sort((l,c)=>r(c)-r(l)):[],a=o.find(l=>r(l)<=Rh)??o.at(-1);this.faster=a?.name,xe("faster").hidden=!a,a&&(xe("faster").textContent=`Switch to tier ${a.name}: about ${As(r(a))} a sample`)}showProgress(e,t){if(xe("loading").hidden=e===null,e===null)return;let n=xe("bar");t?Object.assign(n,{max:Math.max(t,e),value:e}):n.removeAttribute("value"),xe("bytes").textContent=t?`${Vt(e)} of ${Vt(Math.max(t,e))}`:Vt(e)}showPoster(e){let t=xe("poster");t.src&&URL.revokeObjectURL(t.src),t.hidden=!e,e?t.src=URL.createObjectURL(e):t.removeAttribute("src")}async _save(){let{viewer:e}=this.app,t=xe("screenshot");if(!e)return;if(this.saving)return this.saving.abort();let n=this.saving=new AbortController,i=()=>{let{rounds:o,scale:a}=e.stats;t.textContent=`Save now (${a===1?o:0} of ${e.rounds})`};i(),e.addEventListener("shown",i),await Promise.race([e.converged(),new Promise(o=>n.signal.addEventListener("abort",o))]),e.removeEventListener("shown",i),this.saving=null,t.textContent="Save picture";let r=document.createElement("a");r.href=URL.createObjectURL(await this.app.screenshot()),r.download=`${this.app.opened?.manifest.name??"rna"}.png`,r.click(),setTimeout(()=>URL.revokeObjectURL(r.href),1e3)}_fullScreen(){document.fullscreenElement?document.exitFullscreen():document.documentElement.requestFullscreen?.()}};var Ch=(s,e)=>s.reduce((t,n,i)=>t+n*e[i],0),x_=[[.59719,.35458,.04823],[.076,.90834,.01566],[.0284,.13383,.83777]],y_=[[1.60475,-.53108,-.07367],[-.10208,1.10813,-.00605],[-.00327,-.07276,1.07602]];function w_(s){let e=x_.map(t=>{let n=1.461926*Ch(t,s);return(n*(n+.0245786)-90537e-9)/(n*(.983729*n+.432951)+.238081)});return y_.map(t=>Ch(t,e))}function Ih(s){let e=[...s];for(let t=0;t<60;t++){let n=w_(e);e=e.map((i,r)=>i*Math.min(2,Math.max(.5,s[r]/Math.max(n[r],1e-6))))}return e}var b_={kind:"sun",direction:[0,1,0],colour:[0,0,0]},_s=[.052,.056,.063],gs=class extends EventTarget{constructor(e,t,n){super(),Object.assign(this,{engine:e,canvas:t,orbit:n}),Object.assign(this,{lights:[],ground:null,exposure:0,view:"srgb",denoise:!0,rounds:256,jitter:1,generation:0,msPerPixel:.005,shown:null,finest:1,ready:!1,stopped:!1,moving:!1,stats:{ms:0,rounds:0}}),this.wake=null}restart(e=!1){this.moving=e,Object.assign(this.stats,{rounds:0,scale:0}),this.generation+=1,this.wake?.()}start(){this.ready=!0,this.running??=this._run(),this.restart()}pause(){this.ready=!1,this.generation+=1}stop(){return this.stopped=!0,this.pause(),this.wake?.(),this.running}async converged(e=this.rounds){for(;!(this.stats.scale===1&&this.stats.rounds>=e);)await new Promise(t=>this.addEventListener("shown",t,{once:!0}))}show(){if(!this.shown)return;let{rounds:e}=this.shown,t=this.denoise&&e<12;this.engine.show({rounds:e,exposure:2**this.exposure,backdrop:_s,filmic:this.view==="filmic",spread:t?.4/Math.sqrt(e):0})}async _run(){for(;!this.stopped;){let e=this.generation;try{this.ready&&await this._picture(e)}catch(t){this.engine.lost||this.dispatchEvent(Object.assign(new Event("failed"),{error:t})),this.ready=!1}e===this.generation&&!this.stopped&&await new Promise(t=>{this.wake=t})}}async _picture(e){for(let t of this._scales()){let n=t===1&&!this.moving?this.rounds:1;if(!await this._stage(e,t,n)||this.moving)return}}_scales(){let e=this.canvas.width*this.canvas.height*Math.max(1,this.lights.length),t=1;for(;t<16&&e*this.msPerPixel/t**2>110;)t*=2;let n=[t];for(;t>1;)n.push(t=t>4?t/4:1);return n}async _stage(e,t,n){let{engine:i,canvas:r}=this,o=Math.ceil(r.width/t),a=Math.ceil(r.height/t);this.shown=null,i.resize(o,a);let l={...this.orbit.camera(o,a),jitter:this.jitter};if(!this.hasShown){if(!await this._round(e,l,0,this.lights.slice(0,1)))return!1;this._present(1,t)}for(let c=0;c<n;c++){let u=performance.now();if(!await this._round(e,l,c,this.lights))return!1;this._present(c+1,t),this._measure(performance.now()-u,o*a,t)}return!0}async _round(e,t,n,i){let{engine:r}=this,{width:o,height:a}=r.target,l=this.msPerPixel*o*Math.max(1,i.length),c=Math.max(1,Math.min(a,Math.floor(120/l),Math.floor(r.bandPixels/o)));for(let u=0;u<a;u+=c)if(this._band(t,n,i,u,Math.min(a,u+c)),await r.done(),e!==this.generation||this.stopped||r.lost)return!1;return!0}_band(e,t,n,i,r){let{engine:o}=this;o.trace(e,t,i,r),(n.length?n:[b_]).forEach((l,c)=>o.light({...l,ground:this.ground},{isFirst:t===0&&c===0,countsCoverage:c===0})),o.emits&&o.emission()}_present(e,t){this.shown={rounds:e},this.show(),this.hasShown||performance.mark("picture"),this.hasShown=!0,Object.assign(this.stats,{rounds:e,scale:t}),this.dispatchEvent(new Event("shown"))}_measure(e,t,n){let i=e/(t*Math.max(1,this.lights.length));this.msPerPixel=t<4096?Math.min(this.msPerPixel*4,i):.5*(this.msPerPixel+i),n===1&&(this.stats.ms=this.stats.ms?.7*this.stats.ms+.3*e:e)}};var S_=22e5,vs=class{constructor(e,t={}){Object.assign(this,{parameters:e,labels:t,orbit:new fs,lighting:new us,opened:null,loading:null}),this.panel=new ms(this),this.places={view:document.getElementById("view")},new ResizeObserver(()=>this.resize()).observe(this.places.view),this._listenForDrops()}begin(){return this.begun=this._begin(),this.begun.catch(e=>this._failed(e,"engine")),this.begun}async _begin(){let e=()=>Object.assign(document.createElement("canvas"),{tabIndex:0,role:"application",ariaLabel:"The asset. Arrow keys orbit."}),{engine:t,canvas:n,reasons:i}=await sh(e,this.parameters.get("api"));Object.assign(this,{engine:t,canvas:n}),n.setAttribute("aria-describedby","keys"),this.places.view.replaceChildren(n),t.onlost=r=>this._recover(r),this.viewer=new gs(t,n,this.orbit),this.parameters.has("rounds")&&(this.viewer.rounds=Number(this.parameters.get("rounds"))),this.parameters.get("jitter")==="0"&&(this.viewer.jitter=0),this.parameters.has("view")&&this.setView(this.parameters.get("view")),this.viewer.addEventListener("shown",()=>this.panel.showStats(this.viewer.stats)),this.viewer.addEventListener("failed",({error:r})=>this._failed(r,"asset")),performance.mark("engine"),Mh(n,this._actions()),this.panel.showEngine(t.constructor.label,i),this.resize()}expectAsset(e=!0){document.body.classList.toggle("expecting",e)}async open(e){this.loading?.abort();let t=this.loading=new AbortController;this.expectAsset();try{at(null,!1,"asset");let n=e instanceof Blob?new An(e,e.name):await tr.open(e,(r,o)=>this.panel.showProgress(r,o),t.signal,this.labels[e]),i=await ti.open(n);if(t.signal.aborted)return;await this._showPoster(i),await this._show(i,this.parameters.get("tier"),!0)}catch(n){!t.signal.aborted&&n.name!=="AbortError"&&this._failed(n,"asset")}finally{this.loading===t&&(this.panel.showProgress(null),this.expectAsset(!1))}}async switchTier(e){try{at(null,!1,"asset"),await this._show(this.opened,e,!1)}catch(t){this._failed(t,"asset")}finally{this.panel.showProgress(null)}}async openScene(e){try{let t=JSON.parse(new TextDecoder().decode(await la(e))),{radiance:n,image:i}=t.environment??{};if(n&&(t.environment.key=this.lighting.add("The scene's",ss(n))),i){let r=this.labels[i]??i;t.environment.key=this.lighting.add(r,aa(await la(Hi(i)),i))}return await this.begun,this.applyScene(t),t}catch(t){return this._failed(t,"scene"),null}}async openImage(e,t){try{at(null,!1,"light");let n=e instanceof Blob?await e.arrayBuffer():await la(e);this.lighting.choice=this.lighting.add(this.labels[t]??t,aa(n,t)),this.panel.showLighting(this.lighting),this.changed()}catch(n){this._failed(n,"light")}}changed(e=!1){if(!this.viewer)return;let{lights:t,irradiance:n}=this.lighting.lights();t.some(({kind:i})=>i==="environment")&&this.uploaded!==this.lighting.tables()&&(this.uploaded=this.lighting.tables(),this.engine.setEnvironment(this.uploaded)),this.viewer.lights=t,this.viewer.ground=this._ground(n),this.viewer.restart(e)}resetView(){this.lighting.reset(),this.orbit=this.viewer.orbit=Object.assign(this.orbit,{azimuth:.6,elevation:.35,fov:30}),this.box&&this.orbit.frame(this.box,this.canvas.width/this.canvas.height),this.sceneView&&this.applyScene(this.sceneView),this.panel.showLighting(this.lighting),this.changed()}applyScene({camera:e,suns:t,environment:n,ground:i,exposure:r,view:o}){this.sceneView={camera:e,suns:t,environment:n,ground:i,exposure:r,view:o},e&&this.orbit.lookFrom(e.position,e.look_at,e.vertical_fov_deg),t&&(this.lighting.suns=t),n&&(this.lighting.choice=n.key??this.lighting.choice,this.lighting.strength=n.strength??1,this.lighting.imageTurn=n.rotation_deg??0),i!==void 0&&this.panel.setGround(i),r!==void 0&&this.setExposure(r),o&&!this.parameters.has("view")&&this.setView(o),this.panel.showLighting(this.lighting),this.changed()}setExposure(e){this.viewer&&(this.viewer.exposure=e,this.panel.showExposure(e),this.viewer.show())}setView(e){this.viewer&&(this.viewer.view=e,this.panel.showView(e),this.viewer.ground&&this.changed(),this.viewer.show())}setDenoise(e){this.viewer.denoise=e,this.viewer.show()}resize(){if(!this.viewer)return;let{clientWidth:e,clientHeight:t}=this.places.view,n=Number(this.parameters.get("dpr"))||Math.min(devicePixelRatio,2),i=Math.min(n,Math.sqrt(S_/Math.max(1,e*t))),r=Math.max(1,Math.round(e*i)),o=Math.max(1,Math.round(t*i));this.canvas.width===r&&this.canvas.height===o||(Object.assign(this.canvas,{width:r,height:o}),this.viewer.restart())}get wgsl(){return{compose:es,sharedFiles:jo,rayKernels:ts}}reader(){return this.viewer.pause(),new Zr(this.engine)}screenshot(){return this.viewer.show(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}async _show(e,t,n){let i=await e.load(t);e.forget(),performance.mark("package"),await this.begun,n&&(this.viewer.hasShown=!1),this.viewer.pause();let r=n?Xr(i.parts):this.arrays;performance.mark("hierarchy"),await this.engine.setAsset(r,i.parts),performance.mark("asset"),Object.assign(this,{opened:e,shown:i,arrays:r,box:r.box}),n&&this.orbit.frame(this.box,this.canvas.width/this.canvas.height),n&&this.sceneView&&this.applyScene(this.sceneView),document.body.classList.add("loaded"),this.panel.showPackage(e,i),this.viewer.stats.ms=0,this.changed(),this.viewer.start(),this.viewer.addEventListener("shown",()=>this.panel.showPoster(null),{once:!0})}async _showPoster(e){try{this.panel.showPoster(await e.posterImage())}catch{}}_ground(e){if(!this.panel.hasGround||!this.box)return null;let t=this.viewer.view==="filmic"?Ih(_s):_s,{min:n,max:i}=this.box,r=Math.hypot(...i.map((o,a)=>o-n[a]));return{height:n[1]-1e-4*r,x:(n[0]+i[0])/2,z:(n[2]+i[2])/2,size:2*r,colour:t.map((o,a)=>e[a]>0?o/e[a]/2**this.viewer.exposure:0)}}_actions(){let e=t=>(...n)=>{t(...n),this.viewer.restart(n.at(-1)===!0)};return{orbit:e((t,n)=>this.orbit.turn(t,n)),pan:e((t,n)=>this.orbit.pan(t,n)),zoom:e(t=>this.orbit.zoom(t)),light:(t,n,i)=>{this.lighting.rotation=Sa(this.lighting.rotation+t*180/Math.PI),this.lighting.sunHeight=ba(this.lighting.sunHeight+n*180/Math.PI,-10,90),this.panel.showLighting(this.lighting),this.changed(i===!0)},settle:()=>this.viewer.moving&&this.viewer.restart(),reset:()=>this.resetView()}}_listenForDrops(){let e=document.body;for(let t of["dragenter","dragover"])addEventListener(t,n=>{n.preventDefault(),e.classList.add("dropping")});addEventListener("dragleave",()=>e.classList.remove("dropping")),addEventListener("drop",async t=>{t.preventDefault(),e.classList.remove("dropping");for(let n of[...t.dataTransfer?.files??[]])await this.openFile(n)})}openFile(e){return/\.(hdr|pic|exr)$/i.test(e.name)?this.openImage(e,e.name):this.open(e)}async _recover(e){let{shown:t,arrays:n}=this;at(`${e}; starting again`,!0,"engine"),this.viewer?.stop(),this.uploaded=null;try{let{exposure:i,rounds:r,view:o,denoise:a}=this.viewer;await this.begin(),this.viewer.hasShown=!0,Object.assign(this.viewer,{exposure:i,rounds:r,view:o,denoise:a}),t&&(await this.engine.setAsset(n,t.parts),this.changed(),this.viewer.start()),at(null,!1,"engine")}catch(i){this._failed(i,"engine")}}_failed(e,t="page"){let n=e instanceof fi||e instanceof ee;n||console.error(e),at(n?e.message:`this did not work: ${e.message??e}`,!1,t),this.failures=(this.failures??0)+1}};async function la(s){let e=await fetch(s).catch(()=>null);if(!e?.ok)throw new ee(`cannot load ${s}${e?`: HTTP ${e.status}`:""}`);return e.arrayBuffer()}var M_=5,A_=400;function Ph({bounds:{min:s,max:e}},t){let n=new Float32Array(16*t),i=1,r=()=>(i=Math.imul(i,1664525)+1013904223>>>0)/2**32,o=()=>{let a=2*r()-1,l=2*Math.PI*r(),c=Math.sqrt(1-a*a);return[c*Math.cos(l),c*Math.sin(l),a]};for(let a=0;a<t;a++){let l=s.map((c,u)=>c+r()*(e[u]-c));n.set([...l,0,...o(),0,...o(),0,...o(),0],16*a)}return n}var E_=s=>[...s].sort((e,t)=>e-t)[Math.floor(s.length/2)];async function T_(s,e,t=0){let{evaluate:n}=s.constructor.label==="WebGPU"?Li:Ii,i=1024,r=0;for(;;){let l=Ph(e[t],i),c=performance.now();if(await n(s,t,"transport",l,!1),r=performance.now()-c,r>A_/2||i>=s.bandPixels)break;i*=2}let o=Ph(e[t],i),a=[];for(let l=0;l<M_;l++){let c=performance.now();await n(s,t,"transport",o,!1),a.push(i/(performance.now()-c)/1e3)}return{rate:E_(a),count:i}}function R_({transport:s,planes:e}){let t=s.layers.reduce((i,{rows:r,columns:o})=>i+r*o,0),n=12*e.channels*{float16:2,float32:4,int8:1}[e.precision];return{multiplyAdds:t,bytes:n}}async function C_(s){let e=s.device?.adapterInfo;if(e)return[e.vendor,e.architecture,e.description].filter(Boolean).join(" ");let t=s.gl,n=t?.getExtension("WEBGL_debug_renderer_info");return n?t.getParameter(n.UNMASKED_RENDERER_WEBGL):"unknown"}async function Nh(s){let{viewer:e,engine:t,shown:n,opened:i}=s;if(!n)return;let r=3;e.rounds=r,e.restart(),await e.converged(r);let o=s.canvas.width*s.canvas.height,a=e.stats.ms;e.pause(),await t.done();let{rate:l,count:c}=await T_(t,n.parts),{multiplyAdds:u,bytes:f}=R_(n.parts[0]),d={asset:i.manifest.name,tier:n.name,api:t.constructor.label,gpu:await C_(t),millionQueriesPerSecond:Number(l.toPrecision(3)),queries:c,multiplyAddsPerQuery:u,planeBytesPerQuery:f,picture:`${s.canvas.width} x ${s.canvas.height}`,lights:e.lights.length,msPerSample:Math.round(a),megapixelsPerSecond:Number((o/a/1e3).toPrecision(3)),browser:navigator.userAgent};I_(d),s.viewer.start(),globalThis.rnaBenchmark=d}function I_(s){let e=document.getElementById("bench");e.replaceChildren();for(let[t,n]of[...Object.entries(s),["line to send in",JSON.stringify(s)]]){let i=e.insertRow();i.insertCell().textContent=t,i.insertCell().textContent=String(n)}e.hidden=!1}async function P_(){let{query:s,labels:e}=document.body.dataset,{parameters:t,problems:n}=Th(s,location.search);at(n.join("; "),!0,"address"),document.body.classList.toggle("bare",t.get("ui")==="0");let i=globalThis.rnaViewer=new vs(t,JSON.parse(e??"{}"));i.begin();let r=f=>t.has(f)?Hi(t.get(f)):null,o=r("asset"),a=r("scene"),l=r("env");o&&i.expectAsset();let c=a&&await i.openScene(a);l&&await i.openImage(l,Ss(l));let u=o??(c?.asset&&Hi(c.asset));u&&await i.open(u),t.get("bench")==="1"&&await Nh(i)}P_();})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
